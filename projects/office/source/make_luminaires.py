#!/usr/bin/env python3
"""Writes the four photometric files of the office: python3 make_luminaires.py

The luminaires are inventions with the manners of real ones. Each distribution is a formula, sampled on a fine
grid and scaled so that the *bilinear interpolation* of the samples, integrated exactly, gives the stated lumens.
Type C throughout: v from the nadir, h counter-clockwise, h = 0 towards +x.
"""
import math
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "luminaires"
DATE = "2025-01-15"


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
    sv, cv = math.sin(math.radians(v)), math.cos(math.radians(v))
    x, y = sv * math.cos(math.radians(h)), sv * math.sin(math.radians(h))
    throw = math.degrees(math.atan2(y, cv))          # in the plane square to the wall
    spread = math.degrees(math.asin(max(-1.0, min(1.0, x))))
    width = 19.0 if throw > 28 else 21.0
    rim = min(1.0, cv / 0.30)                        # the luminance stays finite up to the horizontal
    return math.exp(-((throw - 28) / width) ** 2) * math.exp(-(spread / 34.0) ** 2) * rim


def exact_lumens(verticals, horizontals, table):
    """Flux of the bilinear interpolant over the given h range: closed form in v, trapezoid (exact) in h."""
    def over_v(row):
        total = 0.0
        for (v0, v1), (i0, i1) in zip(zip(verticals, verticals[1:]), zip(row, row[1:])):
            a, b = math.radians(v0), math.radians(v1)
            slope = (i1 - i0) / (b - a)
            # integral of (i0 + slope (t - a)) sin t from a to b
            total += i0 * (math.cos(a) - math.cos(b))
            total += slope * (math.sin(b) - math.sin(a) - (b - a) * math.cos(b))
        return total

    rows = [over_v(row) for row in table]
    if len(rows) == 1:
        return rows[0] * 2 * math.pi
    return sum((r0 + r1) / 2 * math.radians(h1 - h0)
               for r0, r1, h0, h1 in zip(rows, rows[1:], horizontals, horizontals[1:]))


def sampled(formula, verticals, horizontals, lumens, copies):
    """Rows by h of intensities [cd]; `copies` of the h range make the full turn."""
    table = [[formula(v, h) for v in verticals] for h in horizontals]
    scale = lumens / (exact_lumens(verticals, horizontals, table) * copies)
    return [[i * scale for i in row] for row in table]


def steps(first, last, step):
    return [first + step * i for i in range(round((last - first) / step) + 1)]


def ies_text(name, number, lumens_field, watts, opening, verticals, horizontals, table):
    """LM-63-2002, type C, metres, one lamp (lumens_field -1: absolute photometry)."""
    def wrapped(values, form):
        items = [form.format(value) for value in values]
        return [" ".join(items[i:i + 12]) for i in range(0, len(items), 12)]

    lines = ["IESNA:LM-63-2002", f"[TEST] {number}", "[TESTLAB] computed from a formula: source/make_luminaires.py",
             f"[ISSUEDATE] {DATE}", "[MANUFAC] Luxdeck sample", f"[LUMCAT] {number}", f"[LUMINAIRE] {name}",
             "[LAMP] LED 4000 K, Ra > 80", "[MAINTCAT] 5", "TILT=NONE",
             f"1 {lumens_field} 1 {len(verticals)} {len(horizontals)} 1 2 {opening}", f"1 1 {watts}"]
    lines += wrapped(verticals, "{:g}") + wrapped(horizontals, "{:g}")
    for row in table:
        lines += wrapped(row, "{:.2f}")
    return "\r\n".join(lines) + "\r\n"


def ldt_text(name, number, file, symmetry, lumens, watts, size_mm, planes, gammas, table, down_percent):
    """EULUMDAT, absolute LED photometry: lamp count -1, light output ratio 100 %, flux of the luminaire.

    size_mm  luminaire length, width, height, luminous length (along C90 - C270), width
    planes   all C angles of the full turn; `table` holds the rows that `symmetry` stores [cd]
    """
    length, width, height, lit_length, lit_width = size_mm
    lines = ["Luxdeck sample", 2 if symmetry == 4 else 3, symmetry, len(planes), f"{planes[1] - planes[0]:g}",
             len(gammas), f"{gammas[1] - gammas[0]:g}", "computed: source/make_luminaires.py", name, number, file, DATE,
             length, width, height, lit_length, lit_width, 0, 0, 0, 0,
             f"{down_percent:.1f}", "100.0", "1.0", "0", 1,
             -1, "LED", lumens, "4000 K", "80", watts]
    lines += ["0"] * 10                     # direct ratios: not given
    lines += [f"{c:g}" for c in planes] + [f"{g:g}" for g in gammas]
    lines += [f"{i * 1000 / lumens:.3f}" for row in table for i in row]
    return "\r\n".join(str(line) for line in lines) + "\r\n"


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
    down = [[i if g < 90 else 0.0 for g, i in zip(gammas, row)] for row in table]
    percent = 100 * exact_lumens(gammas, stored, down) * 4 / 3200
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
