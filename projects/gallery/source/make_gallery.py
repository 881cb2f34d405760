#!/usr/bin/env python3
"""Builds projects/gallery/gallery.glb: python3 make_gallery.py (Python 3.11, standard library; same bytes every run).

project.toml is read first: its [[material]] tables name the materials, and its [[luminaire]] tables say where a
spot hangs and where it looks. Metres, z up, the origin in the south-west corner on the floor.
"""
import pathlib
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
import room
import works
from glb import GlbFile
from luminaire_bodies import BODIES
from placing import Counter

PROJECT = pathlib.Path(__file__).resolve().parent.parent
EYE = 1.55                                       # of every flat work's middle above the floor
OILS = [(2.0, 1.5, 1.1), (4.4, 1.1, 1.3), (6.8, 1.7, 1.2), (9.3, 1.0, 1.3)]          # x, width, height on the north wall
PAPERS = [2.2, 3.6, 5.0, 6.4, 7.8]               # x on the south wall, each 0.70 x 0.90
PALETTES = [("oil red", "oil ochre", "oil cream", "oil blue"), ("oil green", "oil cream", "oil black", "oil ochre"),
            ("oil blue", "oil cream", "oil red", "oil green", "oil cream"), ("oil ochre", "oil cream", "oil black", "oil red")]


def hang_works(glb):
    n = Counter(glb)
    for k, (x, width, height) in enumerate(OILS):
        n.place("Oil painting", works.painting(width, height, PALETTES[k], 60 + k), x, room.WIDTH, EYE - height / 2)
        n.place("Label", works.label(k), x + width / 2 + 0.22, room.WIDTH, 1.20)
    for k, x in enumerate(PAPERS):
        n.place("Work on paper", works.drawing(0.70, 0.90, 20 + k), x, 0.0, EYE - 0.45, turn_deg=180)
        n.place("Label", works.label(10 + k), x - 0.55, 0.0, 1.20, turn_deg=180)
    glb.place("Textile", works.textile(2.4, 1.8), 0.0, 3.75, EYE - 0.9, turn_deg=90)
    n.place("Label", works.label(20), 0.0, 5.35, 1.20, turn_deg=90)
    for k, y in enumerate((2.95, 4.35)):
        n.place("Photograph", works.photograph(1.0, 0.75, 31 + k), room.PARTITION[0], y, EYE - 0.375, turn_deg=-90)
    n.place("Label", works.label(21), room.PARTITION[0], 2.32, 1.20, turn_deg=-90)
    glb.place("Mirror", works.mirror(1.15, 2.10), room.LENGTH, 6.35, 0.45, turn_deg=-90)


def stand_works(glb):
    n, tall, low = Counter(glb), works.plinth(0.45, 1.0), works.plinth(0.60, 0.75)
    for thing, name, x, y, plinth, top in ((works.knot(), "Bronze knot", 3.1, 4.30, tall, 1.0), (works.twist(), "Marble twist", 7.3, 5.35, low, 0.75),
                                           (works.stones(), "Granite stones", 10.6, 4.6, low, 0.75)):
        n.place("Plinth", plinth, x, y)
        glb.place(name, thing, x, y, top, turn_deg=25)
    glb.place("Showcase", works.showcase(), 4.70, 3.05)
    glb.place("Vessels", works.vessels(), 4.70, 3.05, works.SHOWCASE[2])
    glb.place("Bench", works.bench(), 7.05, 2.75, turn_deg=90)


def hang_luminaires(glb, project):
    n = Counter(glb)
    for table in project["luminaire"]:
        x, y, z = table["position"]
        n.place(f"Luminaire {table['type']}", BODIES[table['type']](table['aim'], room.TRACK - z), x, y, z, turn_deg=table.get('rotation_deg', 0))


def main():
    project = tomllib.loads((PROJECT / "project.toml").read_text(encoding="utf-8"))
    glb = GlbFile("gallery", {table["name"]: table for table in project["material"]})
    for part in (room.shell, room.skirting, room.partition, room.door, room.tracks):
        part(glb.place)
    hang_works(glb)
    stand_works(glb)
    hang_luminaires(glb, project)
    glb.finish(PROJECT)


if __name__ == "__main__":
    main()
