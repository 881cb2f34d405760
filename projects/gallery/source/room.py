"""The gallery itself: a closed shell, a partition, a door, tracks, skirting, a polished floor.

Parts that meet go a few millimetres into one another instead of sharing a plane, so nothing flickers or leaks.
"""
from glb import Thing
from shapes import box, cylinder, lathe, panel_with_holes, quad, rounded_block, tube

LENGTH, WIDTH, CEILING = 12.0, 7.5, 3.9      # inner dimensions [m]
DOOR = (9.9, 11.3, 2.40)                     # x0, x1, top of the opening in the wall y = 0
PARTITION = (8.30, 8.60, 2.10, 5.20, 2.90)   # x0, x1, y0, y1, height
TRACK = 3.72                                 # underside of the tracks
TRACKS = [("y", 6.27, 0.5, 11.5), ("y", 1.23, 0.5, 9.4), ("x", 1.35, 1.6, 5.9), ("y", 3.00, 1.8, 7.7), ("x", 7.10, 4.2, 5.75)]


def shell(place):
    low, high = -0.10, 4.0
    south = panel_with_holes((-0.2, LENGTH + 0.2), (low, high), [(LENGTH - DOOR[1], -0.05, LENGTH - DOOR[0], DOOR[2])],
                             lambda u, v, w: (LENGTH - u, w, v), 0.20)
    place("Wall south", Thing().add("wall paint white", south))
    place("Wall north (blue)", Thing().add("wall paint blue", box(-0.2, WIDTH, low, LENGTH + 0.2, WIDTH + 0.2, high)))
    place("Wall west (terracotta)", Thing().add("wall paint terracotta", box(-0.2, -0.01, low + 0.002, 0.0, WIDTH + 0.01, high - 0.002)))
    place("Wall east", Thing().add("wall paint white", box(LENGTH, -0.01, low + 0.002, LENGTH + 0.2, WIDTH + 0.01, high - 0.002)))
    place("Floor slab", Thing().add("concrete", box(-0.3, -0.3, -0.25, LENGTH + 0.3, WIDTH + 0.3, -0.02)))
    place("Ceiling", Thing().add("ceiling paint grey", box(-0.3, -0.3, CEILING, LENGTH + 0.3, WIDTH + 0.3, 4.15)))
    place("Floor", Thing().add("floor polished", quad((0, 0, 0), (LENGTH, 0, 0), (LENGTH, WIDTH, 0), (0, WIDTH, 0))))


def skirting(place):
    """A recessed-looking shadow line: a dark strip 60 mm high at the foot of all walls."""
    t, top, d = 0.008, 0.06, DOOR
    runs = [box(-0.004, -0.005, -0.015, d[0] - 0.045, t, top), box(d[1] + 0.045, -0.005, -0.0151, LENGTH + 0.004, t, top),
            box(-0.004, WIDTH - t, -0.0152, LENGTH + 0.004, WIDTH + 0.005, top), box(-0.005, -0.008, -0.014, t, WIDTH + 0.008, top - 0.0005),
            box(LENGTH - t, -0.008, -0.0142, LENGTH + 0.005, WIDTH + 0.008, top - 0.0005)]
    x0, x1, y0, y1, _ = PARTITION
    runs.append(box(x0 - t, y0 - t, -0.016, x1 + t, y1 + t, top - 0.001))
    place("Skirting", Thing().add("steel powder black", *runs))


def partition(place):
    x0, x1, y0, y1, height = PARTITION
    place("Partition", Thing().add("wall paint white", rounded_block(x0, y0, -0.018, x1, y1, height, 0.006, 0.003, 2, 1)))


def door(place):
    """Two flush leaves in a black frame with bar handles; the exit sign above; a socket and a switch beside."""
    x0, x1, top = DOOR
    middle = (x0 + x1) / 2
    place("Door frame", Thing().add("steel powder black", box(x0 - 0.05, -0.21, -0.012, x0 + 0.03, 0.02, top + 0.05),
                                    box(x1 - 0.03, -0.21, -0.012, x1 + 0.05, 0.02, top + 0.05),
                                    box(x0 - 0.045, -0.209, top - 0.03, x1 + 0.045, 0.019, top + 0.049),
                                    box(x0 + 0.01, -0.205, -0.013, x1 - 0.01, 0.005, 0.006)))
    for k, (a, b, handle) in enumerate(((x0 + 0.024, middle - 0.002, middle - 0.07), (middle + 0.002, x1 - 0.024, middle + 0.07))):
        leaf = Thing().add("oak solid", box(a, -0.056, 0.008, b, -0.010, top - 0.024))
        leaf.add("bronze", tube([(handle, 0.042, 0.80), (handle, 0.042, 1.40)], 0.011, 12),
                 *(tube([(handle, -0.012, z), (handle, 0.044, z)], 0.008, 8) for z in (0.88, 1.32)))
        place(f"Door leaf {k + 1}", leaf)
    z = 2.66
    sign = Thing().add("plastic white", box(middle - 0.17, -0.003, z - 0.095, middle + 0.17, 0.035, z + 0.095))
    place("Exit sign", sign.add("exit sign green", quad((middle + 0.16, 0.0358, z - 0.085), (middle - 0.16, 0.0358, z - 0.085),
                                                        (middle - 0.16, 0.0358, z + 0.085), (middle + 0.16, 0.0358, z + 0.085))))
    for name, x, zs in (("Light switch", x0 - 0.22, 1.05), ("Socket", x0 - 0.22, 0.30)):
        cover = rounded_block(-0.04, -0.04, 0, 0.04, 0.04, 0.011, 0.006, 0.003, 3)
        place(name, Thing().add("plastic white", cover.turned("x", -90).moved(x, -0.001, zs)))


def tracks(place):
    """Three-phase tracks on thin rods."""
    for k, (axis, at, low, high) in enumerate(TRACKS):
        thing = Thing()
        across = lambda a, z0, b, z1, w: (box(a, at - w, z0, b, at + w, z1) if axis == "y" else box(at - w, a, z0, at + w, b, z1))
        thing.add("steel powder black", across(low, TRACK, high, TRACK + 0.034, 0.018))
        count = 3 if high - low > 3 else 2
        for i in range(count):
            s = low + 0.25 + (high - low - 0.5) * i / (count - 1)
            x, y = (s, at) if axis == "y" else (at, s)
            thing.add("steel powder black", cylinder(0.004, TRACK + 0.03, CEILING + 0.01, 8).moved(x, y))
            thing.add("steel powder black", lathe([(0, CEILING - 0.012), (0.025, CEILING - 0.012), (0.027, CEILING - 0.010),
                                                   (0.027, CEILING + 0.005), (0, CEILING + 0.005)], 16).moved(x, y))
        place(f"Track {k + 1}", thing)
