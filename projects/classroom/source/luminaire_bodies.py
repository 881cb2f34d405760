"""Housings of the classroom's luminaires, in luminaire coordinates: the photometric centre is the origin.

No housing lies in the way of its opening.
"""
from glb import Thing
from shapes import box, lathe, tube


def pendant(above):
    """A: an aluminium frame around the light guide (length along y, = C90), two wires, canopies.

    above  from the opening up to the ceiling [m]
    """
    thing, w, l, half = Thing(), 0.060, 0.610, 0.006
    for side in (-1, 1):
        x = side * (w - 0.0065)
        thing.add("aluminium brushed", box(x - 0.0065, -l, -half, x + 0.0065, l, half))
        y = side * (l - 0.0085)
        thing.add("aluminium brushed", box(-w + 0.0125, y - 0.0080, -half + 0.0005, w - 0.0125, y + 0.0080, half - 0.0005))
        y = side * 0.44
        for x in (-1, 1):
            thing.add("steel brushed", tube([(x * (w - 0.0065), y, 0.005), (0, y, 0.12)], 0.0010, 4))
        thing.add("steel brushed", tube([(0, y, 0.117), (0, y, above - 0.02)], 0.0012, 4))
        thing.add("luminaire white", lathe([(0, -0.022), (0.026, -0.022), (0.028, -0.020), (0.028, 0.012), (0, 0.012)], 16)
                  .moved(0, y, above))
    return thing


def washer(above):
    """B: a slim channel (length along x, = C0) on two arms; its opening faces down, 5 mm below the channel."""
    thing = Thing().add("luminaire white", box(-0.60, -0.045, 0.005, 0.60, 0.045, 0.055))
    for x in (-0.42, 0.42):
        thing.add("steel brushed", tube([(x, 0, 0.054), (x, 0, above + 0.01)], 0.008, 8))
        thing.add("luminaire white", lathe([(0, -0.014), (0.03, -0.014), (0.032, -0.012), (0.032, 0.01), (0, 0.01)], 16)
                  .moved(x, 0, above))
    return thing


BODIES = {"A": pendant, "B": washer}
