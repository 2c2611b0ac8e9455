#!/usr/bin/env python3
"""Fits the f32 coefficients of the Faddeeva function w in src/shader.

    python3 data/fits/faddeeva_shader.py            writes src/shader/faddeeva_coefficients.rs and its row in fits.csv
    python3 data/fits/faddeeva_shader.py --check    exits 1 when the committed file or row differs

Needs python-flint and mpmath (PyPI). The method, the notation and the coarse tier are those of faddeeva.py: real
coefficients in zeta = -i z, the largest |error|/|w| over the boundary of a region made least. Everything is rounded
once to f32.

NEAR     |z| < 2, Im z >= 0: w = w(2i) + (zeta - 2) P(v), v = (zeta - 2)/(zeta + 2).
FAR      |z| >= 2, Im z >= 0: sqrt(pi) zeta w - 1 = P(v)/(zeta + 3)^2, v = (zeta - 2)/(zeta + 3).
COARSE   Im z >= 0: w = P(v)/(zeta + L), v = (L - zeta)/(L + zeta).
"""

import cmath
import math
import pathlib
import string

import provenance
from faddeeva import TIERS, I, along, f, fit, powers, relative, tier, w
from shader import digits

PATH = pathlib.Path(__file__).resolve().parents[2] / "src" / "shader" / "faddeeva_coefficients.rs"
RADIUS, CENTRE, NEAR_POLE, FAR_POLE, TERMS = 2.0, 2.0, 2.0, 3.0, 15
FARTHEST = 1000.0


def circle(t):
    return RADIUS * cmath.exp(0.5j * math.pi * t)


def near():
    middle = w(I * CENTRE).real

    def basis(z, terms):
        zeta = -I * z
        return [(zeta - CENTRE) * q for q in powers((zeta - CENTRE) / (zeta + NEAR_POLE), terms)]

    points = along([lambda t: complex(RADIUS * t), circle, lambda t: 1j * RADIUS * t])
    c, error = fit(points, basis, lambda z: w(z) - middle, lambda z, value: 1 / abs(value + middle), TERMS)
    return middle, c, error


def far():
    def basis(z, terms):
        zeta = -I * z
        return [q / (zeta + FAR_POLE) ** 2 for q in powers((zeta - CENTRE) / (zeta + FAR_POLE), terms)]

    def outward(t):
        return RADIUS / max(1 - t, RADIUS / FARTHEST)

    points = along([lambda t: complex(outward(t)), circle, lambda t: 1j * outward(t)], 60)
    return fit(points, basis, f, lambda z, value: 1 / abs(1 + value), TERMS, 12)


def constant(name, value, doc):
    return f"/// {doc}\npub(super) const FADDEEVA_{name}: f32 = {digits(value)};\n"


def column(name, values, doc):
    out = "".join(constant(f"{name}_{letter}", c, doc) for letter, c in zip(string.ascii_uppercase, values))
    return out + "\n"


def text():
    middle, near_values, near_error = near()
    far_values, far_error = far()
    (terms, pole) = next((terms, pole) for name, terms, pole in TIERS if name == "COARSE")
    coarse_values, coarse_error = tier(terms, pole)
    out = "// Written by data/fits/faddeeva_shader.py; do not edit.\n"
    out += "//! Coefficients of the f32 Faddeeva function; the letters count powers upward.\n\n"
    out += "#![allow(clippy::excessive_precision, clippy::approx_constant)]\n\n"
    out += constant("BORDER", RADIUS * RADIUS, "|z|^2 where the two fits meet.")
    out += constant("CENTRE", CENTRE, "zeta about which both fits are made.")
    out += constant("NEAR_POLE", NEAR_POLE, "Minus the zeta of the pole of the near fit.")
    out += constant("FAR_POLE", FAR_POLE, "Minus the zeta of the pole of the far fit.")
    out += constant("AT_CENTRE", middle, "w at the centre.")
    out += constant("COARSE_POLE", pole, "L of the coarse tier.") + "\n"
    out += column("NEAR", near_values, f"(w - w(2i))/(zeta - 2) in (zeta - 2)/(zeta + 2); w within {near_error:.1e}.")
    far_doc = f"(zeta + 3)^2 (sqrt(pi) zeta w - 1) in (zeta - 2)/(zeta + 3); w within {far_error:.1e}."
    out += column("FAR", far_values, far_doc)
    out += column("COARSE", coarse_values, f"w (L + zeta) in (L - zeta)/(L + zeta); w within {coarse_error:.1e}.")
    return out.rstrip("\n") + "\n"


if __name__ == "__main__":
    provenance.write_or_check("faddeeva_shader.py", [(PATH, text())])
