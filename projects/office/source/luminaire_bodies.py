"""Housings of the four luminaire types, in luminaire coordinates: the photometric centre is the origin.

No housing lies in the way of its opening: A, C and D end 5 mm above it; B's frame is as thin as its light guide.
"""
from glb import Thing
from shapes import box, lathe, prism, rounded_rectangle, tube

GAP = 0.005        # from the opening up to the housing


def panel(_above):
    """A: a white tray that fills a 600 x 600 cell of the ceiling grid."""
    return Thing().add("luminaire white", box(-0.298, -0.298, GAP, 0.298, 0.298, GAP + 0.016))


def pendant(above):
    """B: an aluminium frame around the light guide (length along y, = C90), two wires a side, a canopy.

    above  from the opening up to the ceiling [m]
    """
    thing, w, l, half = Thing(), 0.10, 0.77, 0.004
    for side in (-1, 1):
        x = side * (w - 0.0115)
        thing.add("aluminium brushed", box(x - 0.0115, -l, -half, x + 0.0115, l, half))
        y = side * (l - 0.0115)
        thing.add("aluminium brushed", box(-w + 0.02, y - 0.0110, -half + 0.0005, w - 0.02, y + 0.0110, half - 0.0005))
        y = side * 0.55
        for x in (-1, 1):
            thing.add("steel brushed", tube([(x * (w - 0.0115), y, 0.003), (0, y, 0.22)], 0.0009, 4))
        thing.add("steel brushed", tube([(0, y, 0.215), (0, y, above - 0.02)], 0.0011, 4))
        thing.add("luminaire white", lathe([(0, -0.025), (0.028, -0.025), (0.030, -0.023), (0.030, 0.012), (0, 0.012)], 16)
                  .moved(0, y, above))
    return thing


def downlight(_above):
    """C: a trim ring of 230 mm and the can behind it."""
    return Thing().add("luminaire white", lathe([(0, GAP), (0.112, GAP), (0.115, GAP + 0.002), (0.115, GAP + 0.006), (0, GAP + 0.006)], 32))


def washer(_above):
    """D: a square trim of 220 mm."""
    outline = rounded_rectangle(-0.11, -0.11, 0.11, 0.11, 0.008, 2)
    return Thing().add("luminaire white", prism(outline, GAP, GAP + 0.006))


BODIES = {"A": panel, "B": pendant, "C": downlight, "D": washer}
