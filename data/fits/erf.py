#!/usr/bin/env python3
"""Fits the table of the f64 error function of a real argument.

    python3 data/fits/erf.py            writes src/special/erf_tables.rs and its row in fits.csv
    python3 data/fits/erf.py --check    exits 1 when the committed file or row differs

Needs mpmath (PyPI). Everything is computed with 40 digits and rounded once.

Row n belongs to the cell |d| <= 1/64 about the centre c = n/32, n = 0..190, with x = c + d. A row is erf(c) in two
parts, then the slope erf'(c) cut to 26 bits, so that its products with 27 further bits are exact, then the powers 0 to
7 of d in (erf(c + d) - erf(c))/d less that slope. The rise erf(c + d) - erf(c) is interpolated at the 9 Chebyshev
points, of which d = 0 is one. Row 0 is fitted for d >= 0 alone, with the constant held at the rest of 2/sqrt(pi), so
that small arguments keep their relative accuracy.
"""

import pathlib

import provenance
from mpmath import erf, exp, mp, mpf, pi, sqrt
from special import chebyshev_fit, rows, shift

mp.dps = 40
SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"
PER_UNIT = 32
ROWS = 191
TERMS = 8
SLOPE_BITS = 26


def derivative(x):
    return 2 / sqrt(pi) * exp(-x * x)


def cut(value, bits):
    """The number of so many bits closest to `value`."""
    mantissa, exponent = mp.frexp(value)
    return mp.ldexp(mp.nint(mp.ldexp(mantissa, bits)), exponent - bits)


def row(n):
    """The numbers of a row, and the largest error relative to the value."""
    centre, reach = mpf(n) / PER_UNIT, mpf(1) / (2 * PER_UNIT)
    value, tangent = erf(centre), derivative(centre)
    slope = cut(tangent, SLOPE_BITS)

    if n == 0:
        curvature = lambda d: (erf(d) / d - tangent) / d if d else mpf(0)
        fit, error = chebyshev_fit(curvature, mpf(0), reach, TERMS - 1)
        fit = [tangent - slope, *shift(fit, reach / 2)]
        error *= reach / tangent
    else:
        (_, secant, *rest), error = chebyshev_fit(lambda x: erf(x) - value, centre - reach, centre + reach, TERMS + 1)
        fit = [secant - slope, *rest]
        error /= erf(centre - reach)
    high = float(value)
    return [high, float(value - mpf(high)), float(slope), *(float(c) for c in fit)], error


def text():
    table = [row(n) for n in range(ROWS)]
    worst = mp.nstr(max(error for _, error in table), 2)
    out = "// Written by data/fits/erf.py; do not edit.\n"
    out += "//! Table of the f64 error function of a real argument.\n\n"
    out += f"/// Cells in a unit of x.\npub(super) const PER_UNIT: f64 = {float(PER_UNIT)!r};\n\n"
    out += f"/// The centre of the last cell, where erf rounds to 1.\npub(super) const END: f64 = {(ROWS - 1) / PER_UNIT!r};\n\n"
    out += f"/// erf(n/{PER_UNIT}) in two parts, the slope there cut to {SLOPE_BITS} bits, and powers 0 to {TERMS - 1} of the secant's slope less it;\n"
    out += f"/// fit error {worst} relative.\n"
    out += f"#[rustfmt::skip]\npub(super) static CELLS: [[f64; {TERMS + 3}]; {ROWS}] = [\n"
    for values, _ in table:
        out += "    [\n" + rows(values, "        ") + "    ],\n"
    return out + "];\n"


if __name__ == "__main__":
    provenance.write_or_check("erf.py", [(SOURCE / "special" / "erf_tables.rs", text())])
