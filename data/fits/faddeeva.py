#!/usr/bin/env python3
"""Fits the f64 tables of the Faddeeva function w and of the complex error function.

    python3 data/fits/faddeeva.py            writes src/special/faddeeva_tables.rs and its row in fits.csv
    python3 data/fits/faddeeva.py --check    exits 1 when the committed file or row differs

Needs python-flint (PyPI). Everything is computed with balls of 400 bits and rounded once.

Write zeta = -i z, so that w(z) = erfcx(zeta) is real on the real zeta axis, and 1 + f = sqrt(pi) zeta w. All fits have
real coefficients: they keep the symmetry w(-conj z) = conj w(z). They minimise the largest |error|/|w| over the boundary
of a region of the quadrant Re z >= 0, Im z >= 0 by Lawson's reweighted least squares; the maximum principle extends the
error to the region.

INNER    |z| < 1.4, Im z >= 1/2 or Re z <= 3/4: w = w(i) + (zeta - 1) P(v), v = (zeta - 1)/(zeta + 5).
MIDDLE   1.16 <= |z| < 2.5, Im z >= 0: f = P(v)/(zeta + b)^2, v = (zeta - a)/(zeta + b).
OUTER    2.5 <= |z| < 7, Im z >= 0: the same.
TAIL     |z| >= 7: f = u P(u), u = 1/z^2.
DAWSON   |Re z - c| <= 1/8, |Im z| <= 1/2: the function (2/sqrt pi) D(z), D Dawson's integral, in powers of z - c,
         about c = 0, 1/4, ... 7.
ERF      |z| < 1.25: erf(z) = z P(z^2).
FINE, MEDIUM, COARSE   Im z >= 0: w = P(v)/(zeta + L), v = (L - zeta)/(L + zeta).
W_ZEROS, ERF_ZEROS     the first zeros in the lower right and in the upper right quadrant, each in two parts, and the
         Taylor coefficients about it.
"""

import cmath
import math
import pathlib
import sys

import flint
import provenance
from flint import acb, arb, arb_mat, ctx

ctx.prec = 400
I = acb(0, 1)
SQRT_PI = arb.pi().sqrt()
PATH = pathlib.Path(__file__).resolve().parents[2] / "src" / "special" / "faddeeva_tables.rs"
EDGE, START = 0.5, 0.75
MIDDLE_RADIUS, OUTER_RADIUS, FAR_RADIUS, INNER_RADIUS, ERF_RADIUS = 1.16, 2.5, 7.0, 1.4, 1.25
INNER_TERMS, MIDDLE_TERMS, OUTER_TERMS, TAIL_TERMS, DAWSON_TERMS, ERF_TERMS = 20, 26, 34, 22, 22, 20
MIDDLE_CENTRE, MIDDLE_POLE, OUTER_CENTRE, OUTER_POLE = 1.75, 4.5, 6.0, 5.5
TIERS = (("FINE", 26, 4.5), ("MEDIUM", 17, 3.5), ("COARSE", 11, 2.5))
ZEROS, ZERO_TERMS = 12, 27
SPARE = [0.0] * 3


def midpoint(z):
    return acb(z.real.mid(), z.imag.mid())


def w(z):
    if abs(complex(z)) < 40 or z.imag.mid() < 0:
        return (-z * z).exp() * (-I * z).erfc()
    return I / SQRT_PI / z * (1 + asymptotic(z))


def asymptotic(z):
    """f by its asymptotic series, for |z| >= 40."""
    u, term, total = 1 / (z * z), acb(1), acb(0)
    for k in range(1, 60):
        term = term * u * (2 * k - 1) / 2
        total += term
    return total


def f(z):
    return -I * SQRT_PI * z * w(z) - 1 if abs(complex(z)) < 40 else asymptotic(z)


def dawson(z):
    """2/sqrt(pi) times Dawson's integral."""
    return -I * (w(z) - (-z * z).exp())


def powers(x, count):
    out = [acb(1)]
    for _ in range(count - 1):
        out.append(out[-1] * x)
    return out


def fit(points, basis, target, weight, terms, rounds=6):
    """Real coefficients of the least largest weighted error found, and that error."""
    points = [acb(p.real, p.imag) for p in points]
    rows = [basis(z, terms) for z in points]
    values = [target(z) for z in points]
    weights = [weight(z, t) for z, t in zip(points, values)]
    lawson = [1.0] * len(points)
    best = None
    for _ in range(rounds):
        matrix, right = [], []
        for row, value, scale, share in zip(rows, values, weights, lawson):
            scale = scale * arb(share).sqrt()
            matrix += [[b.real * scale for b in row], [b.imag * scale for b in row]]
            right += [[value.real * scale], [value.imag * scale]]
        matrix, right = arb_mat(matrix), arb_mat(right)
        turned = matrix.transpose()
        solved = (turned * matrix).solve(turned * right)
        coefficients = [solved[k, 0].mid() for k in range(terms)]
        errors = []
        for row, value, scale in zip(rows, values, weights):
            error = sum((b * c for b, c in zip(row, coefficients)), acb(0)) - value
            errors.append(float(abs(error * scale)))
        if best is None or max(errors) < best[0]:
            best = (max(errors), coefficients)
        total = sum(s * e for s, e in zip(lawson, errors))
        lawson = [max(s * e / total * len(points), 1e-12) for s, e in zip(lawson, errors)]
    return best[1], best[0]


def along(curves, count=40):
    """Points of curves t -> z, 0 <= t <= 1, denser towards the ends."""
    return [c(0.5 - 0.5 * math.cos(math.pi * (k + 0.5) / count)) for c in curves for k in range(count)]


def sector(low, high, edge):
    """Boundary of low <= |z| <= high, Re z >= 0, Im z >= edge."""

    def arc(radius):
        start = math.asin(edge / radius)
        return lambda t: radius * cmath.exp(1j * (start + (math.pi / 2 - start) * t))

    inner = math.sqrt(max(low * low - edge * edge, 0))
    outer = math.sqrt(high * high - edge * edge)
    start = max(low, edge)
    curves = [lambda t: complex(inner + (outer - inner) * t, edge), arc(high), lambda t: complex(0, start + (high - start) * t)]
    return curves + ([arc(low)] if low > edge else [])


def relative(z, value):
    return 1 / abs(value)


def inner_region():
    """Boundary of |z| < INNER_RADIUS, Im z >= 0, and Re z <= START where Im z < EDGE."""
    corner = [complex(0, 0), complex(START, 0), complex(START, EDGE)]
    steps = [lambda t, a=a, b=b: a + (b - a) * t for a, b in zip(corner, corner[1:])]
    return steps + sector(0, INNER_RADIUS, EDGE)


def inner():
    centre = w(I).real

    def basis(z, terms):
        zeta = -I * z
        return [(zeta - 1) * q for q in powers((zeta - 1) / (zeta + 5), terms)]

    weight = lambda z, value: 1 / abs(value + centre)
    points = along(inner_region())
    return fit(points, basis, lambda z: w(z) - centre, weight, INNER_TERMS)


def of_f(points, basis, terms):
    return fit(points, basis, f, lambda z, value: 1 / abs(1 + value), terms)


def ring(low, high, centre, pole, terms):
    def basis(z, terms):
        zeta = -I * z
        return [q / (zeta + pole) ** 2 for q in powers((zeta - centre) / (zeta + pole), terms)]

    return of_f(along(sector(low, high, 0)), basis, terms)


def tail():
    def basis(z, terms):
        u = 1 / (z * z)
        return [u * q for q in powers(u, terms)]

    start = math.asin(0.02 / FAR_RADIUS)
    points = along([lambda t: FAR_RADIUS * cmath.exp(1j * (start + (math.pi / 2 - start) * t))], 120)
    return of_f(points, basis, TAIL_TERMS)


def dawson_cell(centre):
    corner = [(-0.125, 0), (0.125, 0), (0.125, EDGE), (-0.125, EDGE), (-0.125, 0)]
    curves = []
    for a, b in zip(corner, corner[1:]):
        curves.append(lambda t, a=complex(*a), b=complex(*b): a + (b - a) * t)
    points = along(curves, 24)
    if centre == 0:

        def basis(z, terms):
            return [z * q for q in powers(z * z, terms)]

        odd, error = fit(points, basis, dawson, lambda z, value: 1, DAWSON_TERMS // 2, 3)
        return [c for value in odd for c in (arb(0), value)], error
    return fit(points, powers, lambda d: dawson(centre + d), lambda z, value: 1, DAWSON_TERMS, 3)


def erf_near_zero():
    def basis(z, terms):
        return [z * q for q in powers(z * z, terms)]

    points = along([lambda t: ERF_RADIUS * cmath.exp(1j * math.pi / 2 * t)], 80)
    return fit(points, basis, lambda z: z.erf(), relative, ERF_TERMS)


def tier(terms, pole):
    def basis(z, count):
        zeta = -I * z
        return [q / (pole + zeta) for q in powers((pole - zeta) / (pole + zeta), count)]

    line = [complex(3.5 * math.tan(math.pi / 2 * (k + 0.5) / 120)) for k in range(120)]
    return fit(line, basis, w, relative, terms, 12)


def zero(function, slope, guess):
    z = guess
    for _ in range(12):
        z = midpoint(z - function(z) / slope(z))
    return z


def w_slope(z):
    return -2 * z * w(z) + 2 * I / SQRT_PI


def zeros_of_w():
    """Zeros in the lower right quadrant with Taylor coefficients 1, 2, ...: w'' = -2 z w' - 2 w and its derivatives."""
    out = []
    for n in range(1, ZEROS + 1):
        z = zero(w, w_slope, asymptotic_zero(n))
        t = [acb(0), 2 * I / SQRT_PI]
        for k in range(ZERO_TERMS - 1):
            t.append(-(2 * z * t[k + 1] + 2 * t[k]) / (k + 2))
        out.append((z, t[1:]))
    return out


def asymptotic_zero(n):
    """w(z) = 0 where 2 exp(-z^2) = w(-z), about -i/(sqrt(pi) z)."""
    z = cmath.sqrt(2 * math.pi * n) * cmath.exp(-0.25j * math.pi)
    for _ in range(200):
        z = cmath.sqrt(-cmath.log(-1j / (2 * math.sqrt(math.pi) * z)) - 2j * math.pi * n)
    return acb(z.real, z.imag)


def zeros_of_erf():
    """Zeros in the upper right quadrant with Taylor coefficients 1, 2, ...: erf'' = -2 z erf'."""
    out = []
    for n in range(1, ZEROS + 1):
        z = cmath.sqrt(2 * math.pi * n) * cmath.exp(0.25j * math.pi)
        for _ in range(200):
            z = cmath.sqrt(-cmath.log(math.sqrt(math.pi) * z) + 2j * math.pi * n)
        z = zero(lambda z: z.erf(), lambda z: 2 / SQRT_PI * (-z * z).exp(), acb(z.real, z.imag))
        first = 2 / SQRT_PI * (-z * z).exp()
        # With t_k the coefficients of erf': (k + 1) t_{k+1} = -2 z t_k - 2 t_{k-1}.
        t = [first, -2 * z * first]
        for k in range(1, ZERO_TERMS - 1):
            t.append(-(2 * z * t[k] + 2 * t[k - 1]) / (k + 1))
        out.append((z, [c / (k + 1) for k, c in enumerate(t)]))
    return out


def parts(x):
    """An arb in two doubles."""
    high = float(x.mid())
    return high, float((x - high).mid())


def numbers(values, indent="    ", per_line=4):
    words = [repr(float(v)) for v in values]
    lines = [", ".join(words[k : k + per_line]) + "," for k in range(0, len(words), per_line)]
    return "".join(f"{indent}{line}\n" for line in lines)


def column(name, values, doc):
    return f"/// {doc}\n#[rustfmt::skip]\npub(super) const {name}: [f64; {len(values)}] = [\n{numbers(values)}];\n\n"


def constant(name, value, doc):
    return f"/// {doc}\npub(super) const {name}: f64 = {float(value)!r};\n\n"


def pair(name, value, doc):
    high, low = parts(value)
    return f"/// {doc}\npub(super) const {name}: [f64; 2] = [{high!r}, {low!r}];\n\n"


def zero_table(name, zeros, doc):
    out = f"/// {doc}\n#[rustfmt::skip]\npub(super) static {name}: [Zero; {len(zeros)}] = [\n"
    for z, taylor in zeros:
        (xh, xl), (yh, yl) = parts(z.real), parts(z.imag)
        out += f"    Zero {{\n        re: [{xh!r}, {xl!r}],\n        im: [{yh!r}, {yl!r}],\n        taylor: [\n"
        for c in taylor:
            out += f"            [{float(c.real.mid())!r}, {float(c.imag.mid())!r}],\n"
        out += "        ],\n    },\n"
    return out + "];\n\n"


def interleaved(columns):
    """Cells by coefficient: one row a power, one number a cell."""
    return [[float(cell[k]) for cell in columns] for k in range(len(columns[0]))]


def text():
    ring_doc = "(zeta + b)^2 (sqrt(pi) zeta w - 1) in powers of (zeta - a)/(zeta + b)"
    say = lambda name, error: print(f"{name}: {error:.2e}", file=sys.stderr)
    out = "// Written by data/fits/faddeeva.py; do not edit.\n"
    out += "//! Tables of the f64 Faddeeva function and complex error function.\n\n"
    out += "#![allow(clippy::approx_constant, reason = \"leading coefficients lie beside known constants\")]\n\n"
    for name, (values, error), doc in (
        ("INNER", inner(), "(w - w(i))/(zeta - 1) in powers of (zeta - 1)/(zeta + 5)"),
        ("MIDDLE", ring(MIDDLE_RADIUS, OUTER_RADIUS, MIDDLE_CENTRE, MIDDLE_POLE, MIDDLE_TERMS), ring_doc),
        ("OUTER", ring(OUTER_RADIUS, FAR_RADIUS, OUTER_CENTRE, OUTER_POLE, OUTER_TERMS), ring_doc),
        ("TAIL", tail(), "z^2 (sqrt(pi) zeta w - 1) in powers of 1/z^2"),
        ("ERF", erf_near_zero(), "erf(z)/z in powers of z^2"),
    ):
        say(name, error)
        out += column(name, values, f"{doc}; fit error {error:.1e} relative.")
    for name, centre, pole in (("MIDDLE", MIDDLE_CENTRE, MIDDLE_POLE), ("OUTER", OUTER_CENTRE, OUTER_POLE)):
        out += f"/// a and b of [`{name}`].\npub(super) const {name}_MAP: [f64; 2] = [{centre!r}, {pole!r}];\n\n"
    for name, terms, pole in TIERS:
        values, error = tier(terms, pole)
        say(name, error)
        lower = name.lower()
        out += column(name, values, f"w (L + zeta) in powers of (L - zeta)/(L + zeta); fit error {error:.1e} relative.")
        out += constant(f"{name}_POLE", pole, f"L of the {lower} tier.")
    out += pair("W_OF_I", w(I).real, "w(i) = e erfc 1, and what its rounding left out.")
    cells = [dawson_cell(acb(k) / 4) for k in range(29)]
    error = max(e for _, e in cells)
    say("DAWSON", error)
    low = [float((c[0] - float(c[0])).mid()) for c, _ in cells]
    out += "/// Number of Dawson cells, the last three unused so that a mask keeps every index inside.\n"
    out += "pub(super) const DAWSON_CELLS: usize = 32;\n\n"
    out += "/// (2/sqrt pi) D(z) about c = 0, 1/4, ... 7 in powers of z - c, one row a power; "
    out += f"fit error {error:.1e} absolute.\n#[rustfmt::skip]\n"
    table = interleaved([c for c, _ in cells])
    out += f"pub(super) static DAWSON: [[f64; DAWSON_CELLS]; {len(table)}] = [\n"
    for row in table:
        out += "    [\n" + numbers([*row, *SPARE], "        ") + "    ],\n"
    out += "];\n\n"
    out += "/// What the rounding of the first row of [`DAWSON`] left out.\n#[rustfmt::skip]\n"
    out += f"pub(super) static DAWSON_LOW: [f64; DAWSON_CELLS] = [\n{numbers([*low, *SPARE])}];\n\n"
    out += "/// A zero in two parts, and the Taylor coefficients 1, 2, ... about it as (real, imaginary).\n"
    out += "pub(super) struct Zero {\n    pub(super) re: [f64; 2],\n    pub(super) im: [f64; 2],\n"
    out += f"    pub(super) taylor: [[f64; 2]; {ZERO_TERMS}],\n}}\n\n"
    out += zero_table("W_ZEROS", zeros_of_w(), "The zeros of w of least size in the lower right quadrant.")
    out += zero_table("ERF_ZEROS", zeros_of_erf(), "The zeros of erf of least size in the upper right quadrant, but 0.")
    return out.rstrip("\n") + "\n"


if __name__ == "__main__":
    provenance.write_or_check("faddeeva.py", [(PATH, text())])
