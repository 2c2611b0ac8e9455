#!/usr/bin/env python3
"""Fits the tables of the scaled modified Bessel functions, f64 and f32.

    python3 data/fits/bessel.py            writes src/special/bessel_tables.rs, src/shader/bessel_coefficients.rs and
                                           their rows in fits.csv
    python3 data/fits/bessel.py --check    exits 1 when a committed file or row differs

Needs mpmath (PyPI). Everything is computed with 40 digits and rounded once.

f64, with F(x) = e^-x I0(x) and A(x) = I1(x)/I0(x). Rows 0..95 of a table are cells about the centres c of 1 + x:
c = 2^j (1 + i/16), j = 0..5; a number belongs to the centre that rounding 1 + x to 5 bits gives. Rows 96..127 of the
table of F are cells of 1/(2 sqrt(2 pi m)) about m = 1 + i/16 and 2 + i/8. A row is the value at the centre in two
parts and powers 1..9 of the distance from it, interpolated at Chebyshev points. The first rows of A hold the
difference to x/2; row 0 is odd. With v = 1/x <= 1/62 the tails are F sqrt(2 pi x) = 1 + v T(v) and A = 1 - v U(v),
and for x^2 <= 16, I0(x) - 1 = x^2/4 + x^4 S(x^2).

f32: four pieces of F, each c + d P(d) with d = x - a, where a is chosen so that F(a) is almost an f32, and beyond
them, in two pieces again, F = (1 + t Q(t)) (1 + G(V))/sqrt(2 pi c 2^e) with x = c (1 + t) 2^e and V = 1/(2 pi x).
ln I0 and A are rational in x^2 below 4 and polynomials in 1/x above. All of level error (Lawson).
"""

import pathlib

import provenance
from mpmath import besseli, cos, exp, log, lu_solve, matrix, mp, mpf, pi, sqrt
from shader import digits, minimax_fit, to_single
from special import chebyshev_fit, column, rows, shift

mp.dps = 40
SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"
NEAR_ROWS, FAR_ROWS, DEGREE, TAIL_TERMS = 96, 32, 9, 8
LINEAR_ROWS = 10
TAIL = 62
LETTERS = "ABCDEFGHIJKL"


def scaled(x):
    return exp(-x) * besseli(0, x)


def ratio(x):
    return besseli(1, x) / besseli(0, x)


def cell(function, centre, low, high, base):
    """Powers 0..DEGREE of the distance from `centre` of function - base on [low, high], and the error."""
    middle = (low + high) / 2
    fit, error = chebyshev_fit(lambda x: function(x) - base, low, high, DEGREE + 1)
    return shift(fit, middle - centre), error


def bounds(row):
    """Centre of a cell of 1 + x, and what rounds to it."""
    width = mpf(2) ** (row // 16 - 4)
    centre = mpf(2) ** (row // 16) + row % 16 * width
    left = width / 4 if row % 16 == 0 else width / 2
    return centre, centre - left, centre + width / 2


def scaled_cells():
    table, worst = [], mpf(0)
    for row in range(NEAR_ROWS + FAR_ROWS):
        if row < NEAR_ROWS:
            centre, low, high = (y - 1 for y in bounds(row))
            function = scaled
        else:
            centre, low, high = bounds(row - NEAR_ROWS)
            function = lambda m: 1 / (2 * sqrt(2 * pi * m))
        low = max(low, mpf(0))
        base = float(function(centre))
        fit, error = cell(function, centre, low, high, mpf(base))
        if row == 0:
            fit[0] = mpf(0)
        worst = max(worst, error / function(high))
        table.append([base] + [float(c) for c in fit])
    return table, worst


def ratio_cells():
    table, worst = [], mpf(0)
    for row in range(NEAR_ROWS):
        centre, low, high = (y - 1 for y in bounds(row))
        if row == 0:
            cube = lambda u: (ratio(sqrt(u)) / sqrt(u) - mpf(1) / 2) / u if u else -mpf(1) / 16
            odd, error = chebyshev_fit(cube, mpf(0), high**2, 4)
            odd = shift(odd, high**2 / 2)
            fit = [mpf(0)] * (DEGREE + 1)
            fit[3:10:2] = odd
            base, error = 0.0, error * high**2
        elif row < LINEAR_ROWS:
            base = 0.0
            fit, error = cell(lambda x: ratio(x) - x / 2, centre, low, high, mpf(0))
            error /= ratio(low)
        else:
            base = float(ratio(centre))
            fit, error = cell(ratio, centre, low, high, mpf(base))
            error /= ratio(low)
        worst = max(worst, error)
        table.append([base] + [float(c) for c in fit])
    return table, worst


def tails():
    v_top = mpf(1) / TAIL

    def growth(v):
        return (scaled(1 / v) * sqrt(2 * pi / v) - 1) / v if v > mpf(10) ** -10 else mpf(1) / 8

    def deficit(v):
        return (1 - ratio(1 / v)) / v if v > mpf(10) ** -10 else mpf(1) / 2

    def series(u):
        # sum u^k / (4^k k!^2) from k = 2, over u^2
        term, total, k = mpf(1) / 64, mpf(0), 2
        while term > mpf(10) ** -38:
            total += term
            k += 1
            term *= u / (4 * k * k)
        return total

    out = []
    for function, top, terms in ((growth, v_top, TAIL_TERMS), (deficit, v_top, TAIL_TERMS), (series, mpf(16), DEGREE + 1)):
        fit, error = chebyshev_fit(function, mpf(0), top, terms)
        out.append(([float(c) for c in shift(fit, top / 2)], error))
    return out


def table(name, values, doc):
    out = f"/// {doc}\n#[rustfmt::skip]\npub(super) const {name}: [[f64; {DEGREE + 2}]; {len(values)}] = [\n"
    for row in values:
        out += "    [\n" + rows(row, "        ") + "    ],\n"
    return out + "];\n\n"


def special_text():
    f, f_error = scaled_cells()
    a, a_error = ratio_cells()
    (t, t_error), (u, u_error), (s, s_error) = tails()
    n = lambda error: mp.nstr(error, 2)
    out = "// Written by data/fits/bessel.py; do not edit.\n"
    out += "//! Tables of the f64 scaled modified Bessel functions.\n\n"
    out += f"/// Where the tails take over from the cells.\npub(super) const TAIL: f64 = {float(TAIL)!r};\n\n"
    out += f"/// Rows of cells of 1 + x; those behind them in `SCALED` are cells of a square root.\npub(super) const NEAR_ROWS: u64 = {NEAR_ROWS};\n\n"
    out += f"/// Rows of `RATIO` that hold the difference to x/2.\npub(super) const LINEAR_ROWS: u64 = {LINEAR_ROWS};\n\n"
    out += table("SCALED", f, f"e^-x I0(x), then 1/(2 sqrt(2 pi m)): value, and powers 0 to 9; fit error {n(f_error)} relative.")
    out += table("RATIO", a, f"I1(x)/I0(x): value, and powers 0 to 9; fit error {n(a_error)} relative.")
    out += column("SCALED_TAIL", t, f"(e^-x I0(x) sqrt(2 pi x) - 1) x in powers of 1/x; fit error {n(t_error)} absolute.")
    out += column("RATIO_TAIL", u, f"(1 - I1(x)/I0(x)) x in powers of 1/x; fit error {n(u_error)} absolute.")
    out += column("SERIES", s, f"(I0(x) - 1 - x^2/4)/x^4 in powers of x^2; fit error {n(s_error)} absolute.")
    return out.rstrip("\n") + "\n"


def almost_single(function, near, spacing, count):
    """The f32 a beside `near` whose function value is closest to an f32, relative to its unit; that f32 is given too."""
    best = None
    for k in range(-count, count + 1):
        a = to_single(near + k * spacing)
        distances = []
        singles = []
        for value in function(mpf(a)):
            single = to_single(value)
            unit = mpf(2) ** (mp.floor(log(value, 2)) - 23)
            distances.append(abs(value - mpf(single)) / unit)
            singles.append(single)
        if best is None or max(distances) < best[0]:
            best = (max(distances), a, singles)
    return best[1], best[2]


def constants(prefix, values, doc):
    named = zip(LETTERS, values)
    return "".join(f"/// {doc}\npub(super) const {prefix}_{k}: f32 = {digits(v)};\n" for k, v in named) + "\n"


def one(name, value, doc):
    return f"/// {doc}\npub(super) const {name}: f32 = {digits(value)};\n\n"


# Name, ends, where about the value is taken, terms behind it.
SCALED_PIECES = (
    ("BESSEL_FIRST", 0, "0.36", "0.165", 7),
    ("BESSEL_SECOND", "0.36", "0.86", "0.57", 7),
    ("BESSEL_THIRD", "0.86", "1.6", "1.18", 7),
    ("BESSEL_FOURTH", "1.6", 3, "2.3", 9),
)
LOG_PIECES = (
    ("BESSEL_LOG_FIRST", 1, "1.5", "1.25", 6),
    ("BESSEL_LOG_SECOND", "1.5", "2.4", "1.9", 7),
    ("BESSEL_LOG_THIRD", "2.4", 4, "3.2", 7),
)
RATIO_PIECES = (
    ("BESSEL_RATIO_FIRST", 1, 2, "1.5", 7),
    ("BESSEL_RATIO_SECOND", 2, 4, 3, 8),
)
OUTER_END = mpf("6.5")
# Where the tails of ln I0 and of A begin.
BORDER = mpf(4)


def pieces(table, function, symbol):
    """The constants of functions c + (x - a) P(x - a)."""
    out = ""
    for name, low, high, near, terms in table:
        low, high, near = mpf(low), mpf(high), float(near)
        spacing = 2.0 ** (mp.floor(log(near, 2)) - 23)
        a, (c,) = almost_single(lambda x: [function(x)], near, spacing, 400)

        def slope(x):
            x = x if abs(x - a) > mpf(10) ** -12 else x + mpf(10) ** -12
            return (function(x) - mpf(c)) / (x - a)

        fit, error = minimax_fit(lambda d: slope(a + d), lambda d: d, low - a, high - a, terms)
        if high < BORDER:
            out += one(f"{name}_END", high, "Where the piece ends.")
        out += one(f"{name}_CENTRE", a, "a of the piece.")
        out += one(f"{name}_VALUE", c, f"c, {symbol} at a.")
        out += constants(name, fit, f"({symbol} - c)/(x - a) in x - a; within {mp.nstr(error, 2)} of {symbol}.")
    return out


def shader_text():
    n = lambda error: mp.nstr(error, 2)
    out = "// Written by data/fits/bessel.py; do not edit.\n"
    out += "//! Coefficients of the f32 scaled modified Bessel functions; the letters count powers upward.\n\n"
    out += pieces(SCALED_PIECES, scaled, "e^-x I0(x)")
    end = mpf(SCALED_PIECES[-1][2])

    # x = c (1 + t) 2^e: one c below sqrt 2, one above.
    split = to_single(mp.sqrt(2))
    for name, near in (("LOW", 1.2071), ("HIGH", 1.7071)):
        c, (even, odd) = almost_single(lambda m: [1 / sqrt(2 * pi * m), 1 / sqrt(4 * pi * m)], near, 2.0**-23, 4000)
        out += one(f"BESSEL_{name}_CENTRE", c, "c of mantissas on this side of the square root of 2.")
        out += one(f"BESSEL_{name}_INVERSE", 1 / mpf(c), "1/c.")
        out += one(f"BESSEL_{name}_EVEN", even, "1/sqrt(2 pi c).")
        out += one(f"BESSEL_{name}_ODD", odd, "1/sqrt(4 pi c).")
        out += one(f"BESSEL_{name}_LOG", log(2 * pi * mpf(c)) / 2, "ln(2 pi c)/2.")
    out += one("BESSEL_SPLIT", split, "Between the two c.")
    top = mpf("0.1717")
    fit, error = minimax_fit(
        lambda t: ((1 + t) ** mpf("-0.5") - 1) / t if abs(t) > mpf(10) ** -12 else -mpf(1) / 2, lambda t: t, -top, top, 7
    )
    out += constants("BESSEL_ROOT", fit, f"((1 + t)^(-1/2) - 1)/t in t; the root within {n(error)}.")
    fit, error = minimax_fit(
        lambda t: log(1 + t) / (2 * t) if abs(t) > mpf(10) ** -12 else mpf(1) / 2, lambda t: t, -top, top, 7
    )
    out += constants("BESSEL_LN", fit, f"ln(1 + t)/(2 t) in t; the logarithm within {n(error)}.")

    def growth(v):
        return (scaled(1 / (2 * pi * v)) / sqrt(v) - 1) / v if v > mpf(10) ** -9 else pi / 4

    out += one("BESSEL_OUTER_END", OUTER_END, "Where the piece ends.")
    inner, outer = 1 / (2 * pi * end), 1 / (2 * pi * OUTER_END)
    fit, error = minimax_fit(growth, lambda v: v, mpf(0), outer, 8)
    doc = "sqrt(2 pi x) e^-x I0(x) - 1"
    out += constants("BESSEL_TAIL", fit, f"({doc})/V in V = 1/(2 pi x); V times it within {n(error)}.")
    centre = mpf(to_single((inner + outer) / 2))
    out += one("BESSEL_OUTER_CENTRE", centre, "W: the middle of the V below.")
    fit, error = minimax_fit(lambda d: (centre + d) * growth(centre + d), lambda d: 1, outer - centre, inner - centre, 9)
    out += constants("BESSEL_OUTER", fit, f"{doc} in V - W with V = 1/(2 pi x); within {n(error)}.")

    out += one("BESSEL_BORDER", BORDER, "Where the tails of ln I0 and of I1/I0 begin.")

    def halved_log(u):
        return log(besseli(0, sqrt(u))) / u if u > mpf(10) ** -15 else mpf(1) / 4

    out += one("BESSEL_HEAD_END", 1, "Where the heads of ln I0 and of I1/I0 end.")
    fit, error = minimax_fit(lambda u: (halved_log(u) - mpf(1) / 4) / u, lambda u: u, mpf(10) ** -9, mpf(1), 5)
    out += constants("BESSEL_LOG_HEAD", fit, f"(ln I0(x)/x^2 - 1/4)/x^2 in x^2; ln I0(x)/x^2 within {n(error)}.")
    out += pieces(LOG_PIECES, lambda x: log(besseli(0, x)), "ln I0(x)")

    def log_growth(v):
        return log(scaled(1 / v) * sqrt(2 * pi / v)) / v if v > mpf(10) ** -9 else mpf(1) / 8

    fit, error = minimax_fit(log_growth, lambda v: v, mpf(0), 1 / BORDER, 8)
    out += constants("BESSEL_LOG_TAIL", fit, f"ln(sqrt(2 pi x) e^-x I0(x)) x in 1/x; the logarithm within {n(error)}.")

    def head(u):
        return ratio(sqrt(u)) / sqrt(u) if u > mpf(10) ** -15 else mpf(1) / 2

    fit, error = minimax_fit(lambda u: (head(u) - mpf(1) / 2) / u, lambda u: u, mpf(10) ** -9, mpf(1), 5)
    out += constants("BESSEL_RATIO_HEAD", fit, f"(I1(x)/(x I0(x)) - 1/2)/x^2 in x^2; I1(x)/(x I0(x)) within {n(error)}.")
    out += pieces(RATIO_PIECES, ratio, "I1(x)/I0(x)")

    def deficit(v):
        return (1 - ratio(1 / v)) / v if v > mpf(10) ** -9 else mpf(1) / 2

    fit, error = minimax_fit(deficit, lambda v: v, mpf(0), 1 / BORDER, 10)
    out += constants("BESSEL_RATIO_TAIL", fit, f"(1 - I1(x)/I0(x)) x in 1/x; the ratio within {n(error)}.")
    return out.rstrip("\n") + "\n"


if __name__ == "__main__":
    provenance.write_or_check(
        "bessel.py",
        [
            (SOURCE / "special" / "bessel_tables.rs", special_text()),
            (SOURCE / "shader" / "bessel_coefficients.rs", shader_text()),
        ],
    )
