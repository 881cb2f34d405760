#!/usr/bin/env python3
"""Writes the two photometric files of the classroom: python3 make_luminaires.py

The luminaires are inventions with the manners of real ones: a formula each, see ../../common/photometry.py.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
from photometry import ies_text, ldt_text, percent_down, sampled, steps, thrown

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "luminaires"


def linear_pendant(v, h):
    """A: four fifths down as a batwing across its length, shielded from 62 degrees; the rest lights the ceiling."""
    across = math.cos(math.radians(h)) ** 2          # 1 in the transverse plane C0
    if v < 90:
        shape = 1 + (0.10 + 0.45 * across) * math.sin(math.radians(2 * v)) ** 2
        return shape * math.cos(math.radians(v)) / (1 + math.exp((v - 62) / 5.0))
    if v > 90:
        w = math.radians(180 - v)
        return 0.13 * math.cos(w) * (1 + (0.8 + 0.8 * across) * math.sin(w) ** 2)
    return 0.0


def board_washer(v, h):
    """B: a line of light thrown towards h = 90, 30 degrees off the nadir; widths chosen for an even board."""
    if v >= 90:
        return 0.0
    cv, throw, spread = thrown(v, h)
    width = 22.0 if throw > 30 else 15.0
    rim = min(1.0, cv / 0.35)                        # the luminance stays finite up to the horizontal
    return math.exp(-((throw - 30) / width) ** 2) * math.cos(math.radians(spread)) ** 1.5 * rim


def write_pendant():
    gammas, stored = steps(0, 180, 2.5), steps(0, 90, 5)
    table = sampled(linear_pendant, gammas, stored, 2400, copies=4)
    percent = percent_down(gammas, stored, table, 4, 2400)
    text = ldt_text("Linear pendant 1200, direct and indirect", "LXD-CL-A", "a_pendant.ldt", 4, 2400, 18,
                    (1220, 120, 12, 1180, 90), steps(0, 355, 5), gammas, table, percent)
    (FOLDER / "a_pendant.ldt").write_bytes(text.encode("latin-1"))
    print(f"a_pendant.ldt: {percent:.1f} % down")


def write_washer():
    v, h = steps(0, 90, 2.5), steps(90, 270, 5)      # LM-63 stores 90 .. 270 for a mirror plane through 90 and 270
    table = sampled(board_washer, v, h, 1700, copies=2)
    text = ies_text("Board washer 1200, asymmetric", "LXD-CL-B", 1700, 14, "0.06 1.14 0", v, h, table)
    (FOLDER / "b_board_washer.ies").write_bytes(text.encode("latin-1"))
    print("b_board_washer.ies")


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    write_pendant()
    write_washer()
