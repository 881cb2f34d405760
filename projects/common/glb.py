"""Writes a binary glTF 2.0 file: named nodes that share meshes, named materials. Standard library only."""
import json
import math
import struct

from shapes import shade


class Thing:
    """What a designer calls one thing: surfaces by material name, in its own coordinates (z up)."""

    def __init__(self):
        self.parts = {}

    def add(self, material, *surfaces):
        for surface in surfaces:
            before = self.parts.get(material)
            self.parts[material] = surface if before is None else before + surface
        return self


class GlbFile:
    """Collects things and where they stand, then writes them.

    A Thing placed several times is stored once (glTF instancing). glTF's y is up: (x, y, z) -> (x, z, -y).
    """

    def __init__(self, name, materials):
        self.name = name                      # of the project: its folder's
        self.materials = materials            # name -> [[material]] table of project.toml
        self.material_index = {name: i for i, name in enumerate(materials)}
        self.blob = bytearray()
        self.views, self.accessors, self.meshes, self.nodes = [], [], [], []
        self.mesh_of = {}                     # id(thing) -> mesh index
        self.mesh_triangles = []
        self.kept = []                        # keeps things alive so that an id is never reused

    def place(self, name, thing, x=0.0, y=0.0, z=0.0, turn_deg=0.0):
        """Stands a Thing at (x, y, z) [m], turned about z."""
        node = {"name": name, "mesh": self._mesh(thing, name)}
        if x or y or z:
            node["translation"] = [round(x, 6), round(z, 6), round(-y, 6)]
        if turn_deg:
            half = math.radians(turn_deg) / 2
            node["rotation"] = [0.0, math.sin(half), 0.0, math.cos(half)]
        self.nodes.append(node)

    def triangle_count(self):
        return sum(self.mesh_triangles[node["mesh"]] for node in self.nodes)

    def write(self, path):
        document = {
            "asset": {"version": "2.0", "generator": f"projects/{self.name}/source/make_{self.name}.py"},
            "extensionsUsed": ["KHR_materials_transmission"],
            "scene": 0, "scenes": [{"name": self.name, "nodes": list(range(len(self.nodes)))}],
            "nodes": self.nodes, "meshes": self.meshes,
            "materials": [_gltf_material(name, table) for name, table in self.materials.items()],
            "accessors": self.accessors, "bufferViews": self.views, "buffers": [{"byteLength": len(self.blob)}],
        }
        text = json.dumps(document, separators=(",", ":")).encode()
        text += b" " * (-len(text) % 4)
        data = bytes(self.blob)
        with open(path, "wb") as file:
            file.write(struct.pack("<4sII", b"glTF", 2, 12 + 8 + len(text) + 8 + len(data)))
            file.write(struct.pack("<I4s", len(text), b"JSON") + text)
            file.write(struct.pack("<I4s", len(data), b"BIN\0") + data)

    def finish(self, folder):
        """Writes <name>.glb into the project's folder and says what is in it."""
        path = folder / f"{self.name}.glb"
        self.write(path)
        print(f"{path.name}: {len(self.nodes)} objects, {self.triangle_count()} triangles, {path.stat().st_size / 1e6:.2f} MB")
        used = {primitive["material"] for mesh in self.meshes for primitive in mesh["primitives"]}
        unused = [name for name, index in self.material_index.items() if index not in used]
        if unused:
            print("materials never used:", ", ".join(unused))

    def _mesh(self, thing, name):
        if id(thing) in self.mesh_of:
            return self.mesh_of[id(thing)]
        primitives, count = [], 0
        for material, surface in thing.parts.items():
            positions, normals, triangles = shade(surface)
            count += len(triangles)
            primitives.append({
                "attributes": {"POSITION": self._vectors(positions, bounds=True), "NORMAL": self._vectors(normals)},
                "indices": self._indices(triangles, len(positions)), "material": self.material_index[material]})
        self.meshes.append({"name": name, "primitives": primitives})
        self.mesh_triangles.append(count)
        self.mesh_of[id(thing)] = len(self.meshes) - 1
        self.kept.append(thing)
        return self.mesh_of[id(thing)]

    def _vectors(self, rows, bounds=False):
        rows = [struct.unpack("<3f", struct.pack("<3f", x, z, -y)) for x, y, z in rows]
        view = self._view(b"".join(struct.pack("<3f", *row) for row in rows), 34962)
        accessor = {"bufferView": view, "componentType": 5126, "count": len(rows), "type": "VEC3"}
        if bounds:
            accessor["min"] = [min(row[n] for row in rows) for n in range(3)]
            accessor["max"] = [max(row[n] for row in rows) for n in range(3)]
        self.accessors.append(accessor)
        return len(self.accessors) - 1

    def _indices(self, triangles, vertex_count):
        short = vertex_count <= 65535
        flat = [i for triangle in triangles for i in triangle]
        view = self._view(struct.pack(f"<{len(flat)}{'H' if short else 'I'}", *flat), 34963)
        self.accessors.append({"bufferView": view, "componentType": 5123 if short else 5125,
                               "count": len(flat), "type": "SCALAR"})
        return len(self.accessors) - 1

    def _view(self, data, target):
        self.blob += b"\0" * (-len(self.blob) % 4)
        self.views.append({"buffer": 0, "byteOffset": len(self.blob), "byteLength": len(data), "target": target})
        self.blob += data
        return len(self.views) - 1


def _rgb(value):
    return [float(c) for c in value] if isinstance(value, list) else [float(value)] * 3


def _gltf_material(name, table):
    """The nearest metallic-roughness material, for programs that read the .glb without project.toml."""
    kind = table["kind"]
    colour = _rgb(table.get("specular", 0.9) if kind in ("metal", "mirror") else table.get("reflectance", 1.0))
    material = {"name": name, "doubleSided": True, "pbrMetallicRoughness": {
        "baseColorFactor": colour + [1.0], "metallicFactor": 1.0 if kind in ("metal", "mirror") else 0.0,
        "roughnessFactor": {"matte": 1.0, "mirror": 0.0, "glass": 0.0}.get(kind, table.get("roughness", 0.3))}}
    if kind == "glass":
        material["pbrMetallicRoughness"]["baseColorFactor"] = _rgb(table["transmittance"]) + [1.0]
        material["extensions"] = {"KHR_materials_transmission": {"transmissionFactor": 1.0}}
    return material
