"""Shapes of which furniture is made: points and triangles, metres, z up, outward faces counter-clockwise.

A Surface carries no normals: shade() finds them at the end from the angle between neighbouring faces, so a
shape only has to be right in space. Closed shapes are closed; only leaves, panes and floor finishes are sheets.
"""
import math


class Surface:
    """Points [m] and triangles (index triples). Every method returns a new Surface."""

    def __init__(self, points=(), triangles=()):
        self.points = list(points)
        self.triangles = list(triangles)

    def mapped(self, place):
        return Surface([place(*p) for p in self.points], self.triangles)

    def moved(self, dx=0.0, dy=0.0, dz=0.0):
        return self.mapped(lambda x, y, z: (x + dx, y + dy, z + dz))

    def scaled(self, sx, sy, sz):
        """Positive factors only: a mirror would turn the faces inside out."""
        return self.mapped(lambda x, y, z: (x * sx, y * sy, z * sz))

    def turned(self, axis, degrees):
        """Right-handed about 'x', 'y' or 'z' through the origin."""
        c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
        if axis == "x":
            return self.mapped(lambda x, y, z: (x, c * y - s * z, s * y + c * z))
        if axis == "y":
            return self.mapped(lambda x, y, z: (c * x + s * z, y, -s * x + c * z))
        return self.mapped(lambda x, y, z: (c * x - s * y, s * x + c * y, z))

    def flipped(self):
        return Surface(self.points, [(a, c, b) for a, b, c in self.triangles])

    def __add__(self, other):
        first = len(self.points)
        return Surface(self.points + other.points,
                       self.triangles + [(a + first, b + first, c + first) for a, b, c in other.triangles])


def joined(surfaces):
    whole = Surface()
    for surface in surfaces:
        whole = whole + surface
    return whole


def box(x0, y0, z0, x1, y1, z1):
    points = [(x, y, z) for z in (z0, z1) for x, y in ((x0, y0), (x1, y0), (x1, y1), (x0, y1))]
    quads = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]
    return Surface(points, [t for a, b, c, d in quads for t in ((a, b, c), (a, c, d))])


def quad(a, b, c, d):
    """A sheet of two triangles; its normal is (b - a) x (d - a)."""
    return Surface([a, b, c, d], [(0, 1, 2), (0, 2, 3)])


def loft(rings, close=True, caps=True):
    """A skin over rings of equally many points, counter-clockwise seen from the side the rings advance to."""
    count = len(rings[0])
    points = [p for ring in rings for p in ring]
    triangles = []
    for k in range(len(rings) - 1):
        for i in range(count if close else count - 1):
            j = (i + 1) % count
            a, b, c, d = k * count + i, k * count + j, (k + 1) * count + j, (k + 1) * count + i
            triangles += [(a, b, c), (a, c, d)]
    if caps:
        last = (len(rings) - 1) * count
        for i in range(1, count - 1):
            triangles += [(0, i + 1, i), (last, last + i, last + i + 1)]
    return Surface(points, triangles)


def circle(radius, z, steps, cx=0.0, cy=0.0):
    return [(cx + radius * math.cos(2 * math.pi * i / steps), cy + radius * math.sin(2 * math.pi * i / steps), z)
            for i in range(steps)]


def lathe(profile, steps):
    """Turns a profile [(radius, z)...] about the z axis. Upwards on the outside; a radius of 0 closes an end."""
    return loft([circle(radius, z, steps) for radius, z in profile], caps=False)


def cylinder(radius, z0, z1, steps):
    return loft([circle(radius, z0, steps), circle(radius, z1, steps)])


def rounded_rectangle(x0, y0, x1, y1, radius, steps):
    """Outline with `steps` segments a corner, counter-clockwise: [(x, y)...]."""
    outline = []
    for corner, (cx, cy) in enumerate(((x1 - radius, y1 - radius), (x0 + radius, y1 - radius),
                                       (x0 + radius, y0 + radius), (x1 - radius, y0 + radius))):
        for i in range(steps + 1):
            angle = math.pi / 2 * (corner + i / steps)
            outline.append((cx + radius * math.cos(angle), cy + radius * math.sin(angle)))
    return outline


def rounded_block(x0, y0, z0, x1, y1, z1, corner, bevel, corner_steps=3, bevel_steps=1):
    """A block with rounded upright edges (radius `corner`) and rounded top and bottom rims (`bevel` < `corner`)."""
    def ring(inset, z):
        outline = rounded_rectangle(x0 + inset, y0 + inset, x1 - inset, y1 - inset, corner - inset, corner_steps)
        return [(x, y, z) for x, y in outline]

    quarter = [math.pi / 2 * i / bevel_steps for i in range(bevel_steps + 1)]
    rings = [ring(bevel * (1 - math.sin(a)), z0 + bevel * (1 - math.cos(a))) for a in quarter]
    rings += [ring(bevel * (1 - math.cos(a)), z1 - bevel * (1 - math.sin(a))) for a in quarter]
    return loft(rings)


def prism(outline, z0, z1):
    """A convex outline [(x, y)...], counter-clockwise, pulled up from z0 to z1."""
    return loft([[(x, y, z0) for x, y in outline], [(x, y, z1) for x, y in outline]])


def tube(path, radius, steps, end_radius=None):
    """A round bar along a path; its radius may taper to `end_radius`."""
    end_radius = radius if end_radius is None else end_radius
    rings, side = [], None
    for k, point in enumerate(path):
        ahead, behind = path[min(k + 1, len(path) - 1)], path[max(k - 1, 0)]
        along = _unit(_minus(ahead, behind))
        if side is None:
            side = (1.0, 0.0, 0.0) if abs(along[0]) < 0.9 else (0.0, 1.0, 0.0)
        side = _unit(_minus(side, _times(along, _dot(side, along))))
        up = _cross(along, side)
        r = radius + (end_radius - radius) * k / (len(path) - 1)
        ring = []
        for i in range(steps):
            c, s = r * math.cos(2 * math.pi * i / steps), r * math.sin(2 * math.pi * i / steps)
            ring.append(tuple(point[n] + c * side[n] + s * up[n] for n in range(3)))
        rings.append(ring)
    return loft(rings)


def thick_sheet(at, columns, rows, thickness):
    """A closed curved shell: at(u, v) -> point for u, v in 0..1 is its front; the back lies `thickness` behind
    (against the normal du x dv), thinning towards the rim so that the edge is soft."""
    def front(i, j):
        return at(i / columns, j / rows)

    def normal(i, j):
        u = _minus(front(min(i + 1, columns), j), front(max(i - 1, 0), j))
        v = _minus(front(i, min(j + 1, rows)), front(i, max(j - 1, 0)))
        return _unit(_cross(u, v))

    width = columns + 1
    points = [front(i, j) for j in range(rows + 1) for i in range(width)]
    for j in range(rows + 1):
        for i in range(width):
            rim = i in (0, columns) or j in (0, rows)
            depth = thickness * (0.45 if rim else 1.0)
            points.append(_minus(front(i, j), _times(normal(i, j), depth)))
    back, triangles = (rows + 1) * width, []
    for j in range(rows):
        for i in range(columns):
            a, b, c, d = j * width + i, j * width + i + 1, (j + 1) * width + i + 1, (j + 1) * width + i
            triangles += [(a, b, c), (a, c, d), (back + a, back + c, back + b), (back + a, back + d, back + c)]
    rim = ([i for i in range(width)] + [j * width + columns for j in range(1, rows + 1)]
           + [rows * width + i for i in range(columns - 1, -1, -1)] + [j * width for j in range(rows - 1, 0, -1)])
    for k, a in enumerate(rim):
        b = rim[(k + 1) % len(rim)]
        triangles += [(b, a, back + a), (b, back + a, back + b)]
    return Surface(points, triangles)


def leaf(base, direction, length, width, droop):
    """A leaf: a sheet folded along its midrib that bends down towards its tip (12 triangles)."""
    along = _unit(direction)
    side = _unit(_cross(along, (0.0, 0.0, 1.0)) if abs(along[2]) < 0.98 else (1.0, 0.0, 0.0))
    up = _cross(side, along)
    stations = [(0.0, 0.03), (0.25, 0.8), (0.5, 1.0), (0.78, 0.66), (1.0, 0.02)]
    points = []
    for t, half in stations:
        middle = [base[n] + along[n] * length * t for n in range(3)]
        middle[2] -= droop * length * t * t
        for s, lift in ((-1, 0.22), (0, 0.0), (1, 0.22)):
            points.append(tuple(middle[n] + side[n] * s * half * width / 2 + up[n] * lift * half * width / 2
                                for n in range(3)))
    triangles = []
    for k in range(len(stations) - 1):
        for i in range(2):
            a, b, c, d = 3 * k + i, 3 * k + i + 1, 3 * k + i + 4, 3 * k + i + 3
            triangles += [(a, b, c), (a, c, d)]
    return Surface(points, triangles)


def panel_with_holes(us, vs, holes, place, thickness):
    """A wall in (u, v) with rectangular holes (u0, v0, u1, v1) as one closed skin with reveals.

    us, vs     outer limits (low, high) [m]
    place      (u, v, w) -> point, right-handed; w = 0 is the face towards the room, w = -thickness the other
    """
    cuts_u = sorted({*us, *(h[0] for h in holes), *(h[2] for h in holes)})
    cuts_v = sorted({*vs, *(h[1] for h in holes), *(h[3] for h in holes)})

    def solid(i, j):
        if not (0 <= i < len(cuts_u) - 1 and 0 <= j < len(cuts_v) - 1):
            return False
        u, v = (cuts_u[i] + cuts_u[i + 1]) / 2, (cuts_v[j] + cuts_v[j + 1]) / 2
        return not any(h[0] < u < h[2] and h[1] < v < h[3] for h in holes)

    faces = []
    for i in range(len(cuts_u) - 1):
        for j in range(len(cuts_v) - 1):
            if not solid(i, j):
                continue
            u0, u1, v0, v1, w = cuts_u[i], cuts_u[i + 1], cuts_v[j], cuts_v[j + 1], -thickness
            faces.append(quad(place(u0, v0, 0), place(u1, v0, 0), place(u1, v1, 0), place(u0, v1, 0)))
            faces.append(quad(place(u0, v1, w), place(u1, v1, w), place(u1, v0, w), place(u0, v0, w)))
            if not solid(i - 1, j):
                faces.append(quad(place(u0, v0, w), place(u0, v0, 0), place(u0, v1, 0), place(u0, v1, w)))
            if not solid(i + 1, j):
                faces.append(quad(place(u1, v0, 0), place(u1, v0, w), place(u1, v1, w), place(u1, v1, 0)))
            if not solid(i, j - 1):
                faces.append(quad(place(u0, v0, w), place(u1, v0, w), place(u1, v0, 0), place(u0, v0, 0)))
            if not solid(i, j + 1):
                faces.append(quad(place(u0, v1, 0), place(u1, v1, 0), place(u1, v1, w), place(u0, v1, w)))
    return joined(faces)


def shade(surface, crease_deg=42.0):
    """Splits a Surface into vertices with normals: faces that meet at less than the crease angle shade smoothly.

    returns  (positions, normals, triangles); slivers without area are dropped
    """
    weld = {}
    corner = [weld.setdefault(tuple(round(c * 1e6) for c in p), len(weld)) for p in surface.points]
    where = {}
    for index, c in enumerate(corner):
        where.setdefault(c, surface.points[index])
    faces = []
    for triangle in surface.triangles:
        a, b, c = (corner[i] for i in triangle)
        area = _cross(_minus(where[b], where[a]), _minus(where[c], where[a]))
        if len({a, b, c}) == 3 and _length(area) > 1e-10:
            faces.append(((a, b, c), area))
    around = {}
    for index, (triangle, _) in enumerate(faces):
        for c in triangle:
            around.setdefault(c, []).append(index)
    limit, units = math.cos(math.radians(crease_deg)), [_unit(area) for _, area in faces]
    positions, normals, triangles, known = [], [], [], {}
    for index, (triangle, _) in enumerate(faces):
        out = []
        for c in triangle:
            total = (0.0, 0.0, 0.0)
            for other in around[c]:
                if _dot(units[index], units[other]) >= limit:
                    total = _plus(total, faces[other][1])
            normal = _unit(total)
            key = (c, tuple(round(n * 1e4) for n in normal))
            if key not in known:
                known[key] = len(positions)
                positions.append(where[c])
                normals.append(normal)
            out.append(known[key])
        triangles.append(tuple(out))
    return positions, normals, triangles


def _plus(a, b):
    return (a[0] + b[0], a[1] + b[1], a[2] + b[2])


def _minus(a, b):
    return (a[0] - b[0], a[1] - b[1], a[2] - b[2])


def _times(a, s):
    return (a[0] * s, a[1] * s, a[2] * s)


def _dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def _cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def _length(a):
    return math.sqrt(_dot(a, a))


def _unit(a):
    length = _length(a)
    return (a[0] / length, a[1] / length, a[2] / length)
