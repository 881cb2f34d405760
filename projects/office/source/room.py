"""The room itself: a closed shell of walls with thickness, windows, doors, ceiling, floor finishes, glass walls.

Parts that meet go a few millimetres into one another instead of sharing a plane, so nothing flickers or leaks.
"""
import random

from glb import Thing
import rooms
from shapes import box, circle, cylinder, lathe, loft, panel_with_holes, quad, rounded_block, tube

LENGTH, WIDTH, CEILING = 14.4, 9.0, 2.9      # inner dimensions [m]; x along the windows, y to the corridor wall
SLAB = 2.908                                 # underside of the grid that carries the ceiling tiles
TILE = 0.6
WINDOW = (0.4, 0.85, 14.0, 2.60)             # x0, z0, x1, z1 of the band in the wall y = 0
DOOR = (0.9, 0.0, 1.95, 2.15)                # x0, z0, x1, z1 in the wall y = 9
MEETING_X, MEETING_Y = 10.2, 5.4             # the glass walls of the meeting room (both on the tile grid)
MEETING_DOOR = (7.55, 8.50)                  # y0, y1 in the glass wall x = MEETING_X


def walls(place):
    """The four walls, each a closed solid; `place(name, thing)` stands them."""
    low, high = -0.10, 2.99
    south = panel_with_holes((-0.3, LENGTH + 0.3), (low, high), [WINDOW],
                             lambda u, v, w: (LENGTH - u, w, v), 0.30)
    place("Wall south (windows)", Thing().add("wall paint white", south))
    north = panel_with_holes((-0.3, LENGTH + 0.3), (low, high), [(DOOR[0], -0.05, DOOR[2], DOOR[3])],
                             lambda u, v, w: (u, WIDTH - w, v), 0.15)
    place("Wall north", Thing().add("wall paint white", north))
    place("Wall west", Thing().add("wall paint sage", box(-0.15, -0.01, low + 0.002, 0.0, WIDTH + 0.01, high - 0.002)))
    place("Wall east", Thing().add("wall paint white", box(LENGTH, -0.01, low + 0.002, LENGTH + 0.15, WIDTH + 0.01, high - 0.002)))


def slabs(place):
    place("Floor slab", Thing().add("concrete", box(-0.4, -0.4, -0.25, LENGTH + 0.4, WIDTH + 0.3, -0.02)))
    place("Ceiling grid", Thing().add("ceiling grid white", box(-0.4, -0.4, SLAB, LENGTH + 0.4, WIDTH + 0.3, 3.1)))


def ceiling_tiles(place, occupied):
    """Tegular tiles that hang 8 mm below their grid, except where a luminaire fills the cell."""
    tiles = rooms.ceiling_tiles(LENGTH, WIDTH, CEILING, TILE, occupied)
    place("Ceiling tiles", tiles)


def floor_finishes(place):
    """Carpet tiles in three greys, oak planks in the corridor strip; sheets at z = 0 over the slab."""
    dice, carpet, oak = random.Random(7), Thing(), Thing()
    edge = 7.0                                        # y where the oak begins, west of the meeting room
    for i in range(29):
        for j in range(18):
            x0, x1 = 0.5 * i, min(0.5 * (i + 1), LENGTH)
            y0, y1 = 0.5 * j, 0.5 * (j + 1)
            if y0 >= edge and x0 < MEETING_X:
                x0 = max(x0, MEETING_X)
                if x1 <= MEETING_X:
                    continue
            shade = dice.choices(("carpet grey", "carpet grey dark", "carpet grey light"), (6, 2, 2))[0]
            carpet.add(shade, _finish(x0, y0, x1, y1))
    for row in range(10):
        x, y = -1.2 * dice.random(), edge + 0.2 * row
        while x < MEETING_X:
            x0, x1 = max(x, 0.0), min(x + 1.2, MEETING_X)
            oak.add(dice.choice(("oak floor", "oak floor", "oak floor light", "oak floor dark")), _finish(x0, y, x1, y + 0.2))
            x += 1.2
    place("Carpet", carpet)
    place("Oak floor", oak)


def _finish(x0, y0, x1, y1):
    return quad((x0, y0, 0), (x1, y0, 0), (x1, y1, 0), (x0, y1, 0))


def skirting(place):
    thick, top = 0.012, 0.08
    runs = rooms.skirting(LENGTH, WIDTH, (DOOR[0], DOOR[2]), thick, top)
    place("Skirting", Thing().add("skirting white", *runs))


def windows(place):
    """Ten bays: frame, mullions, a transom, thin panes, roller blinds at different heights, a sill."""
    x0, z0, x1, z1 = WINDOW
    y0, y1, transom, bays, dice = -0.18, -0.11, 2.15, 10, random.Random(5)
    frame = Thing().add("aluminium anodised dark",
                        box(x0 - 0.005, y0, z0 - 0.005, x1 + 0.005, y1, z0 + 0.05),
                        box(x0 - 0.005, y0, z1 - 0.05, x1 + 0.005, y1, z1 + 0.005),
                        box(x0 - 0.003, y0 + 0.004, transom - 0.022, x1 + 0.003, y1 - 0.004, transom + 0.022))
    step = (x1 - x0) / bays
    for k in range(bays + 1):
        x = x0 + step * k
        half = 0.028
        frame.add("aluminium anodised dark", box(max(x - half, x0 - 0.004), y0 + 0.002, z0 + 0.001,
                                                 min(x + half, x1 + 0.004), y1 - 0.002, z1 - 0.001))
    place("Window frame", frame)
    for k in range(bays):
        a, b, y = x0 + step * k + 0.02, x0 + step * (k + 1) - 0.02, -0.145
        pane = Thing()
        for low, high in ((z0 + 0.04, transom - 0.015), (transom + 0.015, z1 - 0.04)):
            pane.add("window glass", quad((b, y, low), (a, y, low), (a, y, high), (b, y, high)))
        place(f"Window pane {k + 1:02d}", pane)
        bottom = dice.choice((2.30, 1.95, 1.95, 1.62, 1.30))
        blind = Thing().add("blind fabric", box(a + 0.012, -0.0805, bottom, b - 0.012, -0.0785, z1 - 0.035))
        blind.add("aluminium brushed", cylinder(0.024, a + 0.005, b - 0.005, 14).turned("y", 90).moved(0, -0.0795, z1 - 0.03),
                  cylinder(0.008, a + 0.010, b - 0.010, 8).turned("y", 90).moved(0, -0.0795, bottom))
        place(f"Blind {k + 1:02d}", blind)
    place("Window sill", Thing().add("sill stone", rounded_block(x0 - 0.02, -0.1155, z0 - 0.012, x1 + 0.02, 0.03, z0 + 0.014,
                                                                0.008, 0.004, 2, 2)))


def radiators(place):
    spans = [(0.7, 1.9), (2.1, 3.3), (4.3, 5.5), (5.7, 6.9), (7.9, 9.1), (9.3, 10.5), (11.5, 12.7), (12.9, 14.1)]
    for k, (x0, x1) in enumerate(spans):
        thing = rooms.radiator(x0, x1, 0.66, 14)
        place(f"Radiator {k + 1}", thing)


def columns(place):
    number = 1
    for x in (3.8, 7.4, 11.0):
        place(f"Column {number}", Thing().add("concrete fair-faced", box(x - 0.15, -0.02, -0.018, x + 0.15, 0.25, 2.95)))
        number += 1
    for x in (3.8, 7.4):
        place(f"Column {number}", Thing().add("concrete fair-faced", cylinder(0.18, -0.018, 2.95, 48).moved(x, 6.55)))
        number += 1


def entrance(place):
    """An oak leaf in a steel frame, closed, with lever handles, and the luminous exit sign above it."""
    x0, _, x1, top = DOOR
    rooms.door(place, WIDTH, x0, x1, top, "steel powder black", "oak laminate", 1)
    cx, z = (x0 + x1) / 2, 2.42
    sign = Thing().add("plastic white", box(cx - 0.17, WIDTH - 0.035, z - 0.095, cx + 0.17, WIDTH + 0.003, z + 0.095))
    face = quad((cx - 0.16, WIDTH - 0.0358, z - 0.085), (cx + 0.16, WIDTH - 0.0358, z - 0.085),
                (cx + 0.16, WIDTH - 0.0358, z + 0.085), (cx - 0.16, WIDTH - 0.0358, z + 0.085))
    place("Exit sign", sign.add("exit sign green", face))
    switch = Thing().add("plastic white", rounded_block(-0.04, -0.04, 0, 0.04, 0.04, 0.011, 0.006, 0.003, 3)
                         .turned("x", 90).moved(x1 + 0.2, WIDTH + 0.001, 1.05))
    place("Light switch", switch)


def glass_walls(place):
    """Two glass walls with slim black profiles; a pivot-hung glass door with a bar handle."""
    place("Glass wall west", _glass_run([5.4, 6.475, MEETING_DOOR[0], MEETING_DOOR[1], 9.0],
                                        lambda u, w, z: (MEETING_X + w, u, z), MEETING_DOOR, 0.0))
    place("Glass wall south", _glass_run([10.2, 11.25, 12.3, 13.35, 14.4], lambda u, w, z: (u, MEETING_Y - w, z), None, 0.0007))
    y0, y1 = MEETING_DOOR
    at = lambda a, w0, z0, b, w1, z1: box(MEETING_X + w0, a, z0, MEETING_X + w1, b, z1)
    door = Thing()
    for a, b, z0, z1 in ((y0 + 0.029, y0 + 0.070, 0.008, 2.22), (y1 - 0.070, y1 - 0.029, 0.008, 2.22)):
        door.add("steel powder black", at(a, -0.018, z0, b, 0.018, z1))
    for z0, z1 in ((0.009, 0.10), (2.17, 2.219)):
        door.add("steel powder black", at(y0 + 0.030, -0.0175, z0, y1 - 0.030, 0.0175, z1))
    door.add("partition glass", quad((MEETING_X, y1 - 0.06, 0.09), (MEETING_X, y0 + 0.06, 0.09),
                                     (MEETING_X, y0 + 0.06, 2.18), (MEETING_X, y1 - 0.06, 2.18)))
    for side in (-1, 1):
        x = MEETING_X + side * 0.055
        door.add("steel brushed", tube([(x, y0 + 0.05, 0.85), (x, y0 + 0.05, 1.35)], 0.011, 12))
        for z in (0.92, 1.28):
            door.add("steel brushed", tube([(MEETING_X + side * 0.016, y0 + 0.05, z), (x, y0 + 0.05, z)], 0.008, 8))
    place("Meeting room door", door)


def _glass_run(posts, at, door, trim):
    """Profiles and panes along u; at(u, w, z) -> point.

    door  (u0, u1) leaves an opening under a transom; None: no door
    trim  makes profiles that much slimmer, so that a run which starts inside another's corner post shares no plane
    """
    def bar(u0, w, z0, u1, z1):
        a, b = at(u0, -w + trim, z0), at(u1, w - trim, z1)
        return box(*(min(a[n], b[n]) for n in range(3)), *(max(a[n], b[n]) for n in range(3)))

    thing, first, last, black = Thing(), posts[0], posts[-1], "steel powder black"
    thing.add(black, bar(first - 0.025 + trim, 0.025, 2.85 + trim, last + 0.01, 2.915 - trim))
    spans = list(zip(posts, posts[1:]))
    for u0, u1 in spans:
        if (u0, u1) == door:
            thing.add(black, bar(u0, 0.023, 2.225, u1, 2.275))
        else:
            thing.add(black, bar(u0 + 0.005, 0.024, -0.01 + trim, u1 - 0.005, 0.05 - trim))
    for u in posts[1:] if trim else posts:
        thing.add(black, bar(u - 0.022, 0.022, -0.012, u + 0.022, 2.91))
    for u0, u1 in spans:
        low = 2.26 if (u0, u1) == door else 0.04
        thing.add("partition glass", quad(at(u0 + 0.01, 0, low), at(u1 - 0.01, 0, low), at(u1 - 0.01, 0, 2.86), at(u0 + 0.01, 0, 2.86)))
    return thing


def whiteboard():
    """2.4 x 1.2, on a wall behind y = 0, faces -y; its lower edge is z = 0."""
    thing = Thing().add("whiteboard enamel", box(-1.19, -0.020, 0.01, 1.19, -0.004, 1.19))
    thing.add("aluminium brushed", box(-1.2, -0.026, -0.008, 1.2, -0.0035, 0.014), box(-1.2, -0.026, 1.186, 1.2, -0.0035, 1.208),
              box(-1.2005, -0.0255, 0.012, -1.186, -0.003, 1.188), box(1.186, -0.0255, 0.012, 1.2005, -0.003, 1.188))
    tray = [(-0.35, -0.08), (0.35, -0.08), (0.35, -0.02), (-0.35, -0.02)]
    thing.add("aluminium brushed", loft([[(x, y, -0.012) for x, y in tray], [(x, y, 0.001) for x, y in tray]]))
    for k, colour in enumerate(("book red", "book blue", "book green")):
        pen = cylinder(0.008, 0, 0.13, 10).turned("y", 90)
        thing.add(colour, pen.moved(-0.28 + 0.17 * k, -0.055, 0.0095))
    return thing


def wall_screen():
    """A 65-inch display on a wall behind y = 0, faces -y."""
    body = rounded_block(-0.735, -0.42, 0, 0.735, 0.42, 0.045, 0.012, 0.006, 3, 2).turned("x", 90).moved(0, -0.02, 0)
    thing = Thing().add("plastic black", body, box(-0.2, -0.021, -0.15, 0.2, -0.002, 0.15))
    face = quad((-0.72, -0.0656, -0.405), (0.72, -0.0656, -0.405), (0.72, -0.0656, 0.405), (-0.72, -0.0656, 0.405))
    return thing.add("screen glass", face)


def rug():
    return Thing().add("rug terracotta", loft([circle(1.15, 0.0004, 64), circle(1.16, 0.006, 64), circle(1.15, 0.011, 64)]))


def air_outlet():
    """A round supply diffuser in the ceiling plane: concentric cones."""
    thing = Thing()
    for r in (0.07, 0.14):
        thing.add("ceiling grid white", lathe([(r, 2.885), (r + 0.022, 2.8925), (r + 0.022, 2.8935), (r, 2.886), (r, 2.885)], 24))
    return thing.add("ceiling grid white", cylinder(0.19, 2.894, 2.91, 24))
