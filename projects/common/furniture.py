"""The furniture: each function returns a Thing that stands at the origin, on z = 0, facing +y.

Feet stand 1 mm above the floor and things on a desk 0.5 mm above its top, so that no two faces share a plane.
Dimensions are those of common European office furniture (projects/office/README.md).
"""
import math
import random

from glb import Thing
from shapes import (Surface, box, circle, cylinder, joined, lathe, loft, prism,
                    quad, rounded_block, rounded_rectangle, tube)

DESK_HEIGHT = 0.74
LIFT = 0.001          # of feet above the floor
REST = 0.0005         # of things above what they stand on


def desk(width=1.6, depth=0.8):
    """A user sits at -y and looks towards +y. The top is centred on the origin in x; y from 0 (user) to depth."""
    thing = Thing()
    w = width / 2
    thing.add("oak laminate", rounded_block(-w + 0.004, 0.0, DESK_HEIGHT - 0.025, w - 0.004, depth - 0.03, DESK_HEIGHT,
                                            0.02, 0.004))
    for x in (-w + 0.09, w - 0.09):
        thing.add("steel powder white",
                  box(x - 0.03, 0.06, LIFT, x + 0.03, depth - 0.08, 0.022),
                  rounded_block(x - 0.035, depth / 2 - 0.075, 0.02, x + 0.035, depth / 2 + 0.025, DESK_HEIGHT - 0.05,
                                0.015, 0.003, 1),
                  box(x - 0.028, 0.08, DESK_HEIGHT - 0.052, x + 0.028, depth - 0.10, DESK_HEIGHT - 0.0245))
    thing.add("steel powder white", box(-w + 0.11, depth / 2 - 0.05, DESK_HEIGHT - 0.075, w - 0.11, depth / 2,
                                        DESK_HEIGHT - 0.035))
    tray = [(-w + 0.25, depth - 0.22), (w - 0.25, depth - 0.22), (w - 0.25, depth - 0.10), (-w + 0.25, depth - 0.10)]
    thing.add("steel powder white", prism(tray, DESK_HEIGHT - 0.14, DESK_HEIGHT - 0.13))
    for x in (-w + 0.249, w - 0.252):
        thing.add("steel powder white", box(x, depth - 0.219, DESK_HEIGHT - 0.135, x + 0.003, depth - 0.101,
                                            DESK_HEIGHT - 0.0248))
    return thing


def pedestal():
    """Three drawers on castors, 0.42 x 0.56 x 0.56; the drawers open towards -y."""
    thing = Thing()
    thing.add("steel powder white", rounded_block(-0.21, -0.28, 0.055, 0.21, 0.28, 0.56, 0.012, 0.004, 2))
    z = 0.07
    for height in (0.24, 0.115, 0.115):
        thing.add("steel powder white", box(-0.203, -0.297, z, 0.203, -0.279, z + height - 0.005))
        thing.add("plastic black", box(-0.06, -0.3005, z + height - 0.03, 0.06, -0.2965, z + height - 0.016))
        z += height
    for x in (-0.16, 0.16):
        for y in (-0.22, 0.22):
            thing.add("plastic black", cylinder(0.025, 0, 0.03, 7).turned("y", 90).moved(x - 0.015, y, 0.026))
            thing.add("plastic black", box(x - 0.012, y - 0.012, 0.03, x + 0.012, y + 0.012, 0.057))
    return thing


def divider(length, colour):
    """A felt screen along x on a desk edge, its lower edge below the desk top."""
    thing = Thing()
    height = 0.40
    thing.add(colour, rounded_block(0.01, -0.014, 0, length - 0.01, 0.014, height, 0.013, 0.006, 3))
    outline = rounded_rectangle(0.02, -0.008, length - 0.02, 0.008, 0.006, 2)
    thing.add("steel powder white", prism(outline, -0.12, 0.01))
    return thing


def monitor(inches=24):
    """A flat panel on a foot; the picture faces -y. The foot's centre is the origin."""
    w, h = inches * 0.02214 / 2, inches * 0.01245
    thing, low = Thing(), 0.115
    bezel = rounded_block(-w - 0.008, -(low + h + 0.012), 0, w + 0.008, -(low - 0.012), 0.030, 0.012, 0.006, 2, 1)
    thing.add("plastic black", bezel.turned("x", -90).moved(0, -0.012, 0))
    thing.add("screen glass", quad((-w, -0.0126, low), (w, -0.0126, low), (w, -0.0126, low + h), (-w, -0.0126, low + h)))
    thing.add("aluminium brushed",
              rounded_block(-0.125, -0.05, REST, 0.125, 0.13, 0.008, 0.02, 0.002, 2),
              rounded_block(-0.028, 0.045, 0.006, 0.028, 0.062, low + h * 0.62, 0.007, 0.002, 1),
              cylinder(0.022, 0, 0.04, 12).turned("x", -90).moved(0, 0.015, low + h * 0.5))
    return thing


def keyboard_and_mouse():
    """At the origin, the user at -y."""
    thing = Thing()
    slope = lambda s: s.turned("x", 2.0)
    thing.add("aluminium brushed", slope(rounded_block(-0.215, -0.065, REST + 0.003, 0.215, 0.065, 0.013, 0.008, 0.003, 2)))
    for row in range(4):
        y = -0.054 + row * 0.028
        if row == 0:
            spans = [(-0.205 + i * 0.052, 0.048) for i in range(2)] + [(-0.101, 0.202)] + \
                    [(0.105 + i * 0.052, 0.048) for i in range(2)]
        else:
            spans = [(-0.205 + i * 0.0412, 0.0372) for i in range(10)]
        for x, width in spans:
            thing.add("plastic white", slope(_key(x, y, x + width, y + 0.0245, 0.0128, 0.0165)))
    body = [[(0.031 * math.sin(a) * fx + 0.33, 0.055 * -math.cos(a) * fx - 0.005, z)
             for a in (2 * math.pi * i / 12 for i in range(12))]
            for fx, z in ((0.88, REST), (1.0, 0.010), (0.92, 0.022), (0.6, 0.032), (0.15, 0.035))]
    thing.add("plastic white", loft(body))
    return thing


def _key(x0, y0, x1, y1, z0, z1):
    """A key cap without a bottom: its foot is sunk in the board."""
    b = 0.002
    low = [(x0, y0, z0), (x1, y0, z0), (x1, y1, z0), (x0, y1, z0)]
    high = [(x0 + b, y0 + b, z1), (x1 - b, y0 + b, z1), (x1 - b, y1 - b, z1), (x0 + b, y1 - b, z1)]
    return loft([low, high], caps=False) + quad(*high)


def meeting_table(length=2.4, width=1.15):
    """A boat-shaped top on two panel feet, along x; 0.74 high."""
    thing = Thing()

    def outline(inset):
        points = []
        for side in (1, -1):
            for i in range(17):
                t = side * (1 - 2 * i / 16)
                x = t * (length / 2 - inset)
                points.append((x, side * ((width / 2 - 0.12 * t * t) - inset)))
        return points

    rings = [[(x, y, z) for x, y in outline(inset)] for inset, z in ((0.022, 0.712), (0.003, 0.732), (0.0, 0.737), (0.003, 0.740))]
    thing.add("oak solid", loft(rings))
    for x in (-0.72, 0.72):
        thing.add("steel powder black", rounded_block(x - 0.03, -0.30, LIFT, x + 0.03, 0.30, 0.03, 0.02, 0.006, 3),
                  rounded_block(x - 0.022, -0.20, 0.028, x + 0.022, 0.20, 0.715, 0.02, 0.004, 3))
    thing.add("steel powder black", box(-0.71, -0.02, 0.64, 0.71, 0.02, 0.70))
    thing.add("aluminium brushed", rounded_block(-0.15, -0.06, 0.7395, 0.15, 0.06, 0.7425, 0.01, 0.001, 3))
    return thing


def bookcase(width, height, shelves, seed, back=True):
    """An open case with books and boxes, its front at -y, its back at y = 0; depth 0.36."""
    thing, dice, depth, board = Thing(), random.Random(seed), 0.36, 0.022
    w = width / 2
    for x in (-w, w - board):
        thing.add("oak laminate", box(x, -depth, LIFT, x + board, 0.0, height + 0.0006))
    for k in range(shelves + 1):
        z = 0.06 + (height - 0.06 - board) * k / shelves
        thing.add("oak laminate", box(-w + board - 0.001, -depth + 0.004, z, w - board + 0.001, -0.004, z + board))
    thing.add("oak laminate", box(-w + board - 0.002, -depth + 0.03, 0.004, w - board + 0.002, -depth + 0.045, 0.0605))
    if back:
        thing.add("oak laminate", box(-w + 0.01, -0.014, 0.062, w - 0.01, -0.006, height - 0.004))
    for k in range(shelves):
        z = 0.06 + (height - 0.06 - board) * k / shelves + board
        room = (height - 0.06 - board) / shelves - board
        _fill_shelf(thing, dice, -w + board + 0.01, w - board - 0.01, -depth + 0.03, z + REST, room)
    return thing


BOOK_COLOURS = ("paper cream", "book red", "book blue", "book green", "book ochre", "plastic black", "plastic white")


def _fill_shelf(thing, dice, x0, x1, y, z, room):
    x = x0
    while x < x1 - 0.09:
        kind = dice.random()
        if kind < 0.16:
            x += dice.uniform(0.10, 0.28)
        elif kind < 0.30 and x < x1 - 0.36:
            side = min(0.24, room - 0.03)
            thing.add(dice.choice(("felt grey", "paper cream")),
                      box(x, y, z, x + 0.32, y + 0.28, z + side))
            x += 0.345
        else:
            for _ in range(dice.randint(2, 6)):
                thick, tall, deep = dice.uniform(0.026, 0.070), dice.uniform(0.62, 0.92) * min(room, 0.34), dice.uniform(0.17, 0.25)
                if x + thick > x1:
                    return
                thing.add(dice.choice(BOOK_COLOURS), box(x, y, z, x + thick - 0.0012, y + deep, z + tall))
                x += thick
            x += 0.006


def coffee_table(radius):
    thing = Thing()
    thing.add("oak solid", lathe([(0, 0.375), (radius - 0.012, 0.375), (radius, 0.39), (radius, 0.398),
                                  (radius - 0.004, 0.40), (0, 0.40)], 40))
    for k in range(3):
        a = 2 * math.pi * k / 3 + 0.4
        c, s = math.cos(a), math.sin(a)
        foot, head = (c * radius * 0.92, s * radius * 0.92, LIFT), (c * radius * 0.5, s * radius * 0.5, 0.377)
        thing.add("steel powder black", tube([foot, head], 0.012, 8))
    return thing


def mug(colour):
    profile = [(0, REST), (0.037, REST), (0.041, 0.006), (0.041, 0.092), (0.037, 0.091), (0.036, 0.06)]
    handle = [(0.039, 0, 0.076), (0.060, 0, 0.074), (0.069, 0, 0.052), (0.060, 0, 0.028), (0.038, 0, 0.024)]
    thing = Thing().add(colour, lathe(profile, 12), tube(handle, 0.0055, 4))
    return thing.add("coffee", prism([p[:2] for p in circle(0.0366, 0, 12)], 0.06, 0.078))


def waste_bin():
    return Thing().add("plastic black", lathe([(0, LIFT), (0.125, LIFT), (0.128, 0.01), (0.155, 0.34), (0.160, 0.345), (0.157, 0.35),
                                               (0.150, 0.345), (0.124, 0.012), (0, 0.010)], 20))


def papers(seed):
    """A loose pile of sheets and a pen."""
    thing, dice = Thing(), random.Random(seed)
    for k in range(3):
        sheet = box(-0.105, -0.1485, 0, 0.105, 0.1485, 0.0028)
        thing.add("paper white", sheet.turned("z", dice.uniform(-9, 9)).moved(dice.uniform(-.01, .01), 0, REST + 0.0031 * k))
    pen = cylinder(0.0045, 0, 0.14, 8).turned("y", 90).turned("z", 35)
    return thing.add("book blue", pen.moved(-0.05, -0.03, 0.0145))


def notebook():
    return Thing().add("plastic black", rounded_block(-0.074, -0.105, REST, 0.074, 0.105, 0.016, 0.008, 0.003, 2))


def laptop():
    """Open at 110 degrees, the user at -y."""
    thing = Thing()
    thing.add("aluminium brushed", rounded_block(-0.157, -0.11, REST, 0.157, 0.11, 0.016, 0.012, 0.004, 3))
    thing.add("plastic black", box(-0.135, -0.015, 0.0155, 0.135, 0.085, 0.0168))
    lid = rounded_block(-0.157, 0, 0, 0.157, 0.215, 0.008, 0.012, 0.003, 3)
    screen = quad((-0.148, 0.012, 0.0086), (0.148, 0.012, 0.0086), (0.148, 0.205, 0.0086), (-0.148, 0.205, 0.0086))
    stand = lambda s: s.turned("x", 70).moved(0, 0.112, 0.012)
    return thing.add("aluminium brushed", stand(lid)).add("screen glass", stand(screen))


def floor_lamp_off():
    """An unlit reading lamp in the lounge."""
    thing = Thing()
    thing.add("steel powder black", lathe([(0, LIFT), (0.15, LIFT), (0.15, 0.012), (0.012, 0.022), (0.012, 1.52), (0, 1.52)], 24))
    return thing.add("lampshade linen", _open_shade(0.20, 0.15, 1.36, 1.66))


def _open_shade(low_radius, high_radius, z0, z1):
    return lathe([(low_radius - 0.003, z0), (low_radius, z0), (high_radius, z1), (high_radius - 0.003, z1), (low_radius - 0.003, z0)], 32)


def credenza(width):
    """A low closed cabinet with doors towards -y, back at y = 0: 0.42 deep, 1.05 high."""
    thing, w = Thing(), width / 2
    thing.add("steel powder black", box(-w + 0.03, -0.39, LIFT, w - 0.03, -0.03, 0.07))
    thing.add("wall cabinet white", box(-w, -0.42, 0.068, w, -0.002, 1.03))
    thing.add("oak laminate", rounded_block(-w - 0.004, -0.44, 1.0295, w + 0.004, -0.001, 1.055, 0.008, 0.003, 2))
    doors = round(width / 0.6)
    for k in range(doors):
        x0, x1 = -w + width * k / doors + 0.002, -w + width * (k + 1) / doors - 0.002
        thing.add("wall cabinet white", rounded_block(x0, -0.439, 0.072, x1, -0.419, 1.026, 0.004, 0.002, 1))
        hx = x1 - 0.05 if k % 2 == 0 else x0 + 0.05
        thing.add("steel powder black", cylinder(0.006, 0.80, 0.96, 8).moved(hx, -0.452))
        for z in (0.81, 0.95):
            thing.add("steel powder black", cylinder(0.004, 0, 0.016, 6).turned("x", 90).moved(hx, -0.437, z))
    return thing


def coat_stand():
    thing = Thing()
    thing.add("steel powder black", lathe([(0, LIFT), (0.17, LIFT), (0.17, 0.012), (0.016, 0.024), (0.016, 1.72), (0, 1.74)], 20))
    for k in range(6):
        hook = [(0.01, 0, 1.60), (0.10, 0, 1.62), (0.13, 0, 1.68)]
        thing.add("steel powder black", tube(hook, 0.009, 6).turned("z", 60 * k))
    return thing


def picture(width, height, colours, seed):
    """A framed abstract print; hangs on a wall behind y = 0 and faces -y. Its lower edge is z = 0."""
    thing, w, f, dice = Thing(), width / 2, 0.018, random.Random(seed)
    bars = [box(-w, -0.03, 0, w, -0.003, f), box(-w, -0.03, height - f, w, -0.003, height),
            box(-w + 0.0005, -0.0295, f - 0.001, -w + f, -0.0034, height - f + 0.001),
            box(w - f, -0.0295, f - 0.001, w - 0.0005, -0.0034, height - f + 0.001)]
    thing.add("steel powder black", joined(bars))
    thing.add("paper white", box(-w + 0.01, -0.014, 0.01, w - 0.01, -0.0035, height - 0.01))
    layer = -0.0145
    for colour in colours:
        radius = dice.uniform(0.16, 0.30) * min(width, height)
        cx, cz = dice.uniform(-w + 0.06 + radius, w - 0.06 - radius), dice.uniform(0.06 + radius, height - 0.06 - radius)
        half = dice.random() < 0.5
        steps, tilt = 28, dice.uniform(0, 6.28)
        ring = [(cx + radius * math.cos(tilt + (math.pi if half else 2 * math.pi) * i / steps), layer,
                 cz + radius * math.sin(tilt + (math.pi if half else 2 * math.pi) * i / steps)) for i in range(steps + 1)]
        thing.add(colour, Surface([(cx, layer, cz)] + ring, [(0, i, i + 1) for i in range(1, steps + 1)]))
        layer -= 0.0006
    return thing
