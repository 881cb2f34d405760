#!/usr/bin/env python3
"""Writes the four photometric files of the office: python3 make_luminaires.py

The luminaires are inventions with the manners of real ones: a formula each, see photometry.py.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
from photometry import ies_text, ldt_text, percent_down, sampled, steps, thrown

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "luminaires"


def microprism_panel(v, h):
    """A: batwing, shoulders at 30 degrees, little above 65 (for UGR), slightly wider along the diagonals."""
    if v >= 90:
        return 0.0
    shoulder = 1 + 0.32 * math.sin(math.radians(2 * v)) ** 2 * (1 + 0.10 * math.sin(math.radians(2 * h)) ** 2)
    return shoulder * math.cos(math.radians(v)) / (1 + math.exp((v - 61) / 5.5))


def edge_lit_pendant(v, h):
    """B: 56 % down with microprisms, 44 % up as a wide batwing that keeps the ceiling even."""
    across = math.cos(math.radians(h)) ** 2          # 1 in the transverse plane C0
    if v < 90:
        shape = (1 + (0.18 + 0.20 * across) * math.sin(math.radians(2 * v)) ** 2)
        return shape * math.cos(math.radians(v)) / (1 + math.exp((v - 63) / 5.0))
    if v > 90:
        w = 180 - v
        return 0.42 * math.cos(math.radians(w)) * (1 + (1.0 + 0.9 * across) * math.sin(math.radians(w)) ** 2)
    return 0.0


def downlight(v, h):
    """C: a 70 degree reflector beam, shielded from 60 degrees."""
    if v >= 90:
        return 0.0
    return math.cos(math.radians(v)) * (math.exp(-((v / 36.0) ** 2.6)) + 0.004)


def wall_washer(v, h):
    """D: thrown towards h = 90, 28 degrees off the nadir; the mirror plane is h = 90 - 270."""
    if v >= 90:
        return 0.0
    cv, throw, spread = thrown(v, h)
    width = 19.0 if throw > 28 else 21.0
    rim = min(1.0, cv / 0.30)                        # the luminance stays finite up to the horizontal
    return math.exp(-((throw - 28) / width) ** 2) * math.exp(-(spread / 34.0) ** 2) * rim


def write(file, text):
    (FOLDER / file).write_bytes(text.encode("latin-1"))


def write_panel():
    v, h = steps(0, 90, 2.5), steps(0, 90, 5)
    table = sampled(microprism_panel, v, h, 3000, copies=4)
    write("a_panel.ies", ies_text("Recessed LED panel 600 x 600, microprismatic", "LXD-A", 3000, 23,
                                  "0.57 0.57 0", v, h, table))


def write_pendant():
    gammas, stored = steps(0, 180, 2.5), steps(0, 90, 5)
    table = sampled(edge_lit_pendant, gammas, stored, 3200, copies=4)
    percent = percent_down(gammas, stored, table, 4, 3200)
    write("b_pendant.ldt", ldt_text("Edge-lit pendant 1500, direct and indirect", "LXD-B", "b_pendant.ldt", 4, 3200, 24,
                                    (1540, 200, 8, 1490, 150), steps(0, 355, 5), gammas, table, percent))


def write_downlight():
    v = steps(0, 90, 2.5)
    table = sampled(downlight, v, [0.0], 950, copies=1)
    write("c_downlight.ies", ies_text("Downlight 200, reflector, 70 degrees", "LXD-C", 950, 8,
                                      "-0.2 -0.2 0", v, [0.0], table))


def write_washer():
    gammas = steps(0, 90, 2.5)
    turn = [c % 360 for c in steps(270, 450, 5)]     # Isym 3 stores C270, through C0, to C90
    table = sampled(wall_washer, gammas, steps(270, 450, 5), 1500, copies=2)
    assert len(turn) == len(table) == 37
    write("d_wall_washer.ldt", ldt_text("Wall washer, asymmetric", "LXD-D", "d_wall_washer.ldt", 3, 1500, 12.5,
                                        (220, 220, 90, 180, 180), steps(0, 355, 5), gammas, table, 100.0))


if __name__ == "__main__":
    write_panel()
    write_pendant()
    write_downlight()
    write_washer()
    print("wrote", ", ".join(sorted(p.name for p in FOLDER.iterdir())))
