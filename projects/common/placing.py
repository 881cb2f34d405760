"""Where the scripts of the sample projects put things."""


class Counter:
    """Numbers things of a kind: 'Desk 01', 'Desk 02' ..."""

    def __init__(self, glb):
        self.glb, self.count = glb, {}

    def place(self, kind, thing, *where, **more):
        self.count[kind] = self.count.get(kind, 0) + 1
        self.glb.place(f"{kind} {self.count[kind]:02d}", thing, *where, **more)


def luminaire_positions(project):
    """(type, x, y, z, rotation) of every luminaire, arrays unrolled."""
    for table in project["luminaire"]:
        (nx, ny), (dx, dy) = table.get("array", {"count": [1, 1]})["count"], table.get("array", {}).get("spacing", [0, 0])
        x, y, z = table["position"]
        for j in range(ny):
            for i in range(nx):
                yield table["type"], x + i * dx, y + j * dy, z, table.get("rotation_deg", 0.0)


def hang_luminaires(glb, project, body_of, ceiling):
    numbered, bodies = Counter(glb), {}
    for kind, x, y, z, turn in luminaire_positions(project):
        key = (kind, round(z, 4))
        if key not in bodies:
            bodies[key] = body_of[kind](ceiling - z)
        numbered.place(f"Luminaire {kind}", bodies[key], x, y, z, turn_deg=turn)
