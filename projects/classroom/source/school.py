"""School furniture: each function returns a Thing that stands at the origin, on z = 0, whose sitter looks to +y."""
import random

from furniture import LIFT, REST
from glb import Thing
from shapes import box, cylinder, joined, rounded_block, thick_sheet, tube

DESK_WIDTH, DESK_DEPTH, DESK_HEIGHT = 1.30, 0.55, 0.76


def pupils_desk():
    """For two: a beech top on two C-shaped legs of round tube, a shelf of wire and hooks for bags.

    The sitters are at -y; y from 0 (sitters) to DESK_DEPTH.
    """
    thing, w, d, h = Thing(), DESK_WIDTH / 2, DESK_DEPTH, DESK_HEIGHT
    thing.add("beech laminate", rounded_block(-w, 0, h - 0.024, w, d, h, 0.025, 0.005, 4, 2))
    for s in (-1, 1):
        x = s * (w - 0.10)
        thing.add("steel powder grey", tube([(x, 0.03, 0.024), (x, d - 0.03, 0.024)], 0.019, 10),
                  tube([(x, d - 0.16, 0.024), (x, d - 0.16, h - 0.06)], 0.021, 12),
                  tube([(x, 0.06, h - 0.045), (x, d - 0.06, h - 0.045)], 0.019, 10),
                  box(x - 0.012, 0.07, h - 0.03, x + 0.012, d - 0.07, h - 0.0235))
        for y in (0.05, d - 0.05):
            thing.add("plastic black", box(x - 0.020, y - 0.03, LIFT, x + 0.020, y + 0.03, 0.016))
        hook = [(s * (w - 0.075), 0.20, h - 0.045), (s * (w - 0.040), 0.20, h - 0.070), (s * (w - 0.030), 0.20, h - 0.055)]
        thing.add("steel powder grey", tube(hook, 0.004, 6))
    thing.add("steel powder grey", tube([(-w + 0.10, d - 0.16, h - 0.13), (w - 0.10, d - 0.16, h - 0.13)], 0.015, 10))
    wires = [tube([(-w + 0.10, 0.12 + 0.055 * k, h - 0.13), (w - 0.10, 0.12 + 0.055 * k, h - 0.13)], 0.004, 6) for k in range(5)]
    return thing.add("steel powder grey", *wires)


def pupils_chair(shell):
    """A plywood seat and back on a frame of bent tube; seat at 0.46 m, the back ends at 0.79 m."""
    def seat(u, v):
        a, y = 1 - 2 * u, -0.19 + 0.39 * v
        front = max(0.0, v - 0.75) * 4
        half = 0.195 + 0.01 * v - 0.02 * abs(2 * v - 1) ** 4
        return (half * a, y, 0.456 + 0.014 * a * a - 0.016 * front * front + 0.012 * (1 - v))

    def back(u, v):
        a = 1 - 2 * u
        half = 0.190 - 0.03 * abs(2 * v - 1) ** 4
        return (half * a, -0.215 + 0.035 * a * a - 0.040 * v, 0.60 + 0.19 * v)

    thing = Thing().add(shell, thick_sheet(lambda u, v: seat(1 - u, v), 8, 8, 0.010).flipped(), thick_sheet(back, 8, 5, 0.010))
    for s in (-1, 1):
        x = s * 0.175
        thing.add("steel powder grey",
                  tube([(x, 0.18, 0.02), (x, 0.15, 0.30), (x, 0.13, 0.424), (x, 0.08, 0.438), (x, -0.16, 0.438), (x, -0.205, 0.455),
                        (x, -0.226, 0.55), (x * 0.98, -0.262, 0.77)], 0.010, 8),
                  tube([(x, -0.05, 0.432), (x, -0.17, 0.20), (x, -0.23, 0.02)], 0.010, 8))
        for y in (0.182, -0.232):
            thing.add("plastic black", cylinder(0.013, LIFT, 0.035, 8).moved(x, y))
    bars = [tube([(-0.175, y, z), (0.175, y, z)], 0.008, 8) for y, z in ((0.10, 0.435), (-0.14, 0.435))]
    return thing.add("steel powder grey", *bars)


def exercise_books(seed):
    """An open book or a closed one, and a pencil case; on z = 0, the reader at -y."""
    thing, dice = Thing(), random.Random(seed)
    if seed % 2:
        pages = joined([box(-0.148, -0.105, REST, -0.001, 0.105, 0.007), box(0.001, -0.105, REST, 0.148, 0.105, 0.007)])
        thing.add("paper white", pages)
    else:
        thing.add(dice.choice(("book red", "book blue", "book green")), rounded_block(-0.105, -0.148, REST, 0.105, 0.148, 0.012, 0.004, 0.002, 2))
    case = rounded_block(-0.10, -0.03, 0, 0.10, 0.03, 0.045, 0.028, 0.018, 3, 2).turned("z", dice.uniform(-25, 25))
    thing.add(dice.choice(("felt ochre", "book blue", "book red", "felt petrol")), case.moved(0.0, 0.19, REST))
    return thing


def school_bag(seed):
    """Leans nowhere: a satchel that stands on z = 0."""
    colour = ("felt petrol", "book red", "felt ochre", "book blue")[seed % 4]
    thing = Thing().add(colour, rounded_block(-0.16, -0.09, LIFT, 0.16, 0.09, 0.38, 0.07, 0.05, 4, 3))
    thing.add(colour, rounded_block(-0.12, 0.08, 0.02, 0.12, 0.125, 0.24, 0.04, 0.02, 3, 2))
    handle = [(-0.05, -0.03, 0.37), (-0.04, -0.03, 0.405), (0.04, -0.03, 0.405), (0.05, -0.03, 0.37)]
    return thing.add("plastic black", tube(handle, 0.008, 6))


def hook_rail(length, hooks):
    """An oak board with hooks; on a wall behind y = 0, faces -y, centred on the origin."""
    thing = Thing().add("oak solid", rounded_block(-length / 2, -0.045, 0, length / 2, 0.045, 0.018, 0.008, 0.004, 2).turned("x", 90)
                        .moved(0, -0.001, 0))
    for k in range(hooks):
        x = -length / 2 + length * (k + 0.5) / hooks
        thing.add("steel powder grey", tube([(x, -0.017, 0.015), (x, -0.06, 0.01), (x, -0.085, 0.05)], 0.006, 6),
                  tube([(x, -0.017, -0.01), (x, -0.04, -0.03), (x, -0.055, -0.015)], 0.006, 6))
    return thing
