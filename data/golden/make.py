#!/usr/bin/env python3
"""Writes the golden tables of this folder: certified values by Arb ball arithmetic (PyPI python-flint).

    python3 data/golden/make.py            writes every table
    python3 data/golden/make.py --check    fails when a committed table differs from what would be written

Inputs are f64 written as hexadecimal floats. A result is (hi + lo) 2^exponent: hi is the certified value rounded to f64,
lo the remainder rounded to f64, and the exponent is 0 except where the result would leave the normal numbers; beyond the
range of f64 hi is an infinity. The last column holds the same value to 40 decimal digits. Every ball is refined until it
has 220 correct bits. The complex functions and the Bessel functions are in complex_values.py, the functions of
scratches in scratch_values.py.
"""

import math
import pathlib
import random
import sys
from fractions import Fraction

from flint import arb, ctx

import complex_values
import scratch_values

FOLDER = pathlib.Path(__file__).resolve().parent
BITS = 220
# From here a number rounds to infinity.
LARGEST = Fraction(2**54 - 1) * Fraction(2) ** 970
# Beyond this power of two a number is written as an infinity or a zero.
FAR = 100_000


def certified(function):
    """The value of function() as an arb with at least BITS correct bits, raising the working precision as needed."""
    precision = 400
    while True:
        ctx.prec = precision
        value = function()
        if value.is_exact() or value.rel_accuracy_bits() >= BITS:
            return value
        precision *= 2
        if precision > 200_000:
            raise ArithmeticError("no convergence")


def fraction(ball):
    """Midpoint of a ball as an exact fraction."""
    mantissa, exponent = (int(part) for part in ball.mid().man_exp())
    return Fraction(mantissa) * Fraction(2) ** exponent


def split(value):
    """hi, lo, exponent of a fraction."""
    if value == 0:
        return 0.0, 0.0, 0
    size = abs(value).numerator.bit_length() - abs(value).denominator.bit_length()
    if abs(value) >= LARGEST:
        return math.inf if value > 0 else -math.inf, 0.0, 0
    if size < -1400:
        exponent = size
    else:
        exponent = -600 if abs(value) < Fraction(1, 10**200) else 0
    scaled = value / Fraction(2) ** exponent
    hi = float(scaled)
    return hi, float(scaled - Fraction(hi)), exponent


def moderate(ball):
    """The fraction of a ball; far outside every format some number there of the same sign."""
    if ball != 0:
        mantissa, exponent = (int(part) for part in ball.mid().man_exp())
        size = exponent + abs(mantissa).bit_length()
        if abs(size) > FAR:
            return Fraction(2) ** (FAR if size > 0 else -FAR) * (1 if mantissa > 0 else -1)
    return fraction(ball)


def columns(value):
    hi, lo, exponent = split(moderate(value))
    ctx.prec = 400
    return [hi.hex(), lo.hex(), str(exponent), value.str(40, radius=False)]


def exact(x):
    return arb(x)


def sine_integral(x):
    return certified(lambda: exact(x).si())


def antiderivative(q):
    """Integral of sinc^2 from 0 to q: Si(2q) - sin^2(q)/q."""
    if math.isinf(q):
        return arb.pi() / 2 * (1 if q > 0 else -1)
    if q == 0:
        return arb(0)
    exact_q = exact(q)
    return (2 * exact_q).si() - exact_q.sin() ** 2 / exact_q


def sinc_squared_integral(q0, q1):
    if q0 == q1:
        return arb(0)
    return certified(lambda: antiderivative(q1) - antiderivative(q0))


def neighbours(x):
    return [math.nextafter(x, -math.inf), x, math.nextafter(x, math.inf)]


def sine_integral_inputs():
    rng = random.Random(20180701)
    tiny = [5e-324, 1e-320, 2.2250738585072014e-308, 1e-300, 1e-200, 1e-100, 1e-30, 1e-16, 1e-9, 1e-8, 1e-4, 1e-3]
    large = [1e5, 1e6, 1e9, 1e10, 2.0**53, 1e16, 2.0**60, 1e22, 1e50, 1e100, 1e200, 1e300, 1.7976931348623157e308]
    values = tiny + large + [6381956970095103.0 * 2.0**797]
    for n in range(1, 41):
        values += neighbours(n * math.pi) if n < 6 else [n * math.pi]
    for k in range(1, 69):
        values.append(k / 4)
    for border in (0.125, 0.5, 1.0, 2.0, 3.0, 4.0, 8.0, 15.875, 16.0, 17.0, 2.0**20, 2.0**54):
        values += neighbours(border)
    values += [rng.uniform(0, 60) for _ in range(120)]
    values += [10 ** rng.uniform(-6, 6) for _ in range(100)]
    signed = [x if rng.random() < 0.8 else -x for x in values]
    return sorted(set(signed), key=lambda x: (abs(x), x))


def arcs():
    rng = random.Random(20180702)
    inf = math.inf
    rows = [
        (0.0, 5e-324), (1e-310, 3e-310), (-1e-320, 1e-310), (0.0, 1e-8), (1e-30, 2e-30), (-1e-9, 2e-9), (1e-3, 1e-3),
        (0.0, inf), (-inf, inf), (1.0, inf), (-inf, 2.5), (40.0, inf), (1e3, inf), (1e16, inf), (1e155, inf), (1e300, inf),
        (1e300, math.nextafter(1e300, inf)), (1.6e308, 1.7e308), (-1e308, 1e308), (1e150, 2e150), (123.0, 1e300),
        (2.0, 1.0), (1e3, -1e3), (50.0, 40.0),
    ]
    for n in [1, 2, 3, 5, 10, 31, 32, 100, 318, 1000, 31831, 10**6, 10**10]:
        zero = n * math.pi
        rows += [(zero, math.nextafter(zero, inf)), (math.nextafter(zero, 0.0), zero)]
        if zero < 1e9:
            rows += [(zero - 1e-6, zero + 1e-6), (zero, zero + 1e-5), (zero - 1e-3, zero + 1e-3)]
        rows += [(zero - 1.5, zero + 1.5), (zero, zero + math.pi)]
    for q in [1e4, 1e6, 1e10, 1e13, 1e15, 2.0**53, 1e17]:
        for length in [1e-6, 1e-3, 1.0, 2.9, 3.1, 10.0, 1e3]:
            if q + length > q:
                rows.append((q, q + length))
    for border in (0.125, 0.25, 1.0, 1.5, 2.0, 4.0, 7.9375, 8.0, 16.0, 40.0, 64.0):
        below, above = math.nextafter(border, 0.0), math.nextafter(border, inf)
        rows += [(below, above), (border, border + 1e-6), (border - 0.01, border + 0.02), (border, border + 5.0)]
    for _ in range(120):
        rows.append(tuple(rng.uniform(-60, 60) for _ in range(2)))
    for _ in range(120):
        q0 = 10 ** rng.uniform(-3, 6)
        rows.append((q0, q0 + 10 ** rng.uniform(-6, 3)))
    mirrored = [(-q1, -q0) if rng.random() < 0.2 else (q0, q1) for q0, q1 in rows]
    return sorted(set(mirrored))


def table(header, rows):
    return "\n".join([header] + [",".join(row) for row in rows]) + "\n"


def tables():
    si = [[x.hex()] + columns(sine_integral(x)) for x in sine_integral_inputs()]
    arc = [[q0.hex(), q1.hex()] + columns(sinc_squared_integral(q0, q1)) for q0, q1 in arcs()]
    return {
        "sine_integral.csv": table("x,hi,lo,exponent,decimal", si),
        "sinc_squared_integral.csv": table("q0,q1,hi,lo,exponent,decimal", arc),
        **complex_values.tables(table, columns),
        **scratch_values.tables(table, columns),
    }


def main():
    check = sys.argv[1:] == ["--check"]
    if sys.argv[1:] and not check:
        sys.exit(__doc__)
    stale = []
    for name, text in tables().items():
        path = FOLDER / name
        if not check:
            path.write_text(text)
            print(f"{name}: {text.count(chr(10)) - 1} rows")
        elif not path.exists() or path.read_text() != text:
            stale.append(name)
    if stale:
        sys.exit("differs from what make.py writes: " + ", ".join(stale))


if __name__ == "__main__":
    main()
