"""What people sit on: each function returns a Thing at the origin, on z = 0, whose sitter looks to +y."""
import math

from furniture import LIFT
from glb import Thing
from shapes import box, cylinder, lathe, loft, rounded_block, thick_sheet, tube


def task_chair(fabric):
    """A swivel chair with a five-star base, castors, a curved mesh back and armrests; the sitter looks to +y."""
    thing = Thing()
    for k in range(5):
        angle = 72 * k + 18
        rings = []
        for x, half_width, half_height, z in ((0.03, 0.030, 0.024, 0.095), (0.17, 0.023, 0.017, 0.084), (0.31, 0.014, 0.010, 0.068)):
            rings.append([(x, half_width * math.cos(a), z + half_height * math.sin(a))
                          for a in (2 * math.pi * i / 6 for i in range(6))])
        thing.add("aluminium brushed", loft(rings).turned("z", angle))
        for side in (-0.021, 0.003):
            wheel = cylinder(0.028, 0.0, 0.018, 9).turned("x", -90)
            thing.add("plastic black", wheel.moved(0.30, side, 0.029).turned("z", angle))
        thing.add("plastic black", box(0.287, -0.005, 0.029, 0.307, 0.005, 0.064).turned("z", angle))
    thing.add("plastic black", lathe([(0.0, 0.07), (0.045, 0.07), (0.045, 0.115), (0.026, 0.125), (0.026, 0.30),
                                      (0.017, 0.305), (0.017, 0.40), (0.0, 0.40)], 10))
    thing.add("plastic black", rounded_block(-0.12, -0.13, 0.385, 0.12, 0.12, 0.43, 0.03, 0.01, 1))
    thing.add(fabric, _cushion(0.25, 0.245, 0.425, 0.505, 16))
    thing.add(fabric, thick_sheet(_chair_back, 8, 8, 0.035))
    spine = [(0, -0.10, 0.41), (0, -0.22, 0.425), (0, -0.285, 0.50), (0, -0.292, 0.62), (0, -0.285, 0.76)]
    thing.add("plastic black", tube(spine, 0.024, 6, 0.014))
    for side in (-1, 1):
        bar = [(side * 0.11, 0.0, 0.405), (side * 0.24, 0.0, 0.41), (side * 0.292, 0.0, 0.45), (side * 0.298, 0.0, 0.65)]
        thing.add("plastic black", tube(bar, 0.017, 6, 0.014))
        pad = rounded_block(-0.042, -0.13, 0.645, 0.042, 0.13, 0.672, 0.036, 0.010, 2)
        thing.add("plastic black", pad.moved(side * 0.293, 0.02, 0))
    return thing


def _cushion(half_width, half_depth, z0, z1, steps):
    """A seat: a superellipse in plan, with a soft rim and a rounded front."""
    def ring(scale, z):
        points = []
        for i in range(steps):
            c, s = math.cos(2 * math.pi * i / steps), math.sin(2 * math.pi * i / steps)
            x = half_width * scale * math.copysign(abs(c) ** 0.6, c)
            y = half_depth * scale * math.copysign(abs(s) ** 0.6, s)
            front = max(0.0, y / half_depth) ** 3
            points.append((x, y, z - 0.025 * front * (z - z0) / (z1 - z0)))
        return points
    h = z1 - z0
    return loft([ring(0.80, z0), ring(0.95, z0 + 0.18 * h), ring(1.0, z0 + 0.5 * h), ring(0.97, z0 + 0.8 * h),
                 ring(0.88, z0 + 0.97 * h), ring(0.55, z1), ring(0.1, z1 - 0.004)])


def _chair_back(u, v):
    """Front of the backrest: concave across, with a lumbar bulge; u runs to -x so that the front faces +y."""
    half = 0.225 * (1 - 0.30 * max(0.0, v - 0.35) ** 1.6) * (0.90 + 0.10 * math.sin(math.pi * min(1.0, v * 1.3)))
    a = 1 - 2 * u
    x = half * a
    y = -0.245 + 0.055 * a * a + 0.028 * math.sin(math.pi * min(1.0, v / 0.55)) - 0.10 * max(0.0, v - 0.3) ** 1.5
    corner = 0.03 * (abs(a) ** 4)
    z = 0.535 + 0.53 * v + (-corner * (v > 0.5) + corner * (v < 0.5)) * abs(2 * v - 1) ** 3
    return (x, y, z)


def meeting_chair(fabric):
    """A one-piece shell on four tapered wooden legs; the sitter looks to +y."""
    def shell(u, v):
        a = 1 - 2 * u
        path = ((0.24, 0.435), (0.20, 0.452), (0.05, 0.448), (-0.10, 0.442), (-0.185, 0.465), (-0.222, 0.54),
                (-0.245, 0.66), (-0.262, 0.78), (-0.27, 0.83))
        t = v * (len(path) - 1)
        k = min(int(t), len(path) - 2)
        y, z = (path[k][n] + (path[k + 1][n] - path[k][n]) * (t - k) for n in range(2))
        half = 0.225 - 0.04 * abs(2 * v - 1) ** 4
        lift = 0.035 * a * a
        return (half * a, y + lift * (v > 0.5) * 1.2, z + lift * (v <= 0.5))

    thing = Thing()
    thing.add(fabric, thick_sheet(shell, 8, 14, 0.022))
    for x in (-1, 1):
        for y in (-1, 1):
            leg = [(x * 0.235, y * 0.225 - 0.01, LIFT), (x * 0.135, y * 0.14 - 0.01, 0.425)]
            thing.add("oak solid", tube(leg, 0.011, 7, 0.017))
    thing.add("plastic black", box(-0.14, -0.16, 0.395, 0.14, -0.13, 0.42), box(-0.14, 0.11, 0.395, 0.14, 0.14, 0.42))
    return thing


def sofa(width, fabric):
    """Seats and a back in separate cushions on steel feet; the sitter looks to +y."""
    thing, w = Thing(), width / 2
    thing.add(fabric, rounded_block(-w + 0.01, -0.41, 0.13, w - 0.01, 0.385, 0.28, 0.05, 0.02, 3, 2))
    for side in (-1, 1):
        x = side * (w - 0.075)
        thing.add(fabric, rounded_block(x - 0.075, -0.42, 0.132, x + 0.075, 0.395, 0.58, 0.06, 0.035, 4, 2))
    thing.add(fabric, rounded_block(-w + 0.14, -0.425, 0.25, w - 0.14, -0.22, 0.76, 0.06, 0.04, 4, 2))
    seats = max(1, round((width - 0.3) / 0.75))
    each = (width - 0.30) / seats
    for k in range(seats):
        x = -w + 0.15 + k * each
        thing.add(fabric, rounded_block(x + 0.004, -0.225, 0.275, x + each - 0.004, 0.42, 0.44, 0.06, 0.045, 4, 3))
        pillow = rounded_block(x + 0.02, -0.10, 0.0, x + each - 0.02, 0.06, 0.36, 0.07, 0.06, 4, 3)
        thing.add(fabric, pillow.turned("x", 12).moved(0, -0.13, 0.43))
    for x in (-w + 0.1, w - 0.1):
        for y in (-0.34, 0.32):
            thing.add("steel powder black", cylinder(0.016, LIFT, 0.135, 10).moved(x, y))
    return thing
