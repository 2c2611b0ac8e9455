"""Certified values of the scratch functions, in the form of make.py, which runs this.

The spatial phase from acb's error function, the profiles and the energy of a segment from their definitions or from
antiderivatives that share no form with the oracles, the footprint mean by certified quadrature of its definition, the
inverse of the integral of sinc^2 by bisection. The spatial phase has 220 correct bits of its modulus, a profile 220 bits
of its width (below that its digits mean nothing), a real value 220 bits of its own.
"""

import math
import random
from fractions import Fraction

from flint import acb, arb, ctx

BITS = 220
MOST_BITS = 60_000
I = acb(0, 1)


def certified(function):
    """function() as a ball with BITS bits of its modulus."""
    precision = 400
    while precision <= MOST_BITS:
        ctx.prec = precision
        value = function()
        if value.is_exact() or value.rel_accuracy_bits() >= BITS:
            return value
        precision *= 2
    raise ArithmeticError("no convergence")


def certified_against(size, function):
    """function() to 2^-BITS of `size`."""
    precision = 400
    while precision <= MOST_BITS:
        ctx.prec = precision
        value = function()
        parts = [part.mid() for part in (value.real, value.imag)]
        if all(part.rad() <= arb(size) * arb(2) ** -BITS for part in (value.real, value.imag)):
            return acb(*parts)
        precision *= 2
    raise ArithmeticError("no convergence")


def integral(function, start, end, scale=1):
    tolerance = arb(2) ** (-BITS - 30)
    return acb.integral(
        lambda x, _: function(x), acb(start), acb(end), rel_tol=tolerance, abs_tol=tolerance * scale, eval_limit=10**7,
        deg_limit=400,
    )


def spatial_phase(sigma, wavelength, xi1, xi2, s_t, s_b, l1, l2):
    """The integral of the window along the scratch, by the error function of complex argument."""
    sigma_, k = arb(sigma), 2 * arb.pi() / arb(wavelength)

    if l1 == l2:
        return acb(0)

    def end(l):
        """erf, less 1 on the right where both ends lie right of the centre, plus 1 on the left."""
        if math.isinf(l):
            return acb((1 if l > 0 else -1) - side)
        z = (acb(arb(s_t) + arb(l)) / sigma_ + I * sigma_ * k * arb(xi1)) / arb(2).sqrt()
        return z.erf() if side == 0 else -side * (side * z).erfc()

    side = 1 if s_t + min(l1, l2) > 0 else -1 if s_t + max(l1, l2) < 0 else 0

    d = (arb.pi() / 2).sqrt() * sigma_
    exponent = acb(-(arb(s_b) / sigma_) ** 2 / 2 - (sigma_ * k * arb(xi1)) ** 2 / 2, -k * arb(s_b) * arb(xi2))
    return exponent.exp() * d * (end(l2) - end(l1))


def profile_rectangle(width, depth, xi2, gamma_sum, wavelength):
    """The transform of the mask, exp(iqb)/(iq) between its ends, less that of the shifted ground."""
    w, q = arb(width), 2 * arb.pi() * arb(xi2) / arb(wavelength)
    if width == 0:
        return acb(0)
    mask = acb(w) if xi2 == 0 else ((I * q * w / 2).exp() - (-I * q * w / 2).exp()) / (I * q)
    mask = acb(mask.real, 0)
    phase = 2 * arb.pi() * arb(gamma_sum) * arb(depth) / arb(wavelength)
    return mask * (1 - (I * phase).exp()) if phase != 0 else acb(0)


def profile_triangle(width, depth, xi2, gamma_sum, wavelength):
    """W int_0^1 exp(ip(1 - u)) cos(qu) du: by quadrature, or by its antiderivative where the phases are large."""
    p = 2 * arb.pi() * arb(gamma_sum) * arb(depth) / arb(wavelength)
    q = arb.pi() * arb(width) * arb(xi2) / arb(wavelength)
    if width == 0:
        return acb(0)
    if max(abs(float(p)), abs(float(q))) < 300:
        return arb(width) * integral(lambda u: (I * p * (1 - u)).exp() * (q * u).cos(), 0, 1)
    # exp(ip(1 - u)) (q sin qu - ip cos qu)/(q^2 - p^2) at 1 less at 0.
    top = q * q.sin() - I * p * q.cos() + I * p * (I * p).exp()
    return arb(width) * top / (q * q - p * p)


def footprint_mean_of(h, d):
    """(2/pi) int_0^pi sin^2 theta exp(-(d - 2 H sin^2(theta/2))^2) dtheta, the part exp(-d^2) apart beyond the edge."""
    size, edge = float(h), float(d)
    beyond = edge < 0

    def integrand(theta):
        below = 2 * h * (theta / 2).sin() ** 2
        exponent = below * (2 * d - below) if beyond else -((d - below) ** 2)
        return theta.sin() ** 2 * exponent.exp()

    reach = 14.0
    cuts = [0.0]
    for y in (edge - reach, edge, edge + reach) if not beyond else (reach**2 / (reach - edge),):
        if 0 < y < 2 * size:
            cuts.append(2 * math.asin(math.sqrt(y / (2 * size))))
    ends = [arb(x) for x in cuts] + [arb.pi()]
    scale = min(1.0, 1 / max(size, 1.0)) * min(1.0, max(size, 1.0) ** -0.5 if edge < 30 else 1.0) / (1 + max(0.0, -edge)) ** 1.5
    total = sum((integral(integrand, a, b, scale).real for a, b in zip(ends, ends[1:])), arb(0))
    return total * 2 / arb.pi() * ((-(d**2)).exp() if beyond else 1)


def footprint_mean_reduced(h, c):
    return footprint_mean_of(arb(h), arb(h) - abs(arb(c)))


def footprint_mean(a1, a2, cos_phi, offset, sigma):
    c2 = arb(cos_phi) ** 2
    half_width = (arb(a1) ** 2 * (1 - c2) + arb(a2) ** 2 * c2).sqrt() / arb(sigma)
    return footprint_mean_of(half_width, half_width - abs(arb(offset)) / arb(sigma))


def segment_energy(sigma, wavelength, xi1, length):
    """2 pi sigma^2 int_0^L (L - u) exp(-u^2/(4 sigma^2)) cos(k xi1 u) du, by erf and the integral of u by parts."""
    if length == 0:
        return arb(0)
    s, size, kappa = arb(sigma), arb(length), 2 * arb.pi() * arb(xi1) / arb(wavelength)
    z = size / (2 * s) + I * kappa * s
    zeroth = arb.pi().sqrt() * s * (-((kappa * s) ** 2)).exp() * (z.erf() - (I * kappa * s).erf())
    first = 2 * s**2 * (1 - (-(size**2) / (4 * s**2) - I * kappa * size).exp()) - 2 * I * kappa * s**2 * zeroth
    return 2 * arb.pi() * s**2 * (size * zeroth - first).real


def tail(x):
    """The integral of sinc^2 from x to infinity."""
    if x == 0:
        return arb.pi() / 2
    return arb.pi() / 2 - (2 * x).si() + x.sin() ** 2 / x


def sinc_squared_inverse(u):
    """By bisection between exact dyadic numbers, until they agree to BITS bits."""
    share = Fraction(u) if u < 0.5 else 1 - Fraction(u)
    if share == Fraction(1, 2):
        return arb(0)
    ctx.prec = 1200 if share > Fraction(1, 10**60) else 4000
    target = arb.pi() * arb(share.numerator) / arb(share.denominator)
    guess = (1 / (2 * target)).mid()
    lo, hi = guess - 2, guess + 2
    if not lo > 0:
        lo = arb(0)
    for _ in range(BITS + 60 + max(0, -math.frexp(float(arb.pi() / 2 - target))[1])):
        middle = ((lo + hi) / 2).mid()
        rest = tail(middle) - target
        if rest > 0:
            lo = middle
        elif rest < 0:
            hi = middle
        else:
            raise ArithmeticError("undecided")
    root = lo.union(hi)
    if root.rel_accuracy_bits() < BITS:
        raise ArithmeticError("too few steps")
    return root if u > 0.5 else -root


def spatial_phase_rows(rng):
    inf = math.inf
    for _ in range(160):
        sigma = rng.choice([10.0, 60.0, 10 ** rng.uniform(0, 2)])
        wavelength = rng.uniform(0.38, 0.78)
        xi1 = rng.choice([0.0, rng.uniform(-2, 2), rng.uniform(-1, 1) * 10 ** rng.uniform(-6, 0)])
        length = 10 ** rng.uniform(-3, 6)
        s_t = rng.choice([rng.uniform(-6, 6) * sigma, rng.uniform(-6 * sigma - length, 6 * sigma)])
        s_b = rng.choice([0.0, rng.uniform(-6, 6) * sigma, rng.uniform(-30, 30) * sigma])
        l1, l2 = rng.choice([(0.0, length), (-length / 2, length / 2), (-length, 0.0), (-inf, length), (-length, inf), (-inf, inf)])
        yield sigma, wavelength, xi1, rng.uniform(-2, 2), s_t, s_b, l1, l2
    for xi1 in [0.0, 1e-300, 1e-8, 0.003, 0.05, 1.0, 2.0]:
        for sigma in [10.0, 60.0]:
            for s_t, l1, l2 in [(0.0, -50.0, 50.0), (1000.0, -1e-3, 0.0), (1e6, -1000003.0, -999999.0), (0.0, -inf, 0.0), (0.1, 1.0, 1.0)]:
                yield sigma, 0.55, xi1, 0.7, s_t, 0.3 * sigma, l1, l2


def profile_rows(rng):
    for _ in range(120):
        depth = rng.choice([0.0, rng.uniform(0, 20), 10 ** rng.uniform(-6, 1)])
        yield 10 ** rng.uniform(-1, 2), depth, rng.uniform(-2, 2), rng.uniform(0, 2), rng.uniform(0.38, 0.78)
    for width in [0.0, 0.1, 6.0, 100.0]:
        for depth in [0.0, 0.1375, 0.275, 2.0, 550000.0]:
            for xi2 in [0.0, 1e-9, 0.55 / 6.0, 1.1 / 6.0, -0.4]:
                yield width, depth, xi2, 2.0, 0.55


def pole_rows(rng):
    for _ in range(60):
        width, depth, gamma = 10 ** rng.uniform(-1, 2), 10 ** rng.uniform(-1, 1), rng.uniform(0.01, 2)
        pole = rng.choice([-1, 1]) * 2 * depth * gamma / width
        yield width, depth, pole * (1 + rng.choice([0.0, 0.0, 10 ** rng.uniform(-16, -2)])), gamma, rng.uniform(0.38, 0.78)


def footprint_reduced_rows(rng):
    for h in [0.0, 1e-300, 1e-9, 1e-3, 0.1, 0.7, 1.0, 2.0, 3.0, 4.4, 7.0, 11.0, 20.0, 50.0, 300.0, 1e3, 1e4, 1e6, 1e8]:
        for c in [0.0, 0.5 * h, h, h + 0.3, h - 0.3, h + 2.0, h - 3.0, h + 6.0, h + 20.0]:
            yield h, c
    for _ in range(80):
        h = 10 ** rng.uniform(-3, 4)
        yield h, rng.choice([-1, 1]) * rng.choice([rng.uniform(0, h), rng.uniform(0, h + 6), abs(h + rng.uniform(-6, 6))])


def footprint_rows(rng):
    for _ in range(80):
        a1 = 10 ** rng.uniform(-2, 5)
        a2 = a1 * 10 ** rng.uniform(-4, 0)
        sigma = rng.choice([10.0, 60.0, 10 ** rng.uniform(0, 2)])
        cos_phi = rng.choice([0.0, 1.0, -1.0, rng.uniform(-1, 1), 1 - 10 ** rng.uniform(-15, -2)])
        h = math.sqrt(a1 * a1 * (1 - cos_phi) * (1 + cos_phi) + (a2 * cos_phi) ** 2)
        yield a1, a2, cos_phi, rng.choice([0.0, rng.uniform(0, h), h, abs(h + rng.uniform(-6, 6) * sigma)]), sigma


def energy_rows(rng):
    for _ in range(160):
        sigma = rng.choice([10.0, 60.0, 10 ** rng.uniform(0, 2)])
        xi1 = rng.choice([0.0, rng.uniform(-2, 2), rng.uniform(-1, 1) * 10 ** rng.uniform(-6, 0)])
        yield sigma, rng.uniform(0.38, 0.78), xi1, 10 ** rng.uniform(-3, 6)
    yield 10.0, 0.55, 0.3, 0.0


def shares(rng):
    yield from [0.5, 0.25, 0.75, 0.1, 0.9, 1e-3, 0.999, math.nextafter(0.5, 0.0), math.nextafter(0.5, 1.0), 1 - 2.0**-53]
    yield from [5e-324, 1e-300, 1e-100, 1e-50, 1e-34, 1e-30, 1e-17, 1e-12, 3e-10, 1e-8, 1e-5, 0.5 - 1e-8, 0.5 + 1e-4]
    for n in [1, 2, 3, 10, 100, 10**4, 10**6]:
        ctx.prec = 300
        at_zero = float(tail(n * arb.pi()) / arb.pi())
        yield from [at_zero, math.nextafter(at_zero, 0.0), 1 - at_zero]
    for _ in range(80):
        yield rng.uniform(0, 1)
        yield 10 ** rng.uniform(-14, -1)


def pair_columns(columns, value):
    return columns(value.real) + columns(value.imag)


PAIR = "re_hi,re_lo,re_exponent,re_decimal,im_hi,im_lo,im_exponent,im_decimal"
REAL = "hi,lo,exponent,decimal"


def tables(table, columns):
    """All tables by name, with make.py's writers."""
    out = {}

    def add(function, names, rows, is_complex):
        lines = []
        for row in sorted(set(rows)):
            if function in (profile_rectangle, profile_triangle):
                value = certified_against(row[0], lambda: function(*row))
            else:
                value = certified(lambda: function(*row))
            lines.append([x.hex() for x in row] + (pair_columns(columns, value) if is_complex else columns(value)))
        out[function.__name__ + ".csv"] = table(names + "," + (PAIR if is_complex else REAL), lines)

    rng = random.Random(20180704)
    add(spatial_phase, "sigma,lambda,xi1,xi2,s_t,s_b,l1,l2", spatial_phase_rows(rng), True)
    profiles = list(profile_rows(rng))
    add(profile_rectangle, "width,depth,xi2,gamma_sum,lambda", profiles, True)
    add(profile_triangle, "width,depth,xi2,gamma_sum,lambda", profiles + list(pole_rows(rng)), True)
    add(footprint_mean_reduced, "H,C", footprint_reduced_rows(rng), False)
    add(footprint_mean, "a1,a2,cos_phi,offset,sigma", footprint_rows(rng), False)
    add(segment_energy, "sigma,lambda,xi1,length", energy_rows(rng), False)
    add(sinc_squared_inverse, "u", ((u,) for u in shares(rng)), False)
    return out
