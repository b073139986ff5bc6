"""Exact polynomials and trigonometric sums, and how they are written for the programs and for the algebra systems.

A polynomial is a dictionary: tuple of exponents -> Fraction. A sum over angles and coordinates is a dictionary:
(kind, harmonics, exponents) -> Fraction, kind "cos" or "sin", which stands for
coefficient * coordinates^exponents * kind(harmonics . angles).
"""

from fractions import Fraction
from math import comb


def constant(n, value):
    return {(0,) * n: Fraction(value)} if value else {}


def variable(n, i):
    return {tuple(int(j == i) for j in range(n)): Fraction(1)}


def add(*terms):
    y = {}
    for f in terms:
        for e, c in f.items():
            s = y.get(e, 0) + c
            if s:
                y[e] = s
            else:
                y.pop(e, None)
    return y


def times(f, g):
    y = {}
    for a, c in f.items():
        for b, d in g.items():
            e = tuple(i + j for i, j in zip(a, b))
            y[e] = y.get(e, 0) + c * d
    return {e: c for e, c in y.items() if c}


def scaled(f, factor):
    return {e: c * factor for e, c in f.items()} if factor else {}


def power(f, k, n):
    y = constant(n, 1)
    for _ in range(k):
        y = times(y, f)
    return y


def substitute(f, images, n):
    """The polynomial f with each variable replaced by a polynomial in n variables."""
    y = {}
    for e, c in f.items():
        t = constant(n, c)
        for k, g in zip(e, images):
            t = times(t, power(g, k, n))
        y = add(y, t)
    return y


def derivative(f, i):
    y = {}
    for e, c in f.items():
        if e[i]:
            y[e[:i] + (e[i] - 1,) + e[i + 1:]] = c * e[i]
    return y


def degree(f):
    return max((sum(e) for e in f), default=-1)


def rounded(f):
    """The polynomial that a program reads: each coefficient as the double nearest to it."""
    y = {e: Fraction(float(c)) for e, c in f.items()}
    return {e: c for e, c in y.items() if c}


def number(c):
    """A coefficient that is a double, in decimals that read as this double."""
    assert Fraction(float(c)) == c, c
    return str(int(c)) if c.denominator == 1 and abs(c) < 10**15 else repr(float(c))


def _monomial(e, names):
    return "*".join(name if k == 1 else f"{name}^{k}" for name, k in zip(names, e) if k)


def text(f, names, coefficient=number):
    """The polynomial as both programs and Singular read it."""
    out = ""
    for e, c in sorted(f.items(), reverse=True):
        m = _monomial(e, names)
        size = coefficient(abs(c))
        body = size if not m else m if size == "1" else f"{size}*{m}"
        sign = "-" if c < 0 else "+"
        out += (f" {sign} " if out else "-" if c < 0 else "") + body
    return out or "0"


def exact(c):
    return str(c.numerator) if c.denominator == 1 else f"{c.numerator}/{c.denominator}"


# Sums over angles and coordinates.


def sum_text(f, angles, coordinates):
    """The formula of a model file."""
    out = ""
    for (kind, k, e), c in sorted(f.items(), reverse=True):
        parts = [number(abs(c))]
        if any(k):
            inner = ""
            for a, name in zip(k, angles):
                if a:
                    body = name if abs(a) == 1 else f"{abs(a)}*{name}"
                    inner += ((" - " if a < 0 else " + ") if inner else "-" if a < 0 else "") + body
            parts.append(f"{kind}({inner})")
        m = _monomial(e, coordinates)
        if m:
            parts.append(m)
        out += ((" - " if c < 0 else " + ") if out else "-" if c < 0 else "") + "*".join(parts)
    return out or "0"


def sum_derivative(f, unknown, n_angles):
    """By an angle (unknown < n_angles) or by a coordinate."""
    y = {}

    def put(key, c):
        s = y.get(key, 0) + c
        if s:
            y[key] = s
        else:
            y.pop(key, None)

    for (kind, k, e), c in f.items():
        if unknown < n_angles:
            if k[unknown]:
                other = "sin" if kind == "cos" else "cos"
                put((other, k, e), c * k[unknown] * (-1 if kind == "cos" else 1))
        else:
            i = unknown - n_angles
            if e[i]:
                put((kind, k, e[:i] + (e[i] - 1,) + e[i + 1:]), c * e[i])
    return y


def as_polynomial(f, n_angles, n_coordinates):
    """The sum as a polynomial in c1, s1, c2, s2, .. and the coordinates."""
    n = 2 * n_angles + n_coordinates
    y = {}
    for (kind, k, e), c in f.items():
        re, im = constant(n, 1), {}
        for a, harmonic in enumerate(k):
            z_re, z_im = {}, {}
            sign = -1 if harmonic < 0 else 1
            h = abs(harmonic)
            for j in range(h + 1):  # (c + i s)^h
                exponents = [0] * n
                exponents[2 * a], exponents[2 * a + 1] = h - j, j
                value = Fraction(comb(h, j) * (1, 1, -1, -1)[j % 4])
                if j % 2:
                    z_im[tuple(exponents)] = value * sign
                else:
                    z_re[tuple(exponents)] = value
            re, im = add(times(re, z_re), scaled(times(im, z_im), -1)), add(times(re, z_im), times(im, z_re))
        exponents = (0,) * (2 * n_angles) + tuple(e)
        y = add(y, times(re if kind == "cos" else im, {exponents: c}))
    return y
