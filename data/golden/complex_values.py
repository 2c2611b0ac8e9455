#!/usr/bin/env python3
"""Certified values of the complex special functions and of the Bessel functions, in the form of make.py, which runs this.

w, w', erf, erfc: columns re, im, then hi, lo, exponent and decimal of the real part and of the imaginary part. The scaled
erf difference has the columns a1, a2, b. Every component has 220 correct bits of its own, but for the erf difference: 220
bits of its modulus.
"""

import math
import random

from flint import acb, arb, ctx

BITS = 220
MOST_BITS = 60_000


def accurate(value):
    return value.is_exact() or value.rel_accuracy_bits() >= BITS


def certified_pair(function):
    """function() as a complex ball with BITS bits in each component."""
    precision = 400
    while precision <= MOST_BITS:
        ctx.prec = precision
        value = function()
        if accurate(value.real) and accurate(value.imag):
            return value
        precision *= 2
    raise ArithmeticError("no convergence")


def certified_modulus(function):
    """function() as a complex ball with BITS bits of its modulus."""
    precision = 400
    while precision <= MOST_BITS:
        ctx.prec = precision
        value = function()
        if value.is_exact() or (value.abs_lower() > 0 and value.rel_accuracy_bits() >= BITS):
            return value
        precision *= 2
    raise ArithmeticError("no convergence")


def point(x, y):
    return acb(arb(x), arb(y))


def on_axis(value, x, y, real_on, imaginary_on):
    """Components that vanish by symmetry on an axis, made exact."""
    re = arb(0) if real_on(x, y) else value.real
    im = arb(0) if imaginary_on(x, y) else value.imag
    return acb(re, im)


def faddeeva_w(x, y):
    z = point(x, y)
    value = (-z * z).exp() * (acb(0, -1) * z).erfc()
    return on_axis(value, x, y, lambda x, y: False, lambda x, y: x == 0)


def faddeeva_w_derivative(x, y):
    z = point(x, y)
    value = -2 * z * faddeeva_w(x, y) + acb(0, 2) / arb.pi().sqrt()
    return on_axis(value, x, y, lambda x, y: x == 0, lambda x, y: False)


def erf_complex(x, y):
    return on_axis(point(x, y).erf(), x, y, lambda x, y: x == 0, lambda x, y: y == 0)


def erfc_complex(x, y):
    return on_axis(point(x, y).erfc(), x, y, lambda x, y: False, lambda x, y: y == 0)


def end(a, b):
    if math.isinf(a):
        return acb(1 if a > 0 else -1)
    return point(a, b).erf()


def erf_difference_scaled(a1, a2, b):
    if a1 == a2:
        return acb(0)
    value = (-arb(b) ** 2).exp() * (end(a2, b) - end(a1, b))
    return on_axis(value, a1, b, lambda a, b: False, lambda a, b: b == 0 or a1 == -a2)


def bessel_i0_scaled(x):
    return (-abs(arb(x))).exp() * arb(x).bessel_i(0)


def log_bessel_i0(x):
    return abs(arb(x)).bessel_i(0).log()


def bessel_i1_i0_ratio(x):
    return arb(x).bessel_i(1) / arb(x).bessel_i(0)


def certified_bessel(function, x):
    """Arb's I_n grows with x: scaled by its own asymptotic form where it does not fit."""
    precision = 400
    while precision <= MOST_BITS:
        ctx.prec = precision
        value = function(x)
        if accurate(value):
            return value
        precision *= 2
    raise ArithmeticError(f"no convergence at {x}")


ZEROS_OF_W = [
    (1.9914668428338795, -1.3548101281120062),
    (2.691149024251439, -2.1770449060896158),
    (3.2353308683528166, -2.7843876132304284),
    (5.137067271266347, -4.813806682044434),
]
ZEROS_OF_ERF = [
    (1.4506161632436756, 1.8809430001533154),
    (2.2446592738032467, 2.6165751406894397),
    (2.839741046908047, 3.175628099643187),
    (4.847970309201611, 5.101588043491399),
]


def beside(rng, zeros):
    for x, y in zeros:
        yield x, y
        yield -x, y
        for distance in [1e-16, 1e-15, 1e-12, 1e-8, 1e-5, 1e-3, 0.01, 0.05, 0.1, 0.2]:
            angle = rng.uniform(0, 2 * math.pi)
            sign = rng.choice([-1, 1])
            yield sign * (x + distance * math.cos(angle)), y + distance * math.sin(angle)


def upper_points(rng):
    for size in [0.0, 5e-324, 1e-310, 1e-300, 1e-160, 1e-30, 1e-9, 1e-3, 0.3, 1.0, 3.0, 7.0, 9.5, 12.0, 30.0, 1e3, 1e8]:
        yield size, 0.0
        yield -size, 0.0
        yield 0.0, size
        yield size, size
    for size in [1e16, 1e50, 1e150]:
        yield size, 0.0
        yield 0.0, size
        yield size, size
        yield -size, 0.7 * size
        yield size, 1.0
        yield 1.0, size
        yield size, 1 / size
        yield 1 / size, size
    yield 72355000.0, 0.48
    for small in [1e-300, 1e-100, 1e-20, 1e-8, 1e-4, 1e-2, 0.3]:
        for large in [0.2, 0.9241388730045916, 2.0, 5.3, 7.7, 9.6, 13.0, 26.0, 29.0]:
            yield large, small
            yield small, large
    for _ in range(80):
        yield rng.uniform(-12, 12), rng.uniform(0, 12)
    for _ in range(50):
        size, angle = rng.uniform(5, 10), rng.uniform(0, math.pi)
        yield size * math.cos(angle), size * math.sin(angle)
    for _ in range(40):
        size, angle = 10 ** rng.uniform(-300, 150), rng.uniform(0, math.pi)
        yield size * math.cos(angle), size * math.sin(angle)
    for _ in range(20):
        yield rng.uniform(0, 30), 10 ** rng.uniform(-300, 0)
        yield 10 ** rng.uniform(-300, 0), rng.uniform(0, 30)


def lower_points(rng):
    for x, y in upper_points(rng):
        if y > 0 and y * y - x * x < 1e5:
            yield x, -y
    yield from beside(rng, ZEROS_OF_W)
    for y in [26.0, 26.6, 26.64, 26.7, 30.0, 40.0, 100.0]:
        yield 0.5, -y
        yield 0.0, -y
        yield y - 3.0, -y
    yield 1e154, -1e154
    yield 1e6, -math.nextafter(1e6, 2e6)


def plane_points(rng):
    for x, y in list(upper_points(rng)):
        turned = rng.choice([(x, y), (-y, x), (-x, -y), (y, -x)])
        if abs(turned[0] ** 2 - turned[1] ** 2) < 2e4:
            yield turned
    yield from beside(rng, ZEROS_OF_ERF)
    yield from ((-y, x) for x, y in beside(rng, ZEROS_OF_W))
    for y in [26.0, 26.6, 26.64, 26.7, 30.0, 100.0]:
        yield 0.5, y
        yield -3.0, y
        yield 1e-300, y
        yield y, 0.3


def differences(rng):
    inf = math.inf
    for sigma in (10.0, 60.0):
        for _ in range(70):
            length = 10 ** rng.uniform(0, 4)
            start = rng.uniform(-3 * sigma - length, 3 * sigma)
            xi = rng.choice([rng.uniform(0, 2), 10 ** rng.uniform(-5, 0)])
            scale = math.sqrt(2) * sigma
            b = sigma * 2 * math.pi / rng.uniform(0.4, 0.7) * xi / math.sqrt(2)
            yield start / scale, (start + length) / scale, rng.choice([-b, b])
    for b in [0.0, 1e-300, 1e-8, 0.3, 1.0, 3.0, 9.4, 26.0, 40.0, 150.0, 1500.0, 1e6, 1e16]:
        for a in [0.0, 1e-9, 0.5, 1.0, 3.0, 6.0, 20.0]:
            yield a, math.nextafter(a, inf) if a else 1e-16, b
            yield a, a + 1e-6, b
            yield -a, a + 0.25, b
            yield a, inf, b
            yield -inf, a, b
        yield -inf, inf, b
        yield 2.0, 1.0, b
        yield -1.5, 1.5, b
        yield 1.5, 1.5, b
    for b in [1e100, 1e155, 1e300, 1e308]:
        yield 0.0, 1.0, b
        yield 0.5, inf, b
        yield -1.0, 3.0, b
        yield 2.0, math.nextafter(2.0, 3.0), b
    yield 30.0, 31.0, 2.0
    yield 100.0, 101.0, 7.0


def bessel_inputs(rng):
    tiny = [5e-324, 1e-310, 1e-300, 1e-200, 1e-100, 1e-30, 1e-17, 1e-16, 1e-9, 1e-8, 1e-4, 1e-3, 0.1]
    large = [1e5, 1e8, 1e16, 1e30, 1e77, 1e100, 1e154, 1e200, 1e300, 1.7976931348623157e308]
    values = tiny + large + [k / 4 for k in range(1, 70)]
    values += [rng.uniform(0, 60) for _ in range(120)] + [10 ** rng.uniform(-6, 6) for _ in range(80)]
    values += [700.0, 709.7, 710.0, 745.0, 1e3]
    return sorted(x if rng.random() < 0.8 else -x for x in set(values))


def pair_columns(columns, value):
    return columns(value.real) + columns(value.imag)


HEADER = "re_hi,re_lo,re_exponent,re_decimal,im_hi,im_lo,im_exponent,im_decimal"


def unique(points):
    return sorted(set(points))


def complex_table(table, columns, function, points):
    rows = [[x.hex(), y.hex()] + pair_columns(columns, certified_pair(lambda: function(x, y))) for x, y in unique(points)]
    return table("re,im," + HEADER, rows)


def tables(table, columns):
    """All tables by name, with make.py's writers."""
    rng = random.Random(20180703)
    halves = list(upper_points(rng)) + list(lower_points(rng))
    plane = list(plane_points(rng))
    out = {
        "faddeeva_w.csv": complex_table(table, columns, faddeeva_w, halves),
        "faddeeva_w_derivative.csv": complex_table(table, columns, faddeeva_w_derivative, halves),
        "erf_complex.csv": complex_table(table, columns, erf_complex, plane),
        "erfc_complex.csv": complex_table(table, columns, erfc_complex, plane),
    }
    rows = []
    for a1, a2, b in unique(differences(rng)):
        value = certified_modulus(lambda: erf_difference_scaled(a1, a2, b))
        rows.append([a1.hex(), a2.hex(), b.hex()] + pair_columns(columns, value))
    out["erf_difference_scaled.csv"] = table("a1,a2,b," + HEADER, rows)
    for function in (bessel_i0_scaled, log_bessel_i0, bessel_i1_i0_ratio):
        rows = [[x.hex()] + columns(certified_bessel(function, x)) for x in bessel_inputs(rng)]
        out[function.__name__ + ".csv"] = table("x,hi,lo,exponent,decimal", rows)
    return out
