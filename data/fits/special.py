#!/usr/bin/env python3
"""Fits the f64 tables of src/special: cells of Si, H and Cin, and the auxiliary tail.

    python3 data/fits/special.py            writes src/special/tables.rs, src/numeric/tables.rs and their rows in fits.csv
    python3 data/fits/special.py --check    exits 1 when a committed file or row differs

Needs mpmath (PyPI). Everything is computed with 60 digits and rounded once.

Cells. Si(x) and H(y) = Si(y) - (1 - cos y)/y are expanded about the centres
c = 3 i / 8, i = 0..127, for |x - c| <= 3/16: interpolation of degree 9 at
Chebyshev points, which is within a small factor of minimax. Rows below
LINEAR_ROWS hold the difference to the leading line (x, or y/2), so that small
arguments keep their relative accuracy; row 0 is fitted as an odd polynomial.

Cin(x) = int_0^x (1 - cos t)/t dt is even; its cells hold Cin(x)/x, which is odd.

Tail. With f and g the auxiliary functions of Si (DLMF 6.2.17, 6.2.18) and
y = 1/x^2, the polynomials A(y) = (1 - x f)/y and B(y) = (1 - x^2 g)/y on
0 <= y <= 1/TAIL_LOW^2, at Chebyshev points.

Sine and cosine. S(u) = (sin r / r - 1)/u and C(u) = ((cos r - 1)/u + 1/2)/u
with u = r^2 on |r| <= 1.001 pi/2, at Chebyshev points. Beside them the binary
places of 1/pi, for the reduction of products of any size.
"""

import pathlib

import provenance

from mpmath import ci, cos, euler, log, mp, mpf, pi, si, sin

mp.dps = 60
ROWS = 128
WIDTH = mpf(3) / 8
DEGREE = 9
LINEAR_ROWS = 4
TAIL = mpf(191) / 4
TAIL_LOW = mpf(40)
TAIL_TERMS = 8
SINE_TERMS, COSINE_TERMS = 8, 8
INVERSE_PI_WORDS = 40
SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"


def sine_integral(x):
    return si(x)


def cosine_integral_quotient(x):
    """Cin(x)/x."""
    return (euler + log(x) - ci(x)) / x if x else mpf(0)


def one_minus_cosine_integral(y):
    return si(y) - (1 - cos(y)) / y if y else mpf(0)


def chebyshev_fit(function, low, high, terms):
    """Monomial coefficients about (low+high)/2 of the interpolant at Chebyshev points, and its largest error."""
    middle, half = (low + high) / 2, (high - low) / 2
    nodes = [cos(pi * (2 * k + 1) / (2 * terms)) for k in range(terms)]
    values = [function(middle + half * t) for t in nodes]
    series = [
        2 * sum(v * cos(j * pi * (2 * k + 1) / (2 * terms)) for k, v in enumerate(values)) / terms
        for j in range(terms)
    ]
    series[0] /= 2
    previous, current = [mpf(1)], [mpf(0), mpf(1)]
    total = [mpf(0)] * terms
    for j in range(terms):
        polynomial = previous if j == 0 else current
        for k, c in enumerate(polynomial):
            total[k] += series[j] * c
        if j >= 1:
            following = [mpf(0)] + [2 * c for c in current]
            for k, c in enumerate(previous):
                following[k] -= c
            previous, current = current, following
    coefficients = [c / half**k for k, c in enumerate(total)]
    error = mpf(0)
    for k in range(4 * terms + 1):
        d = half * (mpf(2 * k) / (4 * terms) - 1)
        error = max(error, abs(sum(c * d**n for n, c in enumerate(coefficients)) - function(middle + d)))
    return coefficients, error


def shift(coefficients, offset):
    """Monomials about m rewritten about m - offset, i.e. p(t - offset)."""
    result = [mpf(0)]
    for c in reversed(coefficients):
        result = [mpf(0)] + result
        for k in range(len(result) - 1):
            result[k] -= offset * result[k + 1]
        result[0] += c
    return result[: len(coefficients)]


def cells(function, slope):
    """Columns base, c0 .. c9 over the rows, and the largest absolute error."""
    columns = [[] for _ in range(DEGREE + 2)]
    worst = mpf(0)
    for row in range(ROWS):
        centre = row * WIDTH
        if row == 0:
            # E(d) = d^3 Q(d^2), Q of degree 3 in u = d^2.
            top = (WIDTH / 2) ** 2

            def quotient(u):
                if u == 0:
                    u = mpf(10) ** -20
                d = mp.sqrt(u)
                return (function(d) - slope * d) / d**3

            fit, error = chebyshev_fit(quotient, mpf(0), top, (DEGREE - 1) // 2)
            fit = shift(fit, top / 2)
            coefficients = [mpf(0)] * (DEGREE + 1)
            for k, c in enumerate(fit):
                coefficients[3 + 2 * k] = c
            base = 0.0
            error *= (WIDTH / 2) ** 3
        elif row < LINEAR_ROWS:
            base = 0.0
            coefficients, error = chebyshev_fit(
                lambda x: function(x) - slope * x, centre - WIDTH / 2, centre + WIDTH / 2, DEGREE + 1
            )
        else:
            base = float(function(centre))
            coefficients, error = chebyshev_fit(
                lambda x: function(x) - mpf(base), centre - WIDTH / 2, centre + WIDTH / 2, DEGREE + 1
            )
        worst = max(worst, error)
        columns[0].append(base)
        for k in range(DEGREE + 1):
            columns[k + 1].append(float(coefficients[k]))
    return columns, worst


def tail():
    def auxiliary(x):
        a, b = ci(x), si(x) - pi / 2
        return a * sin(x) - b * cos(x), -a * cos(x) - b * sin(x)

    def point(y):
        y = y if y > 0 else mpf(10) ** -20
        x = 1 / mp.sqrt(y)
        f, g = auxiliary(x)
        return (1 - f * x) / y, (1 - g * x * x) / y

    top = 1 / TAIL_LOW**2
    result = []
    for which in (0, 1):
        fit, error = chebyshev_fit(lambda y: point(y)[which], mpf(0), top, TAIL_TERMS)
        result.append(([float(c) for c in shift(fit, top / 2)], error))
    return result


def rows(values, indent, per_line=5):
    lines = [values[k : k + per_line] for k in range(0, len(values), per_line)]
    return "".join(indent + " ".join(f"{v!r}," for v in line) + "\n" for line in lines)


def column(name, values, doc):
    return (
        f"/// {doc}\n#[rustfmt::skip]\npub(super) const {name}: [f64; {len(values)}] = [\n"
        + rows(values, "    ")
        + "];\n\n"
    )


def table(name, columns, doc):
    body = "    base: [\n" + rows(columns[0], "        ") + "    ],\n    coefficients: [\n"
    for values in columns[1:]:
        body += "        [\n" + rows(values, "            ") + "        ],\n"
    return f"/// {doc}\n#[rustfmt::skip]\npub(super) static {name}: Cells = Cells {{\n{body}    ],\n}};\n\n"


def sine_cosine():
    top = (pi / 2 * mpf("1.001")) ** 2

    def point(u):
        u = u if u > mpf(10) ** -15 else mpf(10) ** -15
        r = mp.sqrt(u)
        return (sin(r) / r - 1) / u, ((cos(r) - 1) / u + mpf(1) / 2) / u

    result = []
    for which, terms in ((0, SINE_TERMS), (1, COSINE_TERMS)):
        fit, error = chebyshev_fit(lambda u: point(u)[which], mpf(0), top, terms)
        result.append(([float(c) for c in shift(fit, top / 2)], error))
    return result


def numeric_text():
    (s, s_error), (c, c_error) = sine_cosine()
    out = "// Written by data/fits/special.py; do not edit.\n"
    out += "//! Coefficients of the f64 sine and cosine on a quarter turn either side of zero.\n\n"
    out += column("SINE", s, f"(sin r / r - 1)/r^2 in powers of r^2; fit error {mp.nstr(s_error, 2)} absolute.")
    out += column("COSINE", c, f"((cos r - 1)/r^2 + 1/2)/r^2 in powers of r^2; fit error {mp.nstr(c_error, 2)} absolute.")
    out += words_of_inverse_pi()
    return out.rstrip("\n") + "\n"


def words_of_inverse_pi():
    """1/pi in binary, 64 places a word: the products of two doubles reach 2^2049."""
    with mp.workprec(64 * INVERSE_PI_WORDS + 64):
        digits = int(mp.floor(mp.ldexp(1 / pi, 64 * INVERSE_PI_WORDS)))
    words = [f"0x{digits >> 64 * (INVERSE_PI_WORDS - 1 - k) & 2**64 - 1:016x}" for k in range(INVERSE_PI_WORDS)]
    out = "/// The binary places of 1/pi after the point, 64 a word.\n#[rustfmt::skip]\n"
    out += f"pub(super) static INVERSE_PI_PLACES: [u64; {INVERSE_PI_WORDS}] = [\n"
    out += "".join(f"    {', '.join(words[k : k + 4])},\n" for k in range(0, INVERSE_PI_WORDS, 4))
    return out + "];\n\n"


def special_text():
    si_columns, si_error = cells(sine_integral, mpf(1))
    h_columns, h_error = cells(one_minus_cosine_integral, mpf(1) / 2)
    cin_columns, cin_error = cells(cosine_integral_quotient, mpf(1) / 4)
    (a, a_error), (b, b_error) = tail()
    out = "// Written by data/fits/special.py; do not edit.\n"
    out += "//! Tables of the f64 special functions: cells of Si, H and Cin, and their tail.\n\n"
    out += "/// Rows of a cell table.\npub(super) const ROWS: usize = 128;\n\n"
    out += "/// A function about the centres c of its cells: `base` plus powers 0 to 9 of the distance from c.\n"
    out += "pub(super) struct Cells {\n    pub(super) base: [f64; ROWS],\n    pub(super) coefficients: [[f64; ROWS]; 10],\n}\n\n"
    out += "/// Distance of two cell centres.\npub(super) const WIDTH: f64 = 0.375;\n\n"
    out += f"/// Rows that hold the difference to the leading line.\npub(super) const LINEAR_ROWS: u64 = {LINEAR_ROWS};\n\n"
    out += f"/// Where the tail takes over from the cells.\npub(super) const TAIL: f64 = {float(TAIL)!r};\n\n"
    out += f"/// The least argument for which the tail's polynomials are fitted.\npub(super) const TAIL_LOW: f64 = {float(TAIL_LOW)!r};\n\n"
    out += table("SI", si_columns, f"Si(x); fit error {mp.nstr(si_error, 2)} absolute.")
    out += table("H", h_columns, f"H(y); fit error {mp.nstr(h_error, 2)} absolute.")
    out += table("CIN", cin_columns, f"Cin(x)/x; fit error {mp.nstr(cin_error, 2)} absolute.")
    out += column("TAIL_F", a, f"(1 - x f(x)) x^2 in powers of 1/x^2; fit error {mp.nstr(a_error, 2)} absolute.")
    out += column("TAIL_G", b, f"(1 - x^2 g(x)) x^2 in powers of 1/x^2; fit error {mp.nstr(b_error, 2)} absolute.")
    return out.rstrip("\n") + "\n"


if __name__ == "__main__":
    provenance.write_or_check("special.py", [(SOURCE / "special" / "tables.rs", special_text()), (SOURCE / "numeric" / "tables.rs", numeric_text())])
