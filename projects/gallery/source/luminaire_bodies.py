"""Housings of the gallery's luminaires; the photometric centre is the origin and the opening faces the aim.

Bodies begin 3 mm behind the opening: nothing lies in the way of its light.
"""
import math

from glb import Thing
from shapes import box, lathe, tube

PIVOT = 0.080          # from the opening back to the joint under the track [m]


def _towards(surface, aim):
    """Turns a surface made for an aim straight down to any other one, about the horizontal axis at right angles."""
    x, y, z = aim
    length = math.sqrt(x * x + y * y + z * z)
    tilt, heading = math.degrees(math.acos(-z / length)), math.degrees(math.atan2(y, x))
    return surface.turned("z", -heading).turned("y", -tilt).turned("z", heading)


def spot(radius):
    """A cylinder with fins at its back, a fork and a stem to the track `above` the opening."""
    def body(aim, above):
        shell = lathe([(0, 0.003), (radius + 0.003, 0.003), (radius + 0.008, 0.006), (radius + 0.008, 0.095), (radius - 0.002, 0.098),
                       (radius - 0.002, 0.104), (radius + 0.008, 0.107), (radius + 0.008, 0.118), (radius + 0.002, 0.122), (0, 0.122)], 32)
        x, y, z = (-PIVOT * c / math.sqrt(sum(a * a for a in aim)) for c in aim)
        thing = Thing().add("luminaire black", _towards(shell, aim))
        thing.add("luminaire black", tube([(x, y, z), (x, y, above - 0.02)], 0.008, 10))
        return thing.add("luminaire black", box(x - 0.06, y - 0.015, above - 0.024, x + 0.06, y + 0.015, above - 0.001))
    return body


def washer(aim, above):
    """A square head, 120 x 160 mm, tilted to its aim, on the same stem."""
    head = box(-0.058, -0.078, 0.003, 0.058, 0.078, 0.060)
    x, y, z = (-PIVOT * c / math.sqrt(sum(a * a for a in aim)) for c in aim)
    thing = Thing().add("luminaire black", _towards(head, aim))
    thing.add("luminaire black", tube([(x, y, z - 0.03), (x, y, above - 0.02)], 0.008, 10))
    return thing.add("luminaire black", box(x - 0.015, y - 0.06, above - 0.024, x + 0.015, y + 0.06, above - 0.001))


def showcase_spot(aim, _above):
    """A can of 24 mm under the showcase's lid."""
    can = lathe([(0, 0.002), (0.011, 0.002), (0.012, 0.003), (0.012, 0.026), (0, 0.026)], 20)
    return Thing().add("luminaire black", _towards(can, aim))


BODIES = {"N": spot(0.030), "M": spot(0.040), "F": spot(0.040), "W": washer, "S": showcase_spot}
