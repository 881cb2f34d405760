#!/usr/bin/env python3
"""Builds projects/classroom/classroom.glb: python3 make_classroom.py (Python 3.11, standard library; same bytes every run).

project.toml is read first: its [[material]] tables name the materials, and its [[luminaire]] tables say where a
housing hangs. Metres, z up, the origin in the inner corner of board and window wall on the floor; x runs along the
windows away from the board (east), y from the windows to the door (north).
"""
import pathlib
import random
import sys
import tomllib

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
import furniture as f
import plants
import room
import school
import seating
from glb import GlbFile
from luminaire_bodies import BODIES
from placing import Counter, hang_luminaires

PROJECT = pathlib.Path(__file__).resolve().parent.parent
COLUMNS = (1.35, 3.60, 5.85)                     # y of the desks' middles
ROWS = (2.75, 4.15, 5.55, 6.95)                  # x of the desks' edges towards the sitters
TO_BOARD = 90                                    # turns things whose sitter looks to +y towards -x


def build_room(glb):
    for part in (room.shell, room.ceiling_tiles, room.floor, room.windows, room.entrance, room.blackboard):
        part(glb.place)


def furnish_desks(glb):
    """Twelve desks for two, a chair each, what pupils have on and beside them."""
    n, dice, desk = Counter(glb), random.Random(11), school.pupils_desk()
    chairs = [school.pupils_chair(shell) for shell in ("beech laminate", "shell ochre", "shell petrol")]
    books, bags = [school.exercise_books(k) for k in range(6)], [school.school_bag(k) for k in range(4)]
    for y in COLUMNS:
        for x in ROWS:
            n.place("Desk", desk, x, y, turn_deg=TO_BOARD)
            for side in (-1, 1):
                seat = y + side * 0.325
                chair = dice.choices(chairs, (6, 1, 1))[0]
                n.place("Chair", chair, x + dice.uniform(0.05, 0.13), seat + dice.uniform(-.03, .03), turn_deg=TO_BOARD + dice.uniform(-9, 9))
                if dice.random() < 0.8:
                    n.place("Books", dice.choice(books), x - 0.22, seat + dice.uniform(-.04, .04), school.DESK_HEIGHT,
                            turn_deg=TO_BOARD + dice.uniform(-8, 8))
            if dice.random() < 0.7:
                side = dice.choice((-1, 1))
                n.place("Bag", dice.choice(bags), x - 0.02 + dice.uniform(0, .05), y + side * (school.DESK_WIDTH / 2 + 0.14),
                        turn_deg=dice.uniform(-20, 20) + 90)


def furnish_front(glb):
    """The teacher's desk between board and windows, facing the class; a cabinet with the globe by the board."""
    glb.place("Teacher's desk", f.desk(), 1.25, 1.15, turn_deg=-90)
    glb.place("Teacher's chair", seating.task_chair("fabric petrol"), 1.03, 1.20, turn_deg=-112)
    glb.place("Teacher's laptop", f.laptop(), 1.55, 1.10, f.DESK_HEIGHT, turn_deg=-96)
    glb.place("Teacher's mug", f.mug("ceramic blue"), 1.80, 1.62, f.DESK_HEIGHT, turn_deg=40)
    glb.place("Teacher's papers", f.papers(3), 1.52, 0.68, f.DESK_HEIGHT, turn_deg=-80)
    glb.place("Waste bin", f.waste_bin(), 0.32, 0.50)
    glb.place("Front cabinet", f.credenza(1.2), 0.016, 6.45, turn_deg=90)
    glb.place("Globe", room.globe(), 0.23, 6.62, 1.055, turn_deg=30)
    glb.place("Front plant", plants.snake_plant(82, "pot ceramic white", 13, 0.46, 0.095, 0.16), 0.22, 6.12, 1.055)
    glb.place("Clock", room.wall_clock(), 0.0, 6.45, 2.35, turn_deg=90)


def furnish_walls(glb):
    """Cabinets and a bookcase at the back under a pin board; posters and hooks along the corridor wall."""
    n, cabinet, x = Counter(glb), f.credenza(1.78), room.LENGTH - 0.016
    for y in (1.45, 3.25, 5.05):
        n.place("Cabinet", cabinet, x, y, turn_deg=-90)
    glb.place("Bookcase", f.bookcase(1.0, 1.9, 5, 44), x, 6.55, turn_deg=-90)
    glb.place("Pin board 1", room.pin_board(4.4, 1.2, 5), room.LENGTH, 3.25, 1.30, turn_deg=-90)
    for k, (y, z) in enumerate(((0.75, 1.055), (5.62, 1.055))):
        n.place("Pot plant", plants.snake_plant(90 + k, "pot ceramic grey", 13, 0.42, 0.09, 0.15), x - 0.22, y, z)
    glb.place("Tall plant", plants.rubber_tree(3, 1.7), 8.62, 0.42)
    colours = [("print ochre", "print petrol", "print terracotta"), ("print petrol", "print ink", "print ochre")]
    for k, px in enumerate((1.7, 3.0)):
        n.place("Poster", f.picture(0.9, 1.15, colours[k], 50 + k), px, room.WIDTH, 1.15)
    glb.place("Pin board 2", room.pin_board(1.9, 1.1, 8), 5.35, room.WIDTH, 1.2)
    n.place("Hook rail", school.hook_rail(2.2, 9), 5.35, room.WIDTH, 0.98)


def main():
    project = tomllib.loads((PROJECT / "project.toml").read_text(encoding="utf-8"))
    glb = GlbFile("classroom", {table["name"]: table for table in project["material"]})
    build_room(glb)
    furnish_desks(glb)
    furnish_front(glb)
    furnish_walls(glb)
    hang_luminaires(glb, project, BODIES, room.CEILING)
    glb.finish(PROJECT)


if __name__ == "__main__":
    main()
