from glb import Thing
from shapes import box, lathe, loft, quad, rounded_block, tube

def ceiling_tiles(length, width, ceiling, tile, taken=()):
    tiles = Thing()
    for i in range(round(length / tile)):
        for j in range(round(width / tile)):
            if (i, j) in taken:
                continue
            x0, y0, x1, y1 = tile * i + 0.012, tile * j + 0.012, tile * (i + 1) - 0.012, tile * (j + 1) - 0.012
            b, top = 0.006, ceiling + 0.012
            low = [(x0 + b, y0 + b, ceiling), (x1 - b, y0 + b, ceiling), (x1 - b, y1 - b, ceiling), (x0 + b, y1 - b, ceiling)]
            high = [(x0, y0, top), (x1, y0, top), (x1, y1, top), (x0, y1, top)]
            tiles.add("ceiling tile white", loft([low, high], caps=False) + quad(low[3], low[2], low[1], low[0]))
    return tiles

def skirting(length, width, door, thick, top):
    return [box(-0.004, -0.005, -0.015, length + 0.004, thick, top - 0.0005),
            box(-0.004, width - thick, -0.015, door[0] - 0.045, width + 0.005, top - 0.0005),
            box(door[1] + 0.045, width - thick, -0.015, length + 0.004, width + 0.005, top - 0.0005),
            box(-0.005, -0.008, -0.014, thick, width + 0.008, top),
            box(length - thick, -0.008, -0.014, length + 0.005, width + 0.008, top)]

def radiator(x0, x1, top, fins):
    thing = Thing().add("steel powder white", rounded_block(x0, 0.035, 0.13, x1, 0.105, top, 0.02, 0.008, 3, 2))
    for i in range(fins):
        x = x0 + 0.05 + (x1 - x0 - 0.1) * i / (fins - 1)
        thing.add("steel powder white", box(x - 0.012, 0.104, 0.16, x + 0.012, 0.112, top - 0.03))
    for x in (x0 + 0.15, x1 - 0.15):
        thing.add("steel powder white", box(x - 0.02, -0.004, 0.5, x + 0.02, 0.036, 0.54))
    return thing.add("steel powder white", tube([(x1 - 0.04, 0.07, -0.01), (x1 - 0.04, 0.07, 0.14)], 0.009, 8))

def door(place, wall, x0, x1, top, frame, leaf, handle):
    """handle -1: hung at x1, its lever at x0; +1 the other way round."""
    place("Door frame", Thing().add(frame,
                        box(x0 - 0.05, wall - 0.02, -0.012, x0 + 0.03, wall + 0.16, top + 0.05),
                        box(x1 - 0.03, wall - 0.02, -0.012, x1 + 0.05, wall + 0.16, top + 0.05),
                        box(x0 - 0.045, wall - 0.019, top - 0.03, x1 + 0.045, wall + 0.159, top + 0.049),
                        box(x0 + 0.01, wall - 0.005, -0.013, x1 - 0.01, wall + 0.152, 0.006)))
    thing = Thing().add(leaf, box(x0 + 0.024, wall + 0.01, 0.004, x1 - 0.024, wall + 0.052, top - 0.024))
    hx, hz = (x0 + 0.10 if handle < 0 else x1 - 0.10), 1.05
    lever = [(hx, wall + 0.005, hz), (hx, wall - 0.055, hz), (hx - handle * 0.012, wall - 0.062, hz), (hx - handle * 0.13, wall - 0.062, hz)]
    plate = lathe([(0, 0), (0.026, 0), (0.026, 0.006), (0.023, 0.008), (0, 0.008)], 24)
    thing.add("steel brushed", tube(lever, 0.010, 10), plate.turned("x", 90).moved(hx, wall + 0.0105, hz),
             plate.turned("x", 90).moved(hx, wall + 0.0105, hz - 0.14))
    place("Door", thing)
