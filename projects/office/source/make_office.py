#!/usr/bin/env python3
"""Builds projects/office/office.glb: python3 make_office.py (Python 3.11, standard library; same bytes every run).

project.toml is read first: its [[material]] tables name the materials, and its [[luminaire]] tables say where a
housing hangs, so geometry and lighting cannot drift apart. Metres, z up, the origin in the room's south-west
corner on the floor; x runs along the window wall, y towards the corridor wall.
"""
import math
import pathlib
import random
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
import furniture as f
import plants
import room
import seating
from glb import GlbFile
from placing import Counter, hang_luminaires, luminaire_positions
from luminaire_bodies import BODIES

PROJECT = pathlib.Path(__file__).resolve().parent.parent
BENCHES = [(2.0, 1.0, 3, "felt petrol"), (5.6, 1.0, 3, "felt ochre"), (9.2, 1.0, 2, "felt petrol")]  # x, y0, desks a side
DESK_WIDTH, DESK_DEPTH = 1.6, 0.8


def tiles_taken_by_panels(project):
    return {(math.floor(x / room.TILE), math.floor(y / room.TILE))
            for kind, x, y, _, _ in luminaire_positions(project) if kind == "A"}


def build_room(glb, project):
    for part in (room.slabs, room.walls, room.floor_finishes, room.skirting, room.windows, room.radiators,
                 room.columns, room.entrance, room.glass_walls):
        part(glb.place)
    room.ceiling_tiles(glb.place, tiles_taken_by_panels(project))
    outlet, numbered = room.air_outlet(), Counter(glb)
    for x, y in ((2.7, 5.7), (5.7, 0.9), (8.7, 5.7), (12.3, 4.5), (12.3, 6.9)):
        numbered.place("Air outlet", outlet, x, y)


def furnish_benches(glb):
    """Face-to-face benches across the window wall; each workplace has a user's own mixture of things."""
    n, dice = Counter(glb), random.Random(18)
    desk, pedestal, monitor, keys = f.desk(DESK_WIDTH, DESK_DEPTH), f.pedestal(), f.monitor(), f.keyboard_and_mouse()
    chairs = {fabric: seating.task_chair(fabric) for fabric in ("fabric charcoal", "fabric petrol", "fabric ochre")}
    mugs = {colour: f.mug(colour) for colour in ("ceramic white", "ceramic blue", "ceramic red")}
    extras = {"Papers": f.papers(3), "Notebook": f.notebook(), "Laptop": f.laptop()}
    cactus, basket = plants.snake_plant(21, "pot ceramic grey", 9, 0.26, 0.055, 0.09), f.waste_bin()
    for centre, y0, count, felt in BENCHES:
        screen = f.divider(DESK_WIDTH, felt)
        for k in range(count):
            y = y0 + DESK_WIDTH * (k + 0.5)
            n.place("Divider", screen, centre, y - DESK_WIDTH / 2, f.DESK_HEIGHT + 0.02, turn_deg=90)
            for turn in (-90, 90):
                s = math.copysign(1, turn)                      # -1: user at -x looks towards +x

                def put(kind, thing, lx, ly, z, extra_turn=0.0):
                    """(lx, ly) in the desk's frame: x to the user's right, y away from the user."""
                    n.place(kind, thing, centre + s * (DESK_DEPTH - ly), y + s * lx, z, turn_deg=turn + extra_turn)

                put("Desk", desk, 0, 0, 0)
                put("Monitor", monitor, 0.0, 0.60, f.DESK_HEIGHT)
                put("Keyboard", keys, -0.04, 0.24, f.DESK_HEIGHT, dice.uniform(-3, 3))
                put("Pedestal", pedestal, -0.42, 0.37, 0)
                fabric = dice.choices(list(chairs), (6, 2, 1))[0]
                put("Chair", chairs[fabric], dice.uniform(-.06, .06), dice.uniform(-0.30, -0.10), 0, dice.uniform(-28, 28))
                put("Mug", mugs[dice.choice(list(mugs))], 0.50 + dice.uniform(-.04, .04), 0.60, f.DESK_HEIGHT, dice.uniform(0, 360))
                name = dice.choice(list(extras))
                put(name, extras[name], -0.52, 0.33, f.DESK_HEIGHT, dice.uniform(4, 16))
                if dice.random() < 0.4:
                    put("Desk plant", cactus, 0.62, 0.66, f.DESK_HEIGHT, dice.uniform(0, 360))
        for s in (-1, 1):
            n.place("Waste bin", basket, centre + s * 0.45, y0 + DESK_WIDTH * count + 0.22)


def furnish_meeting_room(glb):
    n, x, y = Counter(glb), 12.3, 7.1
    glb.place("Meeting table", f.meeting_table(), x, y)
    chairs = [seating.meeting_chair("shell ochre"), seating.meeting_chair("shell grey")]
    seats = [(dx, side) for side in (-1, 1) for dx in (-0.78, 0.0, 0.78)]
    for k, (dx, side) in enumerate(seats):
        n.place("Meeting chair", chairs[k % 2], x + dx, y + side * 0.74, turn_deg=(0 if side < 0 else 180) + (7, -5, 3, -8, 4, 11)[k])
    n.place("Meeting chair", chairs[0], x - 1.42, y, turn_deg=-84)
    n.place("Meeting chair", chairs[1], x + 1.42, y, turn_deg=96)
    glb.place("Whiteboard", room.whiteboard(), x, room.WIDTH, 0.9)
    glb.place("Meeting screen", room.wall_screen(), room.LENGTH, y, 1.40, turn_deg=-90)
    glb.place("Plant snake 01", plants.snake_plant(4), 14.0, 5.82)
    glb.place("Meeting mug 01", f.mug("ceramic white"), x - 0.7, y - 0.30, f.DESK_HEIGHT)
    glb.place("Meeting mug 02", f.mug("ceramic blue"), x + 0.35, y + 0.30, f.DESK_HEIGHT, turn_deg=160)
    glb.place("Meeting laptop", f.laptop(), x + 0.72, y - 0.26, f.DESK_HEIGHT, turn_deg=4)
    glb.place("Meeting papers", f.papers(9), x - 0.05, y - 0.32, f.DESK_HEIGHT)


def furnish_storage(glb):
    """Along the corridor: cabinets under pictures, bookcases; low bookcases end the benches."""
    n = Counter(glb)
    cabinet = f.credenza(1.78)
    prints = [("print ochre", "print petrol", "print terracotta"), ("print petrol", "print ink", "print ochre"),
              ("print terracotta", "print ink", "print petrol")]
    for k, x in enumerate((3.3, 5.1, 6.9)):
        n.place("Cabinet", cabinet, x, room.WIDTH - 0.013)
        n.place("Picture", f.picture(1.1, 0.8, prints[k], 30 + k), x, room.WIDTH, 1.42)
    n.place("Bookcase", f.bookcase(1.6, 2.1, 6, 41), 8.9, room.WIDTH - 0.013)
    n.place("Bookcase", f.bookcase(1.8, 2.1, 6, 42), 0.013, 6.6, turn_deg=90)
    n.place("Low bookcase", f.bookcase(1.8, 1.12, 3, 51), 5.6, 6.60)
    n.place("Low bookcase", f.bookcase(1.8, 1.12, 3, 61), 5.6, 6.602, turn_deg=180)
    n.place("Low bookcase", f.bookcase(1.8, 1.12, 3, 70), 9.0, 5.40)
    for k, (x, y, z) in enumerate(((6.1, 6.6, 1.12), (8.5, 5.22, 1.12), (3.9, 8.77, 1.055))):
        n.place("Pot plant", plants.snake_plant(80 + k, "pot ceramic white", 13, 0.46, 0.095, 0.16), x, y, z)
    glb.place("Coat stand", f.coat_stand(), 0.42, 8.45)


def furnish_lounge(glb):
    """A sofa, two armchairs and a low table on a rug, between the windows and the meeting room."""
    glb.place("Rug", room.rug(), 12.65, 2.55)
    glb.place("Sofa", seating.sofa(2.1, "fabric petrol"), 12.65, 1.02)
    glb.place("Armchair 01", seating.sofa(0.95, "fabric ochre"), 13.75, 3.25, turn_deg=118)
    glb.place("Armchair 02", seating.sofa(0.95, "fabric ochre"), 12.25, 4.05, turn_deg=186)
    glb.place("Coffee table 01", f.coffee_table(0.42), 12.60, 2.45, 0.0105)
    glb.place("Coffee table 02", f.coffee_table(0.28), 13.22, 2.10, 0.0105, turn_deg=50)
    glb.place("Lounge mug", f.mug("ceramic red"), 12.72, 2.58, 0.4105, turn_deg=30)
    glb.place("Lounge notebook", f.notebook(), 12.45, 2.35, 0.4105, turn_deg=24)
    glb.place("Floor lamp", f.floor_lamp_off(), 11.35, 0.85)
    glb.place("Plant rubber tree 01", plants.rubber_tree(1, 1.75), 14.0, 0.62)
    glb.place("Plant palm 01", plants.palm(2, 1.95), 13.95, 4.75)
    glb.place("Plant rubber tree 02", plants.rubber_tree(5, 1.6), 7.4, 0.62)
    glb.place("Plant palm 02", plants.palm(6, 1.85), 8.05, 6.62)


def main():
    project = tomllib.loads((PROJECT / "project.toml").read_text(encoding="utf-8"))
    glb = GlbFile("office", {table["name"]: table for table in project["material"]})
    build_room(glb, project)
    furnish_benches(glb)
    furnish_meeting_room(glb)
    furnish_storage(glb)
    furnish_lounge(glb)
    hang_luminaires(glb, project, BODIES, room.CEILING)
    glb.finish(PROJECT)


if __name__ == "__main__":
    main()
