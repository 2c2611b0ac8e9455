#!/usr/bin/env python3
"""Fits the tables of the mean of a Gaussian over an ellipse, f64 and f32.

    python3 data/fits/footprint.py            writes src/diffraction/footprint_tables.rs and
                                              src/shader/footprint_coefficients.rs, and their rows in fits.csv
    python3 data/fits/footprint.py --check    exits 1 when a committed file or row differs

Needs mpmath (PyPI). Everything is computed with 30 digits and rounded once.

With d = H - C and e = H + C, M(H, C) = (2/pi) int sqrt(1 - t^2) exp(-(H t - C)^2) dt over [-1, 1].

Edge. K(d) = int_0^inf sqrt(s) exp(-(s - d)^2) ds and J(d), the same with 1/sqrt(s), are parabolic cylinder functions
(DLMF 12.5.1). A row of EDGE holds powers 0 to 9 of the distance from the centre of a cell of d, first of K, then of J,
interpolated at Chebyshev points.

Series. SERIES is sqrt(1 - x) in powers of x.

Rules. HERMITE_n holds the positive nodes of n-point Gauss-Hermite (DLMF 3.5(v)) and their weights over sqrt(pi), CIRCLE_n
the positive nodes t = cos(j pi/(n+1)) of the n-point rule of weight sqrt(1 - t^2) and their weights times 2/pi.

Cells. A row of CELLS holds M about the centre (H0, C0) of a square cell: coefficients of (C - C0)^i (H - H0)^j, i + j up
to 7, first those of j = 0, then of j = 1 and so on; interpolated at a square of Chebyshev points and cut. COARSE_CELLS is
the same up to 4.

Shader. Midpoint rule in the angle, n nodes: sin^2 of half the angle and the sine of the angle, for the first half of them.
HALVING is (2^r - 1)/r for |r| <= 1/2, interpolated at Chebyshev points. The coarse form, for d >= -3, in parts:

    H < 3              M = sqrt(2/(2 + H^2)) exp(-w/2 - sum v^(2i) P_i(w)), i = 1 to 3, P_i of degree 5 (NARROW),
                       v = H^2/(2 + H^2), w = 4 C^2/(2 + H^2)
    H >= 3, d < 5/2    M = sqrt(e)/H^2 exp(-Q(d) - S(d)/e), Q of degree 5, S of degree 2 (EDGE, EDGE_SLOPE)

Their exponents are fitted by least squares, reweighted until the largest error of M over M(H, 0) is level.
"""

import pathlib

import provenance
from mpmath import cos, exp, factorial, gamma, log, lu_solve, matrix, mp, mpf, pcfd, pi, polyroots, sin, sqrt
from shader import digits
from special import chebyshev_fit, column, rows

mp.dps = 30
SOURCE = pathlib.Path(__file__).resolve().parents[2] / "src"
LOW, HIGH, WIDTH = mpf(-6), mpf("5.5"), mpf(1) / 4
TERMS = 10
SERIES_TERMS = 18
HERMITE = (6, 12)
CIRCLE = (4, 8, 12, 20, 38)
# Side of a cell, cells along an axis, degree.
CELLS = (mpf(1) / 2, 10, 7)
COARSE_CELLS = (mpf(2) / 9, 23, 2)
SHADER_NODES = (("FOOTPRINT_NODE", 18),)
HALVING_TERMS = 5
# Reach of the coarse form outside the edge, with a margin; its half width between two parts; its end inside the edge.
COARSE_REACH, COARSE_SPLIT, COARSE_END = mpf("3.05"), mpf(3), mpf("2.5")
LETTERS = "ABCDEFGHIJKLMNOPQRSTUVWXYZ"


def half_line(d, power):
    """int_0^inf s^power exp(-(s - d)^2) ds."""
    v = mpf(power) + 1
    return exp(-d * d / 2) * mpf(2) ** (-v / 2) * gamma(v) * pcfd(-v, -sqrt(2) * d)


def edge():
    table, worst = [], mpf(0)
    for row in range(int((HIGH - LOW) / WIDTH) + 1):
        centre = LOW + row * WIDTH
        line = []
        for power in (mpf(1) / 2, -mpf(1) / 2):
            fit, error = chebyshev_fit(lambda d: half_line(d, power), centre - WIDTH / 2, centre + WIDTH / 2, TERMS)
            line += [float(c) for c in fit]
            worst = max(worst, error)
        table.append(line)
    return table, worst


def hermite(n):
    """Positive nodes, and zero for an odd n, of Gauss-Hermite with weights over sqrt(pi)."""
    polynomials = [[mpf(1)], [mpf(2), mpf(0)]]
    for k in range(1, n + 1):
        following = [2 * c for c in polynomials[k]] + [mpf(0)]
        for i, c in enumerate(polynomials[k - 1]):
            following[i + 2] -= 2 * k * c
        polynomials.append(following)
    roots = sorted(r.real for r in polyroots(polynomials[n], maxsteps=500, extraprec=200))
    value = lambda x: sum(c * x ** (n - 1 - i) for i, c in enumerate(polynomials[n - 1]))
    return [[float(x), float(mpf(2) ** (n - 1) * factorial(n) / (n * value(x)) ** 2)] for x in roots[n // 2 :]]


def circle(n):
    angles = [pi * j / (n + 1) for j in range(1, n // 2 + 1)]
    return [[float(cos(a)), float(2 * sin(a) ** 2 / (n + 1))] for a in angles]


MEAN_ANGLES = [pi * (2 * j + 1) / 128 for j in range(64)]
MEAN_NODES = [(cos(a), sin(a) ** 2) for a in MEAN_ANGLES]


def mean(h, c):
    """M(H, C) for H below 8, by the midpoint rule of 64 angles."""
    return sum(w * exp(-((h * t - c) ** 2)) for t, w in MEAN_NODES) / 32


def cells(side, reach, degree):
    n = degree + 3
    nodes = [cos(pi * (2 * k + 1) / (2 * n)) for k in range(n)]
    # Monomial coefficients of the interpolant's part T_j: rows of the transform from values at the nodes.
    chebyshev = [[mpf(1)], [mpf(0), mpf(1)]]
    for j in range(2, n):
        following = [mpf(0)] + [2 * c for c in chebyshev[-1]]
        for k, c in enumerate(chebyshev[-2]):
            following[k] -= c
        chebyshev.append(following)
    weights = [[(2 - (j == 0)) * cos(j * pi * (2 * k + 1) / (2 * n)) / n for k in range(n)] for j in range(n)]
    half = side / 2
    table, worst = [], mpf(0)
    for row in range(reach):
        for col in range(reach - row):
            h0, c0 = (row + mpf(1) / 2) * side, (col + mpf(1) / 2) * side
            values = [[mean(h0 + half * y, c0 + half * x) for x in nodes] for y in nodes]
            along = [[sum(w * v for w, v in zip(weights[i], line)) for i in range(n)] for line in values]
            series = [[sum(weights[j][k] * along[k][i] for k in range(n)) for i in range(n)] for j in range(n)]
            # Parts of a total degree above `degree` are cut.
            power = [[mpf(0)] * (degree + 1) for _ in range(degree + 1)]
            for j in range(n):
                for i in range(n):
                    if i + j > degree:
                        continue
                    for q, b in enumerate(chebyshev[j]):
                        for p, a in enumerate(chebyshev[i]):
                            power[q][p] += series[j][i] * a * b
            cut = sum(abs(series[j][i]) for j in range(n) for i in range(n) if i + j > degree)
            worst = max(worst, cut / mean(h0 + half, mpf(0)))
            line = []
            for q in range(degree + 1):
                line += [float(power[q][p] / half ** (p + q)) for p in range(degree + 1 - q)]
            table.append(line)
    return table, worst


def table(name, values, doc, kind="const"):
    out = f"/// {doc}\n#[rustfmt::skip]\npub(super) {kind} {name}: [[f64; {len(values[0])}]; {len(values)}] = [\n"
    for row in values:
        if len(row) == 2:
            out += f"    [{row[0]!r}, {row[1]!r}],\n"
        else:
            out += "    [\n" + rows(row, "        ") + "    ],\n"
    return out + "];\n\n"


def diffraction_text():
    n = lambda error: mp.nstr(error, 2)
    e, e_error = edge()
    out = "// Written by data/fits/footprint.py; do not edit.\n"
    out += "//! Tables of the mean of a Gaussian over an ellipse.\n\n"
    out += f"/// The centre of the first cell of `EDGE`.\npub(super) const EDGE_LOW: f64 = {float(LOW)!r};\n\n"
    out += f"/// Cells of `EDGE` in a unit of d.\npub(super) const EDGE_CELLS: f64 = {float(1 / WIDTH)!r};\n\n"
    doc = f"K(d) and J(d) in powers 0 to 9 of the distance from a centre; fit error {n(e_error)} absolute."
    out += f"/// {doc}\n#[rustfmt::skip]\npub(super) static EDGE: [[[f64; {TERMS}]; 2]; {len(e)}] = [\n"
    for row in e:
        parts = "".join("        [\n" + rows(part, "            ") + "        ],\n" for part in (row[:TERMS], row[TERMS:]))
        out += "    [\n" + parts + "    ],\n"
    out += "];\n\n"
    series = [float(mp.binomial(mpf(1) / 2, k) * (-1) ** k) for k in range(SERIES_TERMS)]
    out += column("SERIES", series, "sqrt(1 - x) in powers of x.")
    for count in HERMITE:
        out += table(f"HERMITE_{count}", hermite(count), f"Gauss-Hermite, {count} points: node, and weight over sqrt(pi).")
    for count in CIRCLE:
        out += table(f"CIRCLE_{count}", circle(count), f"The {count}-point rule of weight sqrt(1 - t^2): node, and weight times 2/pi.")
    for name, (side, reach, degree) in (("CELLS", CELLS), ("COARSE_CELLS", COARSE_CELLS)):
        out += f"/// Cells of `{name}` in a unit of H or C.\npub(super) const {name}_IN_UNIT: f64 = {float(1 / side)!r};\n\n"
        out += f"/// Cells (row, column) in `{name}` have row + column below this.\npub(super) const {name}_REACH: usize = {reach};\n\n"
        c, error = cells(side, reach, degree)
        doc = f"M(H, C) about the centres of cells, to the power {degree}; at most {n(error)} of M(H, 0) is cut."
        out += table(name, c, doc, "static")
    return out.rstrip("\n") + "\n"


def level_fit(basis, target, weight, rounds=40):
    """Coefficients whose exponent errs least at worst: exp(target - fit) - 1 times weight; that error first."""
    n, terms = len(target), len(basis[0])
    share, best = [mpf(1) / n] * n, (mpf(9), None)
    for _ in range(rounds):
        normal, right = matrix(terms, terms), matrix(terms, 1)
        for i in range(n):
            line, strength = basis[i], share[i] * weight[i] ** 2
            for p in range(terms):
                scaled = strength * line[p]
                right[p] += scaled * target[i]
                for q in range(p, terms):
                    normal[p, q] += scaled * line[q]
        for p in range(terms):
            for q in range(p):
                normal[p, q] = normal[q, p]
        found = list(lu_solve(normal, right))
        error = [abs(w * (exp(t - sum(c * x for c, x in zip(found, line))) - 1)) for line, t, w in zip(basis, target, weight)]
        most = max(error)
        if most < best[0]:
            best = (most, found)
        share = [s * (e / most + mpf(1) / 1000) for s, e in zip(share, error)]
        total = sum(share)
        share = [s / total for s in share]
    return best


def spread(low, high, count):
    """Chebyshev points with both ends, from low to high."""
    return [low + (high - low) * (1 - cos(pi * k / (count - 1))) / 2 for k in range(count)]


def wide_mean(h, d):
    """M(H, H - d) for H from 3 on."""
    if h < 8:
        return mean(h, h - d)
    far = 2 * h - d
    k, j = [half_line(d, mpf(1) / 2)], [half_line(d, -mpf(1) / 2)]
    for n in range(1, 16):
        k.append((mpf(n - 1) / 2 * k[n - 2] if n > 1 else mpf(0)) + j[n - 1] / 4)
        j.append(k[n - 1] - d * j[n - 1])
    return 2 / pi * sqrt(far) / h**2 * sum(mp.binomial(mpf(1) / 2, n) * (-1) ** n * k[n] / far**n for n in range(16))


def narrow_fit():
    basis, target, weight = [], [], []
    for h in spread(mpf(0), COARSE_SPLIT, 15):
        for c in spread(mpf(0), h + COARSE_REACH, 33):
            v, w, m = h * h / (2 + h * h), 4 * c * c / (2 + h * h), mean(h, c)
            basis.append([v ** (2 * i) * w**j for i in (1, 2, 3) for j in range(6)])
            target.append(-log(m) - log(1 + h * h / 2) / 2 - w / 2)
            weight.append(m / mean(h, mpf(0)))
    return level_fit(basis, target, weight)


def edge_fit():
    basis, target, weight = [], [], []
    for inverse in spread(mpf("0.001"), 1 / COARSE_SPLIT, 10):
        h = 1 / inverse
        x = h * h / 2
        peak = exp(-x) * (mp.besseli(0, x) + mp.besseli(1, x))
        for d in spread(-COARSE_REACH, COARSE_END, 30):
            far, m = 2 * h - d, wide_mean(h, d)
            basis.append([d**j for j in range(6)] + [d**j / far for j in range(3)])
            target.append(-log(m * h * h / sqrt(far)))
            weight.append(m / peak)
    return level_fit(basis, target, weight)


def shader_text():
    n = lambda error: mp.nstr(error, 2)
    out = "// Written by data/fits/footprint.py; do not edit.\n"
    out += "//! Nodes and coefficients of the f32 mean over a footprint; the letters of nodes count from the near end.\n\n"
    constant = lambda name, value, doc: f"/// {doc}\npub(super) const {name}: f32 = {digits(value)};\n"
    for name, count in SHADER_NODES:
        for j in range((count + 1) // 2):
            a = pi * (2 * j + 1) / (2 * count)
            out += constant(f"{name}_{LETTERS[j]}", sin(a / 2) ** 2, "sin^2 of half the angle of a node; that of its mirror is 1 minus it.")
            out += constant(f"{name}_SINE_{LETTERS[j]}", sin(a), "The sine of the angle.")
    half = mpf(1) / 2
    fit, error = chebyshev_fit(lambda r: mp.expm1(r * log(mpf(2))) / r if r else log(mpf(2)), -half, half, HALVING_TERMS)
    for letter, c in zip(LETTERS, fit):
        out += constant(f"HALVING_{letter}", c, f"(2^r - 1)/r in powers of r, to {n(error)}.")
    error, fit = narrow_fit()
    for letter, c in zip(LETTERS, fit):
        out += constant(f"FOOTPRINT_NARROW_{letter}", c, f"Exponent for H < 3, v^2, v^4, v^6 times powers 0 to 5 of w, to {n(error)} of M(H, 0).")
    error, fit = edge_fit()
    for k, c in enumerate(fit):
        name = f"FOOTPRINT_EDGE_{LETTERS[k]}" if k < 6 else f"FOOTPRINT_EDGE_SLOPE_{LETTERS[k - 6]}"
        out += constant(name, c, f"Exponent beside the edge in powers of d, and its slope in 1/e, to {n(error)} of M(H, 0).")
    return out.rstrip("\n") + "\n"


if __name__ == "__main__":
    provenance.write_or_check(
        "footprint.py",
        [
            (SOURCE / "diffraction" / "footprint_tables.rs", diffraction_text()),
            (SOURCE / "shader" / "footprint_coefficients.rs", shader_text()),
        ],
    )
