"""The classroom itself: a closed shell of walls with thickness, window bays, door, ceiling, floor, boards, radiators.

Parts that meet go a few millimetres into one another instead of sharing a plane, so nothing flickers or leaks.
"""
import math
import random

from glb import Thing
import rooms
from shapes import box, cylinder, joined, lathe, loft, panel_with_holes, quad, rounded_block, tube

LENGTH, WIDTH, CEILING = 9.0, 7.2, 3.0       # inner dimensions [m]; x away from the board, y from the windows to the door
TILE = 0.6
SILL, HEAD = 0.85, 2.78
BAYS = [(0.75, 2.50), (2.80, 4.55), (4.85, 6.60), (6.90, 8.65)]   # x0, x1 of the windows in the wall y = 0
WALL = 0.36                                   # thickness of the window wall
DOOR = (7.45, 8.45, 2.10)                     # x0, x1, top of the opening in the wall y = WIDTH
BOARD = (1.60, 5.60, 0.90, 2.10)              # y0, y1, z0, z1 with both wings open, on the wall x = 0


def shell(place):
    low, high = -0.10, 3.09
    holes = [(LENGTH - x1, SILL, LENGTH - x0, HEAD) for x0, x1 in BAYS]
    south = panel_with_holes((-0.3, LENGTH + 0.3), (low, high), holes, lambda u, v, w: (LENGTH - u, w, v), WALL)
    place("Wall south (windows)", Thing().add("wall paint white", south))
    north = panel_with_holes((-0.3, LENGTH + 0.3), (low, high), [(DOOR[0], -0.05, DOOR[1], DOOR[2])],
                             lambda u, v, w: (u, WIDTH - w, v), 0.15)
    place("Wall north", Thing().add("wall paint white", north))
    place("Wall west (board)", Thing().add("wall paint white", box(-0.2, -0.01, low + 0.002, 0.0, WIDTH + 0.01, high - 0.002)))
    place("Wall east (back)", Thing().add("wall paint yellow", box(LENGTH, -0.01, low + 0.002, LENGTH + 0.2, WIDTH + 0.01, high - 0.002)))
    place("Floor slab", Thing().add("concrete", box(-0.3, -WALL - 0.05, -0.25, LENGTH + 0.3, WIDTH + 0.3, -0.02)))
    place("Ceiling slab", Thing().add("concrete", box(-0.3, -WALL - 0.05, 3.02, LENGTH + 0.3, WIDTH + 0.3, 3.25)))


def ceiling_tiles(place):
    """Acoustic tiles with a 6 mm bevel in a visible grid, 8 mm below it."""
    place("Ceiling grid", Thing().add("ceiling grid white", box(-0.005, -0.005, CEILING + 0.008, LENGTH + 0.005, WIDTH + 0.005, 3.021)))
    tiles = rooms.ceiling_tiles(LENGTH, WIDTH, CEILING, TILE)
    place("Ceiling tiles", tiles)


def floor(place):
    """Linoleum in sheets of 1.8 m along the room, two tones by turns."""
    lino = Thing()
    for k in range(4):
        y0, y1 = 1.8 * k, 1.8 * (k + 1)
        lino.add(("linoleum blue", "linoleum blue light")[k % 2],
                 quad((0, y0, 0), (LENGTH, y0, 0), (LENGTH, y1, 0), (0, y1, 0)))
    place("Linoleum", lino)
    thick, top = 0.015, 0.07
    runs = rooms.skirting(LENGTH, WIDTH, (DOOR[0], DOOR[1]), thick, top)
    place("Skirting", Thing().add("oak solid", *runs))


def windows(place):
    """Four bays: frame, mullion, transom, thin panes, a roller blind each, stone sill, radiator below.

    The blinds are drawn as far as it takes to keep the sun of project.toml's [sky] off the blackboard.
    """
    transom, y0, y1, drawn = 2.20, -0.27, -0.19, (0.93, 0.93, 1.90, 2.42)
    for k, (x0, x1) in enumerate(BAYS):
        middle, frame, white = (x0 + x1) / 2, Thing(), "steel powder white"
        frame.add(white, box(x0 - 0.005, y0, SILL - 0.005, x1 + 0.005, y1, SILL + 0.06),
                  box(x0 - 0.005, y0, HEAD - 0.06, x1 + 0.005, y1, HEAD + 0.005),
                  box(x0 - 0.004, y0 + 0.002, SILL + 0.001, x0 + 0.06, y1 - 0.002, HEAD - 0.001),
                  box(x1 - 0.06, y0 + 0.002, SILL + 0.001, x1 + 0.004, y1 - 0.002, HEAD - 0.001),
                  box(middle - 0.045, y0 + 0.003, SILL + 0.002, middle + 0.045, y1 - 0.003, HEAD - 0.002),
                  box(x0 + 0.001, y0 + 0.004, transom - 0.04, x1 - 0.001, y1 - 0.004, transom + 0.04))
        for x in (middle - 0.02, x1 - 0.03):
            frame.add("steel brushed", rounded_block(x - 0.008, y1 - 0.002, 1.42, x + 0.008, y1 + 0.03, 1.56, 0.007, 0.003, 2))
        place(f"Window frame {k + 1}", frame)
        pane, y = Thing(), -0.23
        for a, b in ((x0 + 0.05, middle - 0.035), (middle + 0.035, x1 - 0.05)):
            for low, high in ((SILL + 0.05, transom - 0.03), (transom + 0.03, HEAD - 0.05)):
                pane.add("window glass", quad((b, y, low), (a, y, low), (a, y, high), (b, y, high)))
        place(f"Window pane {k + 1}", pane)
        place(f"Blind {k + 1}", _blind(x0 + 0.015, x1 - 0.015, drawn[k]))
        place(f"Window sill {k + 1}", Thing().add("sill stone", rounded_block(
            x0 - 0.02, -0.195, SILL - 0.012, x1 + 0.02, 0.05, SILL + 0.016, 0.008, 0.004, 2, 2)))
        place(f"Radiator {k + 1}", rooms.radiator(x0 + 0.1, x1 - 0.1, 0.68, 22))


def _blind(x0, x1, bottom):
    """A translucent roller blind between the cheeks of a bay: one sheet, as `trans` has it."""
    y = -0.10
    cloth = quad((x1 - 0.012, y, bottom), (x0 + 0.012, y, bottom), (x0 + 0.012, y, HEAD - 0.045), (x1 - 0.012, y, HEAD - 0.045))
    thing = Thing().add("blind translucent", cloth)
    thing.add("aluminium brushed", cylinder(0.026, x0 + 0.004, x1 - 0.004, 16).turned("y", 90).moved(0, y - 0.026, HEAD - 0.04),
              cylinder(0.009, x0 + 0.010, x1 - 0.010, 8).turned("y", 90).moved(0, y, bottom))
    return thing


def entrance(place):
    """A door at the back in a steel frame, with a lever; a double switch and a socket beside it."""
    x0, x1, top = DOOR
    rooms.door(place, WIDTH, x0, x1, top, "steel powder grey", "door petrol", -1)
    for name, x, z in (("Light switch 1", x0 - 0.22, 1.05), ("Light switch 2", x0 - 0.302, 1.05), ("Socket 1", x0 - 0.22, 0.30),
                       ("Socket 2", 0.60, 0.30)):
        cover = rounded_block(-0.04, -0.04, 0, 0.04, 0.04, 0.011, 0.006, 0.003, 3)
        face = cylinder(0.021, 0.009, 0.0125, 16) if name.startswith("Socket") else rounded_block(-0.03, -0.03, 0.009, 0.03, 0.03, 0.014, 0.004, 0.002, 2)
        thing = Thing().add("plastic white", cover.turned("x", 90).moved(x, WIDTH + 0.001, z))
        place(name, thing.add("plastic grey" if name.startswith("Socket") else "plastic white", face.turned("x", 90).moved(x, WIDTH + 0.001, z)))


def blackboard(place):
    """A middle panel of 2 m and two open wings of 1 m in green enamel, a tray, chalk, a sponge, a drawing."""
    y0, y1, z0, z1 = BOARD
    quarter = (y1 - y0) / 4
    for k, (a, b) in enumerate(((y0, y0 + quarter), (y0 + quarter, y1 - quarter), (y1 - quarter, y1))):
        a, b = a + 0.003, b - 0.003
        thing = Thing().add("blackboard enamel", box(0.026, a + 0.012, z0 + 0.012, 0.040, b - 0.012, z1 - 0.012))
        thing.add("aluminium anodised", box(0.024, a, z0, 0.044, a + 0.014, z1), box(0.024, b - 0.014, z0, 0.044, b, z1),
                  box(0.0245, a + 0.001, z0 + 0.0005, 0.0435, b - 0.001, z0 + 0.014),
                  box(0.0245, a + 0.001, z1 - 0.014, 0.0435, b - 0.001, z1 - 0.0005))
        place(f"Blackboard panel {k + 1}", thing)
    rails = Thing()
    for y in (y0 + 0.4, y0 + quarter + 0.3, y1 - quarter - 0.3, y1 - 0.4):
        rails.add("aluminium anodised", box(-0.003, y - 0.03, 0.55, 0.025, y + 0.03, 2.35))
    place("Blackboard rails", rails)
    m0, m1 = y0 + quarter + 0.02, y1 - quarter - 0.02
    tray = joined([box(0.030, m0, z0 - 0.032, 0.115, m1, z0 - 0.026), box(0.109, m0 + 0.001, z0 - 0.0265, 0.1145, m1 - 0.001, z0 - 0.014)])
    things = Thing().add("aluminium anodised", tray)
    for k, colour in enumerate(("chalk white", "chalk white", "chalk yellow", "chalk white", "chalk red")):
        stick = cylinder(0.006, 0, 0.075, 10).turned("x", -90)
        things.add(colour, stick.moved(0.058 + 0.012 * (k % 2), m0 + 0.10 + 0.13 * k, z0 - 0.0195))
    things.add("sponge yellow", rounded_block(0.045, m1 - 0.24, z0 - 0.0255, 0.100, m1 - 0.10, z0 + 0.03, 0.012, 0.006, 3, 2))
    place("Chalk tray", things)
    _drawing(place)


def _stroke(points, width=0.009):
    """A chalk line through (y, z) points on the middle panel, 0.4 mm in front of the enamel."""
    x, sheets = 0.0404, []
    for (a, b), (c, d) in zip(points, points[1:]):
        length = math.hypot(c - a, d - b)
        ny, nz = -(d - b) / length * width / 2, (c - a) / length * width / 2
        sheets.append(quad((x, a - ny, b - nz), (x, c - ny, d - nz), (x, c + ny, d + nz), (x, a + ny, b + nz)))
    return joined(sheets)


def _drawing(place):
    """Thales' theorem: a semicircle over its diameter and triangles in it. y grows to a pupil's right."""
    cy, cz, r = 3.75, 1.22, 0.62
    arc = [(cy + r * math.cos(math.pi * i / 36), cz + r * math.sin(math.pi * i / 36)) for i in range(37)]
    thing = Thing().add("chalk white", _stroke(arc), _stroke([(cy - r - 0.12, cz), (cy + r + 0.12, cz)]))
    for degrees, colour in ((118, "chalk yellow"), (58, "chalk red")):
        top = (cy + r * math.cos(math.radians(degrees)), cz + r * math.sin(math.radians(degrees)))
        thing.add(colour, _stroke([(cy - r, cz), top]), _stroke([top, (cy + r, cz)]))
    dice = random.Random(3)
    for line in range(4):                        # a few lines of handwriting on the left wing's side of the panel
        y, z, points = 2.70, 1.86 - 0.13 * line, []
        end = 2.70 + dice.uniform(0.28, 0.34)
        while y < end:
            points.append((y, z + dice.uniform(0.0, 0.045)))
            y += dice.uniform(0.010, 0.022)
        thing.add("chalk white", _stroke(points, 0.006))
    place("Chalk drawing", thing)


def pin_board(width, height, seed):
    """Cork in an aluminium frame with pupils' sheets; on a wall behind y = 0, faces -y, lower edge z = 0."""
    thing, w, dice = Thing(), width / 2, random.Random(seed)
    thing.add("cork", box(-w + 0.008, -0.014, 0.008, w - 0.008, -0.002, height - 0.008))
    thing.add("aluminium anodised", box(-w, -0.020, 0, w, -0.001, 0.012), box(-w, -0.020, height - 0.012, w, -0.001, height),
              box(-w + 0.0005, -0.0195, 0.0115, -w + 0.012, -0.0015, height - 0.0115),
              box(w - 0.012, -0.0195, 0.0115, w - 0.0005, -0.0015, height - 0.0115))
    columns, rows = int((width - 0.1) / 0.36), int((height - 0.08) / 0.34)
    for i in range(columns):
        for j in range(rows):
            if dice.random() < 0.14:
                continue
            x = -w + (i + 0.5) * width / columns + dice.uniform(-.03, .03)
            z = (j + 0.5) * height / rows + dice.uniform(-.02, .02)
            colour = dice.choice(("paper white", "paper white", "paper white", "paper yellow", "paper blue"))
            turn = dice.uniform(-5, 5)
            at = lambda s: s.turned("y", turn).moved(x, 0, z)
            a, b = (0.148, 0.105) if dice.random() < 0.5 else (0.105, 0.148)
            thing.add(colour, at(quad((-a, -0.0150, -b), (a, -0.0150, -b), (a, -0.0150, b), (-a, -0.0150, b))))
            ink = dice.choice(("print ochre", "print petrol", "print terracotta", "print ink"))
            cx, cz, r = dice.uniform(-a / 3, a / 3), dice.uniform(-b / 3, b / 3), dice.uniform(0.35, 0.6) * min(a, b)
            ring = [(cx + r * math.cos(2 * math.pi * t / 14) * dice.uniform(.8, 1.1), -0.0155,
                     cz + r * math.sin(2 * math.pi * t / 14) * dice.uniform(.8, 1.1)) for t in range(14)]
            blob = loft([ring, [(cx, -0.0155, cz)] * 14], caps=False)
            thing.add(ink, at(blob))
            thing.add("print terracotta", cylinder(0.004, 0, 0.006, 8).turned("x", 90).moved(x, -0.0152, z + b * 0.9))
    return thing


def wall_clock():
    """Half past eight; on a wall behind y = 0, faces -y, centred on the origin."""
    case = lathe([(0, 0.002), (0.150, 0.002), (0.160, 0.012), (0.160, 0.034), (0.150, 0.036), (0.148, 0.024), (0, 0.024)], 48)
    thing = Thing().add("plastic black", case.turned("x", 90))
    thing.add("plastic white", lathe([(0, 0.0235), (0.1485, 0.0235), (0.1485, 0.026), (0, 0.026)], 48).turned("x", 90))
    bar = lambda length, wide, turn, y: box(-wide, y - 0.002, -0.02, wide, y, length).turned("y", turn)
    return thing.add("plastic black", bar(0.075, 0.005, 255, -0.029), bar(0.115, 0.004, 180, -0.0325),
                     *(box(-0.003, -0.0275, 0.120, 0.003, -0.0262, 0.138).turned("y", 30 * k) for k in range(12)))


def globe():
    """A school globe on its foot, 0.30 m across; stands on z = 0."""
    thing = Thing().add("plastic black", lathe([(0, 0.0005), (0.10, 0.0005), (0.10, 0.012), (0.014, 0.022), (0.012, 0.07), (0, 0.07)], 24))
    profile = [(0.15 * math.sin(math.pi * i / 16), -0.15 * math.cos(math.pi * i / 16)) for i in range(17)]
    ball = lathe([(max(r, 0.0), z) for r, z in profile], 32).turned("y", 23.4).moved(0, 0, 0.235)
    thing.add("globe blue", ball)
    half = [(0.165 * math.sin(math.pi * i / 16), 0, -0.165 * math.cos(math.pi * i / 16)) for i in range(17)]
    arc = [(x, 0, z) for x, _, z in half]
    bar = tube(arc, 0.005, 6).turned("y", 23.4).moved(0, 0, 0.235)
    return thing.add("aluminium brushed", bar)
