"""Writes photometric files from formulas: IES LM-63-2002 and EULUMDAT. Standard library only.

Each distribution is a formula I(v, h), sampled on a fine grid and scaled so that the *bilinear interpolation* of the
samples, integrated exactly, gives the stated lumens. Type C throughout: v from the nadir, h counter-clockwise, h = 0
towards +x.
"""
import math

DATE = "2025-01-15"


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


def ies_text(name, number, lumens_field, watts, opening, verticals, horizontals, table, lamp="LED 4000 K, Ra > 80"):
    """LM-63-2002, type C, metres, one lamp (lumens_field -1: absolute photometry)."""
    def wrapped(values, form):
        items = [form.format(value) for value in values]
        return [" ".join(items[i:i + 12]) for i in range(0, len(items), 12)]

    lines = ["IESNA:LM-63-2002", f"[TEST] {number}", "[TESTLAB] computed from a formula: source/make_luminaires.py",
             f"[ISSUEDATE] {DATE}", "[MANUFAC] Luxdeck sample", f"[LUMCAT] {number}", f"[LUMINAIRE] {name}",
             f"[LAMP] {lamp}", "[MAINTCAT] 5", "TILT=NONE",
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


def thrown(v, h):
    """cos v, and the angles towards h = 90 [deg] and along h = 0 - 180."""
    sv, cv = math.sin(math.radians(v)), math.cos(math.radians(v))
    x, y = sv * math.cos(math.radians(h)), sv * math.sin(math.radians(h))
    return cv, math.degrees(math.atan2(y, cv)), math.degrees(math.asin(max(-1.0, min(1.0, x))))


def percent_down(gammas, stored, table, copies, lumens):
    down = [[i if g < 90 else 0.0 for g, i in zip(gammas, row)] for row in table]
    return 100 * exact_lumens(gammas, stored, down) * copies / lumens
