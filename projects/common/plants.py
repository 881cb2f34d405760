"""Plants in pots: grown from a seed, so that every run draws the same leaves."""
import math
import random

from glb import Thing
from shapes import Surface, circle, lathe, leaf, tube

GOLDEN_DEG = 137.508     # angle between successive leaves of a real stem


def _pot(thing, radius, height, material):
    thing.add(material, lathe([(0, 0.001), (radius * 0.72, 0.001), (radius * 0.78, 0.012), (radius, height - 0.01),
                               (radius, height), (radius - 0.012, height), (radius - 0.016, height - 0.05)], 24))
    soil = circle(radius - 0.0155, height - 0.045, 24) + [(0, 0, height - 0.035)]
    thing.add("soil", Surface(soil, [(i, (i + 1) % 24, 24) for i in range(24)]))


def rubber_tree(seed, height=1.7, leaves=54):
    """Ficus: three leaning stems with broad leaves in a spiral."""
    thing, dice = Thing(), random.Random(seed)
    _pot(thing, 0.20, 0.38, "pot ceramic white")
    for stem in range(3):
        top = height * (1.0, 0.82, 0.66)[stem]
        lean, turn = dice.uniform(0.05, 0.16), 2 * math.pi * stem / 3 + dice.uniform(-0.4, 0.4)

        def at(t):
            out = 0.04 + lean * t * t * 1.4
            return (out * math.cos(turn), out * math.sin(turn), 0.34 + (top - 0.34) * t)

        thing.add("bark", tube([at(i / 6) for i in range(7)], 0.013, 6, 0.005))
        count = leaves // 3
        for k in range(count):
            t = 0.22 + 0.78 * k / (count - 1)
            angle = math.radians(GOLDEN_DEG * k + 40 * stem)
            rise = -0.15 + 0.75 * t
            size = (0.30 - 0.13 * t) * dice.uniform(0.85, 1.15)
            direction = (math.cos(angle), math.sin(angle), rise)
            colour = "leaf dark" if dice.random() < 0.75 else "leaf light"
            thing.add(colour, leaf(at(t), direction, size, size * 0.52, 0.35))
    return thing


def palm(seed, height=1.9, fronds=11):
    """Areca: arching fronds with two rows of leaflets."""
    thing, dice = Thing(), random.Random(seed)
    _pot(thing, 0.21, 0.42, "pot ceramic grey")
    for k in range(fronds):
        angle = math.radians(GOLDEN_DEG * k)
        reach, top = dice.uniform(0.42, 0.72), height * dice.uniform(0.72, 1.0)

        def at(t):
            out = 0.03 + reach * t ** 1.7
            z = 0.38 + (top - 0.38) * math.sin(t * 1.95) / math.sin(math.pi / 2)
            return (out * math.cos(angle), out * math.sin(angle), z)

        thing.add("leaf light", tube([at(i / 6) for i in range(7)], 0.009, 4, 0.003))
        for i in range(13):
            t = 0.36 + 0.64 * i / 12
            base, tip = at(t), at(min(1.0, t + 0.03))
            along = [tip[n] - base[n] if t < 1 else base[n] - at(0.97)[n] for n in range(3)]
            size = math.sqrt(sum(c * c for c in along)) or 1.0
            along = [c / size for c in along]
            across = (-math.sin(angle), math.cos(angle), 0.0)
            length = 0.30 * (1 - 0.55 * abs(2 * (t - 0.36) / 0.64 - 0.8))
            for side in (-1, 1):
                direction = [0.75 * along[n] + side * across[n] + (0.12 if n == 2 else 0) for n in range(3)]
                colour = "leaf light" if (i + k) % 3 else "leaf dark"
                thing.add(colour, _blade(base, direction, length, 0.030))
    return thing


def snake_plant(seed, pot="pot ceramic white", blades=13, height=0.62, pot_radius=0.12, pot_height=0.2):
    """Sansevieria: upright pointed blades."""
    thing, dice = Thing(), random.Random(seed)
    _pot(thing, pot_radius, pot_height, pot)
    for k in range(blades):
        angle = math.radians(GOLDEN_DEG * k)
        out = pot_radius * 0.55 * math.sqrt(k / blades)
        base = (out * math.cos(angle), out * math.sin(angle), pot_height - 0.05)
        direction = (0.22 * math.cos(angle) + dice.uniform(-.05, .05), 0.22 * math.sin(angle) + dice.uniform(-.05, .05), 1.0)
        colour = "leaf dark" if k % 2 else "leaf light"
        thing.add(colour, leaf(base, direction, height * dice.uniform(0.6, 1.0), 0.06, 0.02))
    return thing


def _blade(base, direction, length, width):
    """A leaflet of four triangles that hangs a little."""
    size = math.sqrt(sum(c * c for c in direction))
    d = [c / size for c in direction]
    side = (-d[1], d[0], 0.0)
    flat = math.hypot(*side[:2]) or 1.0
    side = [c / flat * width / 2 for c in side]
    middle = [base[n] + d[n] * length * 0.45 - (0.01 if n == 2 else 0) for n in range(3)]
    tip = tuple(base[n] + d[n] * length - (0.10 * length * 2.2 if n == 2 else 0) for n in range(3))
    left, right = (tuple(middle[n] + s * side[n] for n in range(3)) for s in (1, -1))
    crest = (middle[0], middle[1], middle[2] + 0.005)
    return Surface([tuple(base), right, crest, left, tip], [(0, 1, 2), (0, 2, 3), (1, 4, 2), (2, 4, 3)])
