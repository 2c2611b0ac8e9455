#!/usr/bin/env python3
"""Fits the f32 coefficients of src/shader.

    python3 data/fits/shader.py            writes src/shader/coefficients.rs and its row in fits.csv
    python3 data/fits/shader.py --check    exits 1 when the committed file or row differs

Needs mpmath (PyPI). Fits are made with 30 digits and rounded once to f32.

Heads, sine, cosine and exponential are polynomials whose absolute error is
level (Lawson-weighted least squares). Tails are rational: with w = 1/x^2,
x f(x) = N(w)/D(w) and x^2 g(x) = M(w)/D(w) for x >= low, the constant terms 1,
f and g the auxiliary functions of Si (DLMF 6.2.17, 6.2.18), fitted together by
linearised least squares whose weights are raised where the error is largest
(Lawson) until it is level.
"""

import pathlib
import struct

import provenance
from mpmath import ci, cos, lu_solve, matrix, mp, mpf, pi, si, sin

mp.dps = 30
OUT = pathlib.Path(__file__).resolve().parents[2] / "src" / "shader" / "coefficients.rs"
LETTERS = "ABCDEFGHIJ"


def to_single(value):
    return struct.unpack("<f", struct.pack("<f", float(value)))[0]


def digits(value):
    """The shortest decimal that reads back as the same f32."""
    single = to_single(value)
    for precision in range(1, 12):
        short = f"{single:.{precision}e}"
        if to_single(float(short)) == single:
            mantissa, exponent = short.split("e")
            mantissa = mantissa.rstrip("0").rstrip(".") if "." in mantissa else mantissa
            text = repr(float(f"{mantissa}e{exponent}"))
            return text if "e" not in text or "." in text.split("e")[0] else text.replace("e", ".0e")
    raise ValueError(single)


def minimax_fit(function, weight, low, high, terms, points=80, rounds=60):
    """Monomial coefficients whose weighted error is level (Lawson), and its largest value."""
    nodes = [low + (high - low) * (1 - cos(pi * k / points)) / 2 for k in range(points + 1)]
    rows = [([x**j for j in range(terms)], function(x), weight(x)) for x in nodes]
    lawson = [mpf(1)] * len(rows)
    best = None
    for _ in range(rounds):
        normal, right = matrix(terms, terms), matrix(terms, 1)
        for (row, target, w), boost in zip(rows, lawson):
            scale = boost * w * w
            for i in range(terms):
                right[i] += scale * row[i] * target
                for j in range(terms):
                    normal[i, j] += scale * row[i] * row[j]
        c = list(lu_solve(normal, right))
        errors = [abs(sum(a * b for a, b in zip(c, row)) - target) * w for row, target, w in rows]
        worst = max(errors)
        if best is None or worst < best[0]:
            best = (worst, c)
        lawson = [b * (e / worst + mpf("0.0001")) for b, e in zip(lawson, errors)]
        top = max(lawson)
        lawson = [b / top for b in lawson]
    return best[1], best[0]


def auxiliary(x):
    if x > 2000:
        w = 1 / x**2
        return (1 - 2 * w + 24 * w**2 - 720 * w**3) / x, w * (1 - 6 * w + 120 * w**2 - 5040 * w**3)
    a, b = ci(x), si(x) - pi / 2
    return a * sin(x) - b * cos(x), -a * cos(x) - b * sin(x)


def rational_tail(low, degree, weight_f, weight_g, points=120, rounds=80):
    """N, D, M (without their constant terms 1, in powers of w = 1/x^2) and the largest weighted error."""
    low = mpf(low)
    grid = []
    for k in range(1, points + 1):
        z = (1 - cos(pi * k / points)) / 2
        x = low / mp.sqrt(z)
        f, g = auxiliary(x)
        grid.append((z, x, x * f, x * x * g, weight_f(x), weight_g(x)))
    size = 3 * degree - 1
    lawson = [mpf(1)] * (2 * points)
    denominator = [mpf(1)] * points
    best = None
    for _ in range(rounds):
        normal, right = matrix(size, size), matrix(size, 1)
        for k, (z, _, big_f, big_g, wf, wg) in enumerate(grid):
            powers = [z**j for j in range(1, degree + 1)]
            rows = (
                (powers + [-big_f * p for p in powers] + [mpf(0)] * (degree - 1), big_f - 1, wf, lawson[2 * k]),
                ([mpf(0)] * degree + [-big_g * p for p in powers] + powers[:-1], big_g - 1, wg, lawson[2 * k + 1]),
            )
            for row, target, weight, boost in rows:
                scale = boost * (weight / denominator[k]) ** 2
                for i in range(size):
                    if row[i] == 0:
                        continue
                    right[i] += scale * row[i] * target
                    for j in range(size):
                        normal[i, j] += scale * row[i] * row[j]
        c = list(lu_solve(normal, right))
        n, d, m = c[:degree], c[degree : 2 * degree], c[2 * degree :]
        errors = []
        for k, (z, _, big_f, big_g, wf, wg) in enumerate(grid):
            denominator[k] = 1 + sum(d[j] * z ** (j + 1) for j in range(degree))
            top = 1 + sum(n[j] * z ** (j + 1) for j in range(degree))
            side = 1 + sum(m[j] * z ** (j + 1) for j in range(degree - 1))
            errors += [abs(top / denominator[k] - big_f) * wf, abs(side / denominator[k] - big_g) * wg]
        worst = max(errors)
        if best is None or worst < best[0]:
            best = (worst, n, d, m)
        lawson = [w * (e / worst + mpf("0.001")) ** mpf("0.7") for w, e in zip(lawson, errors)]
        top = max(lawson)
        lawson = [w / top for w in lawson]
    scaled = [[c * low ** (2 * (j + 1)) for j, c in enumerate(part)] for part in best[1:]]
    return (*scaled, best[0])


def constants(prefix, values, doc):
    out = ""
    for letter, value in zip(LETTERS, values):
        out += f"/// {doc}\npub(super) const {prefix}_{letter}: f32 = {digits(value)};\n"
    return out + "\n"


def text():
    out = "// Written by data/fits/shader.py; do not edit.\n"
    out += "//! Coefficients of the f32 kernels; the letters count powers upward.\n\n"
    out += "#![allow(clippy::excessive_precision, clippy::approx_constant)]\n\n"

    # Sine and cosine on a quarter turn either side of zero.
    top = (pi / 2 * mpf("1.001")) ** 2

    def sine(u):
        r = mp.sqrt(u if u > mpf(10) ** -9 else mpf(10) ** -9)
        return (sin(r) / r - 1) / r**2

    def cosine(u):
        r = mp.sqrt(u if u > mpf(10) ** -7 else mpf(10) ** -7)
        return ((cos(r) - 1) / r**2 + mpf(1) / 2) / r**2

    for name, terms in (("", 4), ("_MEDIUM", 3), ("_COARSE", 2)):
        c, error = minimax_fit(sine, lambda u: u * mp.sqrt(u), mpf(0), top, terms)
        out += constants(f"SINE{name}", c, f"(sin r / r - 1)/r^2 in r^2; sine within {mp.nstr(error, 2)}.")
        c, error = minimax_fit(cosine, lambda u: u * u, mpf(0), top, terms)
        out += constants(f"COSINE{name}", c, f"((cos r - 1)/r^2 + 1/2)/r^2 in r^2; cosine within {mp.nstr(error, 2)}.")

    # exp r on |r| <= ln 2 / 2: 1 + r + r^2 E(r).
    half = mp.log(2) / 2 * mpf("1.001")
    c, error = minimax_fit(
        lambda r: (mp.exp(r) - 1 - r) / r**2 if abs(r) > mpf(10) ** -7 else mpf(1) / 2, lambda r: r * r, -half, half, 5
    )
    out += constants("EXPONENTIAL", c, f"(exp r - 1 - r)/r^2 in r; exp within {mp.nstr(error, 2)}.")

    # arctan t on |t| <= tan(pi/8) and 2 artanh s on |s| <= tan^2(pi/8), in which a fraction of a logarithm lies.
    tangent = mp.tan(pi / 8)

    def arctangent(u):
        t = mp.sqrt(u if u > mpf(10) ** -9 else mpf(10) ** -9)
        return (1 - mp.atan(t) / t) / t**2

    def artanh(u):
        s = mp.sqrt(u if u > mpf(10) ** -9 else mpf(10) ** -9)
        return (2 * mp.atanh(s) / s - 2) / s**2

    c, error = minimax_fit(arctangent, lambda u: u * mp.sqrt(u), mpf(0), tangent**2 * mpf("1.001"), 4)
    out += constants("ARCTANGENT", c, f"(1 - arctan t/t)/t^2 in t^2; arctan within {mp.nstr(error, 2)}.")
    c, error = minimax_fit(artanh, lambda u: u * mp.sqrt(u), mpf(0), tangent**4 * mpf("1.001"), 3)
    out += constants("ARTANH", c, f"(2 artanh s/s - 2)/s^2 in s^2; 2 artanh within {mp.nstr(error, 2)}.")

    # Si: head x + x^3 Q(x^2) and rational tail.
    for name, border, terms, degree in (("", 3, 6, 4), ("_MEDIUM", 4, 5, 2), ("_COARSE", "4.2", 4, 1)):
        border = mpf(border)

        def head(u):
            x = mp.sqrt(u if u > mpf(10) ** -9 else mpf(10) ** -9)
            return (si(x) / x - 1) / x**2

        c, error = minimax_fit(head, lambda u: u * mp.sqrt(u), mpf(0), border**2, terms)
        out += f"/// Border of head and tail.\npub(super) const SI{name}_BORDER: f32 = {digits(border)};\n\n"
        out += constants(f"SI{name}_HEAD", c, f"(Si(x)/x - 1)/x^2 in x^2; Si within {mp.nstr(error, 2)}.")
        n, d, m, error = rational_tail(border, degree, lambda x: 1 / x, lambda x: 1 / x**2)
        doc = f"within {mp.nstr(error, 2)} of f and g."
        out += constants(f"SI{name}_F", n, f"N of x f = N/D from the power 1; {doc}")
        out += constants(f"SI{name}_D", d, f"D of x f = N/D and x^2 g = M/D from the power 1; {doc}")
        out += constants(f"SI{name}_G", m, f"M of x^2 g = M/D from the power 1; {doc}") if m else ""

    # The arc: head q + q^3 Q(q^2) of H(2q) and rational tail in 1/(2q).
    for name, border, terms, degree in (("", 3, 6, 5), ("_MEDIUM", 3, 5, 4), ("_COARSE", 3, 4, 3)):
        border = mpf(border)

        def half_line(u):
            y = 2 * mp.sqrt(u if u > mpf(10) ** -7 else mpf(10) ** -7)
            return ((si(y) - (1 - cos(y)) / y) * 2 / y - 1) / u if u > mpf(10) ** -7 else -mpf(1) / 9

        c, error = minimax_fit(half_line, lambda u: u * mp.sqrt(u), mpf(0), border**2 / 4, terms)
        out += f"/// Border of head and tail in q = y/2.\npub(super) const ARC{name}_BORDER: f32 = {digits(border / 2)};\n\n"
        out += constants(f"ARC{name}_HEAD", c, f"(H(2q)/q - 1)/q^2 in q^2; H within {mp.nstr(error, 2)}.")
        n, d, m, error = rational_tail(border, degree, lambda x: x, lambda x: mpf(1))
        doc = f"1 - y f within {mp.nstr(error, 2)}/y, y^2 g within {mp.nstr(error, 2)}."
        k = [a - b for a, b in zip(d, n)]
        out += constants(f"ARC{name}_K", k, f"K of 1 - y f = K/D from the power 1; {doc}")
        out += constants(f"ARC{name}_D", d, f"D of 1 - y f = K/D and y^2 g = M/D from the power 1; {doc}")
        out += constants(f"ARC{name}_G", m, f"M of y^2 g = M/D from the power 1; {doc}")
    return out.rstrip("\n") + "\n"


if __name__ == "__main__":
    provenance.write_or_check("shader.py", [(OUT, text())])
