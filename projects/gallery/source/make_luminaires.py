#!/usr/bin/env python3
"""Writes the photometric files of the gallery: python3 make_luminaires.py

The luminaires are inventions with the manners of real ones: a formula each, see ../../common/photometry.py.
"""
import math
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "common"))
from photometry import ies_text, ldt_text, sampled, steps, thrown

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "luminaires"


def spot(half_beam_deg):
    """A reflector with a lens: a Gaussian of the stated half-value angle and a faint, shielded halo."""
    def intensity(v, h):
        if v >= 90:
            return 0.0
        core = 0.5 ** ((v / half_beam_deg) ** 2)
        halo = 0.010 * math.exp(-((v / (3.2 * half_beam_deg + 6)) ** 2))
        return (core + halo) * math.cos(math.radians(v)) ** 0.5
    return intensity


def wall_washer(v, h):
    """W: a lens washer thrown towards h = 90, 30 degrees off the nadir, wide along the wall."""
    if v >= 90:
        return 0.0
    cv, throw, spread = thrown(v, h)
    width = 21.0 if throw > 30 else 16.0
    return math.exp(-((throw - 30) / width) ** 2) * math.exp(-(spread / 36.0) ** 2) * min(1.0, cv / 0.30)


def verticals(half_beam_deg):
    """Half-degree steps across the beam, wider ones beyond: a linear interpolation then stays within 1 % of it."""
    fine = 0.5 if half_beam_deg < 10 else 1.0
    edge = math.ceil(4 * half_beam_deg / 5) * 5
    return steps(0, edge, fine) + steps(edge + 2.5, 90, 2.5)


def write_spot(file, name, number, half_beam_deg, lumens, watts, opening):
    v = verticals(half_beam_deg)
    table = sampled(spot(half_beam_deg), v, [0.0], lumens, copies=1)
    text = ies_text(name, number, lumens, watts, f"-{opening} -{opening} 0", v, [0.0], table, lamp="LED 3000 K, Ra > 95")
    (FOLDER / file).write_bytes(text.encode("latin-1"))
    print(f"{file}: {table[0][0]:.0f} cd in the axis")


def write_washer():
    gammas = steps(0, 90, 2.5)
    table = sampled(wall_washer, gammas, steps(270, 450, 5), 1300, copies=2)      # Isym 3 stores C270, through C0, to C90
    text = ldt_text("Lens wall washer, asymmetric", "LXD-GA-W", "w_wall_washer.ldt", 3, 1300, 12, (160, 120, 60, 140, 100),
                    steps(0, 355, 5), gammas, table, 100.0)
    (FOLDER / "w_wall_washer.ldt").write_bytes(text.encode("latin-1"))
    print("w_wall_washer.ldt")


if __name__ == "__main__":
    FOLDER.mkdir(exist_ok=True)
    write_spot("n_spot_12.ies", "Track spot, narrow 12 degrees", "LXD-GA-N", 6, 420, 5, 0.06)
    write_spot("m_spot_24.ies", "Track spot, medium 24 degrees", "LXD-GA-M", 12, 700, 8, 0.08)
    write_spot("f_spot_40.ies", "Track spot, flood 40 degrees", "LXD-GA-F", 20, 1000, 11, 0.08)
    write_spot("s_showcase.ies", "Showcase spot, 30 degrees", "LXD-GA-S", 15, 90, 1.2, 0.018)
    write_washer()
