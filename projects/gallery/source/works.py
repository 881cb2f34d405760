"""What hangs and stands in the gallery. All of it is invented: no work of anybody is shown.

Flat works hang on a wall behind y = 0 and face -y, centred in x, lower edge at z = 0. The rest stands on z = 0.
"""
import math
import random

from furniture import LIFT, REST
from glb import Thing
from shapes import Surface, box, cylinder, lathe, loft, quad, rounded_block, tube

FACE = -0.0312        # y of a painted face


def _frame(thing, material, w, h, wide, front=-0.042):
    """Four bars round a canvas of 2 w x h, a chamfer towards the picture."""
    profile = [(0.0, -0.003), (0.0, front), (wide * 0.7, front), (wide, FACE - 0.001), (wide, -0.003)]
    corners = [(-w, 0, 1, 1), (w, 0, -1, 1), (w, h, -1, -1), (-w, h, 1, -1)]
    rings = [[(cx + sx * inset, y, cz + sz * inset) for inset, y in profile] for cx, cz, sx, sz in corners + corners[:1]]
    return thing.add(material, loft(rings, caps=False).flipped())


def painting(width, height, palette, seed, frame="frame oak"):
    """Oil on canvas: fields of colour by repeated division."""
    thing, w, dice = Thing(), width / 2, random.Random(seed)
    thing.add("canvas", box(-w + 0.004, FACE + 0.0004, 0.004, w - 0.004, -0.004, height - 0.004))

    def divide(x0, z0, x1, z1, depth):
        wide, tall = x1 - x0, z1 - z0
        if depth == 0 or (depth < 3 and dice.random() < 0.18) or min(wide, tall) < 0.10:
            thing.add(dice.choice(palette), quad((x0, FACE, z0), (x1, FACE, z0), (x1, FACE, z1), (x0, FACE, z1)))
            return
        t = dice.uniform(0.30, 0.70)
        if wide > tall * dice.uniform(0.7, 1.4):
            divide(x0, z0, x0 + t * wide, z1, depth - 1)
            divide(x0 + t * wide, z0, x1, z1, depth - 1)
        else:
            divide(x0, z0, x1, z0 + t * tall, depth - 1)
            divide(x0, z0 + t * tall, x1, z1, depth - 1)

    divide(-w + 0.02, 0.02, w - 0.02, height - 0.02, 5)
    return _frame(thing, frame, w, height, 0.028)


def photograph(width, height, seed):
    """A landscape in bands of grey, in a slim black frame with a white mount."""
    thing, w, dice = Thing(), width / 2, random.Random(seed)
    thing.add("paper white", box(-w + 0.004, FACE + 0.0004, 0.004, w - 0.004, -0.004, height - 0.004))
    m, greys = 0.09, ("grey 1", "grey 2", "grey 3", "grey 4")
    lines = [[height * (0.2 + 0.17 * k) + 0.05 * math.sin(x * dice.uniform(2, 5) + 2 * k) * height for x in
              (-1 + 2 * i / 24 for i in range(25))] for k in range(4)]
    lines = [[m] * 25] + [[min(max(z, m + 0.01 * k), height - m) for z in line] for k, line in enumerate(lines, 1)]
    for k in range(4):
        for i in range(24):
            xa, xb = (-w + m + (2 * w - 2 * m) * j / 24 for j in (i, i + 1))
            a, b, c, d = lines[k][i], lines[k][i + 1], lines[k + 1][i + 1], lines[k + 1][i]
            thing.add(greys[k], quad((xa, FACE, a), (xb, FACE, b), (xb, FACE, max(b, c)), (xa, FACE, max(a, d))))
    return _frame(thing, "steel powder black", w, height, 0.016)


def drawing(width, height, seed):
    """Ink and wash on cream paper in an oak frame: a few discs."""
    thing, w, dice = Thing(), width / 2, random.Random(seed)
    thing.add("paper cream", box(-w + 0.004, FACE + 0.0004, 0.004, w - 0.004, -0.004, height - 0.004))
    y = FACE
    for colour in dice.sample(("wash blue", "wash red", "wash ochre", "ink"), 3):
        r = dice.uniform(0.10, 0.20) * width
        cx, cz = dice.uniform(-w + r + 0.12, w - r - 0.12), dice.uniform(r + 0.14, height - r - 0.14)
        ring = [(cx + r * math.cos(2 * math.pi * i / 36), y, cz + r * math.sin(2 * math.pi * i / 36)) for i in range(36)]
        thing.add(colour, Surface([(cx, y, cz)] + ring, [(0, i, i % 36 + 1) for i in range(1, 37)]))
        y -= 0.0004
    bar = dice.uniform(0.25, 0.45) * height
    thing.add("ink", quad((-w + 0.12, y, bar), (w - 0.12, y, bar + 0.01), (w - 0.12, y, bar + 0.018), (-w + 0.12, y, bar + 0.012)))
    return _frame(thing, "frame oak", w, height, 0.020)


def textile(width, height):
    """A woven hanging of zigzags on a rod; the wool hangs 20 mm off the wall."""
    thing, w, y = Thing(), width / 2, -0.030
    colours, columns, rows, tooth = ("wool red", "wool ochre", "wool cream", "wool indigo"), 16, 12, 0.10
    thing.add("wool cream", box(-w, y + 0.0005, 0.0, w, y + 0.006, height))
    step_x, step_z = width / columns, (height - tooth) / rows
    for j in range(rows):
        for i in range(columns):
            xa, xb = -w + step_x * i, -w + step_x * (i + 1)
            za, zb = (step_z * j + (tooth if (i + k) % 2 else 0.0) for k in (0, 1))
            thing.add(colours[(j * 7 + j // 3) % 4], quad((xa, y, za), (xb, y, zb), (xb, y, zb + step_z), (xa, y, za + step_z)))
    rod = cylinder(0.014, -w - 0.06, w + 0.06, 12).turned("y", 90).moved(0, y + 0.003, height + 0.008)
    holders = [box(x - 0.008, y - 0.004, height + 0.002, x + 0.008, 0.002, height + 0.014) for x in (-w - 0.03, w + 0.03)]
    return thing.add("oak solid", rod).add("bronze", *holders)


def label(seed):
    """A card beside a work, 150 x 100 mm."""
    thing, dice = Thing().add("paper white", box(-0.075, -0.0045, 0, 0.075, -0.0005, 0.10)), random.Random(seed)
    for k in range(4):
        z, end = 0.078 - 0.017 * k, dice.uniform(0.0, 0.055)
        thing.add("ink", quad((-0.06, -0.0048, z), (end, -0.0048, z), (end, -0.0048, z + 0.006), (-0.06, -0.0048, z + 0.006)))
    return thing


def mirror(width, height):
    """A tall mirror in a gilt frame."""
    thing, w = Thing(), width / 2
    thing.add("mirror silver", quad((-w + 0.03, FACE, 0.03), (w - 0.03, FACE, 0.03), (w - 0.03, FACE, height - 0.03), (-w + 0.03, FACE, height - 0.03)))
    thing.add("canvas", box(-w + 0.01, FACE + 0.003, 0.01, w - 0.01, -0.004, height - 0.01))
    return _frame(thing, "gilt", w, height, 0.06, -0.060)


def plinth(side, height):
    return Thing().add("plinth white", rounded_block(-side / 2, -side / 2, LIFT, side / 2, side / 2, height, 0.006, 0.004, 2, 1))


def knot():
    """Bronze: a trefoil 0.5 m across on a pin and a foot."""
    def at(t):
        r = 0.105 * (2 + math.cos(3 * t))
        return (r * math.cos(2 * t), 0.12 * math.sin(3 * t), 0.42 + r * math.sin(2 * t))
    path = [at(2 * math.pi * i / 150) for i in range(152)]
    thing = Thing().add("bronze", tube(path, 0.042, 18))
    return thing.add("steel powder black", rounded_block(-0.11, -0.11, REST, 0.11, 0.11, 0.03, 0.006, 0.003, 2),
                     cylinder(0.008, 0.028, 0.16, 10).moved(*_lowest(path)))


def _lowest(path):
    x, y, _ = min(path, key=lambda p: p[2])
    return (x, y, 0.0)


def twist():
    """Marble: a soft-edged square column that turns a third of the way round and swells, 0.85 m high."""
    rings = []
    for k in range(41):
        t = k / 40
        size, turn, count = 0.12 + 0.05 * math.sin(math.pi * t) ** 2 - 0.02 * t, math.radians(120 * t), 40
        ring = []
        for i in range(count):
            a = 2 * math.pi * i / count
            c, s = math.cos(a), math.sin(a)
            x, y = size * math.copysign(abs(c) ** 0.7, c), size * math.copysign(abs(s) ** 0.7, s)
            ring.append((x * math.cos(turn) - y * math.sin(turn), x * math.sin(turn) + y * math.cos(turn), REST + 0.85 * t))
        rings.append(ring)
    return Thing().add("marble", loft(rings))


def stones():
    """Granite: three boulders on one another."""
    thing, z = Thing(), REST
    for k, (rx, ry, rz) in enumerate(((0.24, 0.19, 0.12), (0.17, 0.15, 0.10), (0.10, 0.11, 0.075))):
        profile = [(math.sin(math.pi * i / 18), -math.cos(math.pi * i / 18)) for i in range(19)]
        ball = lathe([(max(r, 0.0), h) for r, h in profile], 32).scaled(rx, ry, rz).turned("z", 35 * k)
        if k == 0:
            ball = Surface([(x, y, max(h, -0.85 * rz)) for x, y, h in ball.points], ball.triangles)
            thing.add("granite", ball.moved(0, 0, z + 0.85 * rz))
            z += 1.85 * rz
        else:
            thing.add("granite", ball.moved(0.01 * k, 0, z + rz - 0.012))
            z += 2 * rz - 0.012
    return thing


SHOWCASE = (1.10, 0.70, 0.85, 1.75)              # width, depth, z of its floor, top


def showcase():
    """A glass hood over a plinth: five panes without thickness, a lacquered floor, thin steel corners and a lid."""
    w, d, z0, z1 = SHOWCASE[0] / 2, SHOWCASE[1] / 2, SHOWCASE[2], SHOWCASE[3]
    thing = Thing().add("plinth grey", rounded_block(-w, -d, LIFT, w, d, z0 - 0.012, 0.006, 0.004, 2, 1),
                        box(-w + 0.02, -d + 0.02, z0 - 0.013, w - 0.02, d - 0.02, z0))
    b, low = 0.006, z0 - 0.008
    panes = [quad((-w + b, -d + b, low), (w - b, -d + b, low), (w - b, -d + b, z1), (-w + b, -d + b, z1)),
             quad((w - b, d - b, low), (-w + b, d - b, low), (-w + b, d - b, z1), (w - b, d - b, z1)),
             quad((-w + b, d - b, low), (-w + b, -d + b, low), (-w + b, -d + b, z1), (-w + b, d - b, z1)),
             quad((w - b, -d + b, low), (w - b, d - b, low), (w - b, d - b, z1), (w - b, -d + b, z1))]
    thing.add("showcase glass", *panes)
    for x in (-1, 1):
        for y in (-1, 1):
            thing.add("steel powder black", box(x * (w - b) - 0.004, y * (d - b) - 0.004, low - 0.003, x * (w - b) + 0.004, y * (d - b) + 0.004, z1 + 0.004))
    lid = rounded_block(-w - 0.002, -d - 0.002, z1 - 0.001, w + 0.002, d + 0.002, z1 + 0.040, 0.006, 0.004, 2, 1)
    return thing.add("steel powder black", lid)


def vessels():
    """Three invented pots and a bowl, for the showcase's floor (z = 0)."""
    def pot(profile, material, x, y):
        return material, lathe([(0.0, REST)] + profile + [(profile[-1][0] - 0.006, profile[-1][1]), (profile[-1][0] - 0.010, profile[-1][1] - 0.03),
                                                          (0.0, profile[-1][1] - 0.05)], 40).moved(x, y, 0)
    thing = Thing()
    for material, surface in (
            pot([(0.05, REST), (0.055, 0.01), (0.11, 0.14), (0.105, 0.22), (0.05, 0.30), (0.040, 0.34), (0.055, 0.38)], "ceramic celadon", -0.30, 0.05),
            pot([(0.06, REST), (0.065, 0.008), (0.07, 0.10), (0.14, 0.16), (0.15, 0.17)], "ceramic oxblood", 0.02, -0.08),
            pot([(0.045, REST), (0.05, 0.006), (0.075, 0.10), (0.085, 0.24), (0.06, 0.33), (0.028, 0.37), (0.026, 0.44), (0.038, 0.46)], "ceramic white", 0.32, 0.06)):
        thing.add(material, surface)
    return thing


def bench():
    """A long oak bench with a leather pad on blackened steel."""
    thing = Thing().add("oak solid", rounded_block(-0.9, -0.24, 0.36, 0.9, 0.24, 0.40, 0.01, 0.005, 3, 2))
    thing.add("leather", rounded_block(-0.88, -0.22, 0.3995, 0.88, 0.22, 0.45, 0.03, 0.02, 4, 3))
    for x in (-0.62, 0.62):
        thing.add("steel powder black", *_bench_frame(x))
    return thing


def _bench_frame(x):
    return (box(x - 0.02, -0.20, LIFT, x + 0.02, -0.16, 0.362), box(x - 0.02, 0.16, LIFT, x + 0.02, 0.20, 0.362),
            box(x - 0.0195, -0.17, 0.0015, x + 0.0195, 0.17, 0.03))
