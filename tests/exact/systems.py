"""Generators of systems by class; each draws from a random.Random and makes what a program reads exactly."""

from fractions import Fraction
from math import prod

from polynomials import (add, constant, degree, derivative, power, rounded, scaled, substitute, sum_derivative, sum_text, text, times,
                         variable)


class System:
    """Polynomials, or a model with angles and coordinates, and how a program reads it."""

    def __init__(self, n_angles=0, n_coordinates=0):
        self.n_angles, self.n_coordinates = n_angles, n_coordinates
        self.equations = []  # polynomials, or sums of a model
        self.potential = None  # of a model
        self.model = False
        self.scale = None  # sizes of coordinates that the oracle divides by
        self.turns = False  # nothing changes when its angles turn together: each solution is one of a curve

    @property
    def angles(self):
        return [f"t{k + 1}" for k in range(self.n_angles)]

    @property
    def coordinates(self):
        n = self.n_coordinates
        return ["x", "y", "z", "w", "v", "u"][:n] if n <= 6 else [f"x{k + 1}" for k in range(n)]

    def sums(self):
        """The equations of a model, those of a potential its derivatives."""
        if self.potential is None:
            return self.equations
        return [sum_derivative(self.potential, k, self.n_angles) for k in range(self.n_angles + self.n_coordinates)]

    def extension(self):
        return "json" if self.model else "txt"

    def text(self):
        if not self.model:
            lines = [text(f, self.coordinates) + ";" for f in self.equations]
            return "\n".join([str(len(lines))] + lines) + "\n"
        keys = []
        if self.n_angles:
            keys.append(f'"angles": {names(self.angles)}')
        if self.n_coordinates:
            keys.append(f'"coordinates": {names(self.coordinates)}')
        if self.potential is not None:
            keys.append(f'"potential": "{sum_text(self.potential, self.angles, self.coordinates)}"')
        else:
            formulas = [sum_text(f, self.angles, self.coordinates) for f in self.equations]
            keys.append(f'"equations": {names(formulas)}')
        return "{" + ",\n ".join(keys) + "}\n"


def names(words):
    return "[" + ", ".join(f'"{w}"' for w in words) + "]"


def polynomials(equations, n, scale=None, most=80):
    """A system for solve, or None if a program would be right to refuse it, or if it has an unknown that no equation has."""
    if any(abs(c) > 1e250 or abs(c) < 1e-250 for f in equations for c in f.values()):
        return None
    equations = [rounded(f) for f in equations]
    if any(degree(f) < 1 for f in equations) or len(equations) != n:
        return None
    if any(all(e[k] == 0 for f in equations for e in f) for k in range(n)):
        return None
    if prod(degree(f) for f in equations) > most:
        return None
    y = System(0, n)
    y.equations, y.scale = equations, scale
    return y


def nonzero(r, most=9):
    return Fraction(r.choice([-1, 1]) * r.randint(1, most))


def exponents(r, n, most):
    left, y = r.randint(0, most), []
    for _ in range(n - 1):
        k = r.randint(0, left)
        y.append(k)
        left -= k
    y.append(left)
    r.shuffle(y)
    return tuple(y)


def sparse_polynomial(r, n, most, terms, size=9):
    y = {}
    for _ in range(terms):
        y[exponents(r, n, most)] = nonzero(r, size)
    if r.random() < 0.6:
        y[(0,) * n] = nonzero(r, size)
    return y


def dense_polynomial(r, n, most, size=9):
    y = {}

    def fill(e, left):
        if len(e) == n:
            c = r.randint(-size, size)
            if c:
                y[tuple(e)] = Fraction(c)
            return
        for k in range(left + 1):
            fill(e + [k], left - k)

    fill([], most)
    return y


def form(r, n, most, size=9):
    return {e: c for e, c in dense_polynomial(r, n, most, size).items() if sum(e) == most}


def linear(r, n, size=5):
    f = {}
    while degree(f) < 1:
        f = dense_polynomial(r, n, 1, size)
    return f


def sparse(r):
    n = r.choice([1, 2, 2, 2, 3])
    most = {1: 12, 2: 7, 3: 4}[n]
    return polynomials([sparse_polynomial(r, n, r.randint(2, most), r.randint(2, 4)) for _ in range(n)], n)


def dense(r):
    n = r.choice([1, 2, 2, 3])
    degrees = {1: [r.randint(2, 12)], 2: [r.randint(1, 4), r.randint(2, 4)], 3: [r.randint(1, 2), 2, r.randint(2, 3)]}[n]
    return polynomials([dense_polynomial(r, n, d) for d in degrees], n)


def univariate(r):
    x, f = variable(1, 0), constant(1, 1)
    while degree(f) < 1 or (r.random() < 0.7 and degree(f) < 9):
        m = r.choice([1, 1, 2, 2, 3, 4])
        if r.random() < 0.7:
            factor = add(scaled(x, r.choice([1, 1, 2, 3, 4])), constant(1, r.randint(-9, 9)))
        else:
            factor = add(power(x, 2, 1), scaled(x, r.randint(-4, 4)), constant(1, r.randint(-9, 9)))
        f = times(f, power(factor, m, 1))
    if degree(f) > 14 or any(abs(c) > 2**53 for c in f.values()):
        return univariate(r)
    return polynomials([f], 1)


def turned(r, equations):
    """The same in other coordinates: unknowns become linear forms with determinant 1 or so."""
    n = 2
    a, b = r.randint(-2, 2), r.randint(-2, 2)
    x, y = variable(2, 0), variable(2, 1)
    images = [add(x, scaled(y, a), constant(2, r.randint(-2, 2))), add(scaled(x, b), scaled(y, 1 + a * b), constant(2, r.randint(-2, 2)))]
    return [substitute(f, images, n) for f in equations]


def clusters(r):
    x = variable(1, 0)
    f = constant(1, 1)
    for _ in range(r.choice([1, 1, 1, 2])):
        at = Fraction(r.randint(-5, 5), r.choice([1, 1, 2, 4]))
        many = r.choice([2, 2, 2, 3, 4])
        gap = Fraction(1, 10 ** r.randint(3, 10))
        for k in range(many):
            f = times(f, add(x, constant(1, -at - gap * (k if r.random() < 0.7 else r.randint(0, 1)))))
    for _ in range(r.randint(0, 2)):
        f = times(f, add(x, constant(1, r.randint(-9, 9))))
    if r.random() < 0.6:
        return polynomials([f], 1)
    g = {(e[0], 0): c for e, c in f.items()}
    h = add(variable(2, 1), {(e[0], 0): c for e, c in dense_polynomial(r, 1, r.randint(1, 2), 3).items()})
    equations = [g, h] if r.random() < 0.5 else turned(r, [g, h])
    return polynomials(equations, 2)


def narrow(r):
    """Roots nearer to each other than doubles show, or one multiple root: about 0 in one unknown, elsewhere in the other."""
    m = r.choice([2, 2, 2, 3, 4])
    f = power(variable(1, 0), m, 1)
    if r.random() < 0.7:
        by = Fraction(1, 2 ** r.randint(40, r.choice([300, 300, 900])))
        f = add(f, scaled(dense_polynomial(r, 1, r.randint(0, m - 1), 5), by))
    for _ in range(r.randint(0, 2)):
        f = times(f, add(variable(1, 0), constant(1, nonzero(r))))
    g = {(0, e[0]): c for e, c in f.items()}
    h = {(0, e[0]): -c for e, c in dense_polynomial(r, 1, r.randint(1, 2), 3).items()}
    h = add(add(h, variable(2, 0)), constant(2, nonzero(r)))
    return polynomials([g, h] if r.random() < 0.4 else turned(r, [g, h]), 2)


def multiple(r):
    kind = r.randint(0, 4)
    if kind == 0:  # a square
        f, g = power(linear(r, 2), r.choice([2, 2, 3]), 2), dense_polynomial(r, 2, r.randint(1, 2))
        return polynomials([f, g], 2)
    if kind == 1:  # no terms below the second order at a point
        a, b = r.randint(-3, 3), r.randint(-3, 3)
        images = [add(variable(2, 0), constant(2, -a)), add(variable(2, 1), constant(2, -b))]
        equations = []
        for _ in range(2):
            f = {}
            for order in (2, 3):
                if order == 2 or r.random() < 0.6:
                    f = add(f, form(r, 2, order, 5))
            equations.append(substitute(f, images, 2))
        return polynomials(equations, 2)
    if kind == 2:  # tangent curves
        g = dense_polynomial(r, 2, r.randint(1, 2), 5)
        f = add(times(g, dense_polynomial(r, 2, 1, 3)), power(linear(r, 2, 3), 2, 2))
        return polynomials([f, g], 2)
    if kind == 3:  # critical points of a degenerate function
        v = add(*[power(linear(r, 2, 3), r.choice([2, 3, 4]), 2) for _ in range(2)])
        return polynomials([derivative(v, 0), derivative(v, 1)], 2)
    f, g = power(linear(r, 2, 3), 2, 2), dense_polynomial(r, 2, 2, 5)
    h = add(variable(3, 2), {e + (0,): c for e, c in dense_polynomial(r, 2, r.randint(1, 2), 3).items()})
    return polynomials([{e + (0,): c for e, c in f.items()}, {e + (0,): c for e, c in g.items()}, h], 3)


def curves(r):
    kind = r.randint(0, 4)
    if kind <= 1:  # a common factor
        g = dense_polynomial(r, 2, r.randint(1, 2), 5)
        h = [dense_polynomial(r, 2, r.randint(0, 2), 5) for _ in range(2)]
        return polynomials([times(g, k) for k in h], 2)
    if kind == 2:  # a common monomial
        factor = {exponents(r, 2, 2): Fraction(1)}
        return polynomials([times(factor, sparse_polynomial(r, 2, r.randint(1, 4), 2)) for _ in range(2)], 2)
    if kind == 3:  # combinations of two
        g = [dense_polynomial(r, 3, d, 3) for d in (1, r.randint(1, 2))]
        equations = []
        for _ in range(3):
            a, b = dense_polynomial(r, 3, r.randint(0, 1), 3), dense_polynomial(r, 3, r.randint(0, 1), 3)
            equations.append(add(times(a, g[0]), times(b, g[1])))
        return polynomials(equations, 3)
    # even monomials on a sphere
    n = 2
    v = {tuple(r.choice([0, 2, 2]) for _ in range(n)): nonzero(r, 3) for _ in range(r.randint(1, 2))}
    lag = {e + (0,): c for e, c in v.items()}
    sphere = add(power(variable(3, 0), 2, 3), power(variable(3, 1), 2, 3), constant(3, -1))
    lag = add(lag, times(scaled(variable(3, 2), -1), sphere))
    return polynomials([derivative(lag, k) for k in range(3)], 3)


def surfaces(r):
    """Surfaces and curves of one system, simple, multiple and embedded in one another, and roots beside them."""
    kind = r.randint(0, 4)
    if kind == 0:  # gradients of a few monomials
        v = {exponents(r, 3, 4): nonzero(r, 4) for _ in range(r.randint(2, 4))}
        return polynomials([derivative(v, k) for k in range(3)], 3)
    if kind == 1:  # monomials by sparse polynomials
        shared = exponents(r, 3, 2)
        return polynomials([times({shared: Fraction(1)}, sparse_polynomial(r, 3, 2, r.randint(1, 3), 4)) for _ in range(3)], 3)
    if kind == 2:  # products of few planes
        planes = [linear(r, 3, 2) for _ in range(4)]
        equations = []
        for _ in range(3):
            f = constant(3, nonzero(r, 3))
            for _ in range(r.randint(2, 4)):
                f = times(f, r.choice(planes))
            equations.append(f)
        return polynomials(equations, 3)
    if kind == 3:  # a common factor by equations with a curve, or without
        shared = r.choice([linear(r, 3, 2), {e: c for e, c in dense_polynomial(r, 3, 2, 2).items() if r.random() < 0.5}])
        g = [linear(r, 3, 2), r.choice([linear(r, 3, 2), dense_polynomial(r, 3, 2, 2)])]
        equations = []
        for _ in range(3):
            f = add(times(dense_polynomial(r, 3, r.randint(0, 1), 2), g[0]), times(constant(3, r.randint(-2, 2)), g[1]))
            equations.append(times(shared, f))
        return polynomials(equations, 3)
    # a double curve where two squares meet, and another by a factor
    a, b, c = linear(r, 3, 2), linear(r, 3, 2), linear(r, 3, 2)
    equations = [times(power(a, 2, 3), c), times(power(b, 2, 3), r.choice([c, constant(3, 1)])), times(times(a, b), linear(r, 3, 2))]
    return polynomials(equations, 3)


def infinity(r):
    kind = r.randint(0, 2)
    if kind == 0:  # leading forms with a common factor
        d, e = r.randint(2, 3), r.randint(2, 3)
        common = form(r, 2, 1, 3)
        if not common:
            return None
        f = add(times(common, form(r, 2, d - 1, 4)), dense_polynomial(r, 2, r.randint(0, d - 1), 5))
        g = add(times(common, form(r, 2, e - 1, 4)), dense_polynomial(r, 2, r.randint(0, e - 1), 5))
        return polynomials([f, g], 2)
    if kind == 1:  # the same leading form, or two of three alike
        d = r.randint(2, 3)
        top = form(r, 2, d, 4)
        return polynomials([add(scaled(top, r.randint(1, 3)), dense_polynomial(r, 2, r.randint(1, d - 1), 5)) for _ in range(2)], 2)
    top = form(r, 3, 2, 3)
    f = [add(top, dense_polynomial(r, 3, 1, 4)), add(top, dense_polynomial(r, 3, 1, 4)), dense_polynomial(r, 3, r.randint(1, 2), 4)]
    return polynomials(f, 3)


def rescale(r, system, base, decades=9):
    """Unknowns and equations in other units, by powers of the base up to so many decades."""
    if not system:
        return None
    most = decades if base == 10 else decades * 10 // 3
    n = system.n_coordinates
    scale = [Fraction(base) ** r.randint(-most, most) for _ in range(n)]
    equations = []
    for f in system.equations:
        factor = Fraction(base) ** r.randint(-most, most)
        equations.append({e: c * factor / prod(s**k for s, k in zip(scale, e)) for e, c in f.items()})
    return polynomials(equations, n, scale)


def scaled_unknowns(r):
    base = r.choice([2, 10])
    kind = r.choice([small_sparse, small_dense, small_dense] + ([multiple, infinity] if base == 2 else []))
    return rescale(r, kind(r), base)


def extreme(r):
    """Coefficients and unknowns far from 1, as doubles have them; exactly, by powers of two."""
    return rescale(r, r.choice([small_sparse, small_dense])(r), 2, r.choice([20, 40, 60]))


def small_sparse(r):
    n = r.choice([1, 2, 2])
    return polynomials([sparse_polynomial(r, n, r.randint(2, 4), r.randint(2, 3)) for _ in range(n)], n)


def small_dense(r):
    n = r.choice([1, 2, 2, 3])
    degrees = {1: [r.randint(2, 6)], 2: [2, r.randint(1, 3)], 3: [1, 2, 2]}[n]
    return polynomials([dense_polynomial(r, n, d) for d in degrees], n)


def wide(r):
    """Coefficients from 1e-6 to 1e6."""
    n = r.choice([1, 2, 2, 3])
    most = {1: 9, 2: 4, 3: 2}[n]
    equations = []
    for _ in range(n):
        f = sparse_polynomial(r, n, r.randint(2, most), r.randint(2, 4))
        equations.append({e: c * Fraction(10) ** r.randint(-6, 6) for e, c in f.items()})
    return polynomials(equations, n)


def far(r):
    """Unknowns that follow from others of a higher power."""
    n = r.choice([1, 2, 2])
    size = r.choice([20, 200, 1000, 10**6])
    if n == 1:
        x = variable(1, 0)
        return polynomials([add(power(x, r.randint(2, 5), 1), sparse_polynomial(r, 1, 1, 1), constant(1, nonzero(r, size) * size))], 1)
    x, y = variable(2, 0), variable(2, 1)
    f = add(sparse_polynomial(r, 2, 2, 2), constant(2, nonzero(r, size)))
    g = add(scaled(power(x, r.randint(3, 9), 2), nonzero(r, 3)), scaled(y, nonzero(r, 3)), constant(2, nonzero(r, size)))
    return polynomials([f, g], 2)


def nearly_real(r):
    x, f = variable(1, 0), constant(1, 1)
    for _ in range(r.choice([1, 1, 2])):
        e = Fraction(1, 10 ** r.randint(2, 12)) * r.randint(1, 9)
        at = r.choice([Fraction(0), Fraction(r.randint(-4, 4), r.choice([1, 2]))])
        f = times(f, add(power(add(x, constant(1, -at)), 2, 1), constant(1, e * e)))
    for _ in range(r.randint(0, 2)):
        f = times(f, add(x, constant(1, r.randint(-9, 9))))
    if r.random() < 0.5:
        return polynomials([f], 1)
    g = {(e[0], 0): c for e, c in f.items()}
    h = add(variable(2, 1), {(e[0], 0): c for e, c in dense_polynomial(r, 1, r.randint(1, 2), 3).items()})
    return polynomials([g, h] if r.random() < 0.5 else turned(r, [g, h]), 2)


def symmetric(r):
    kind = r.randint(0, 3)
    n = r.choice([2, 2, 3])
    if kind == 0:  # one polynomial, its variables turned round
        f = dense_polynomial(r, n, 2, 5) if n == 3 else dense_polynomial(r, n, r.randint(2, 3), 5)
        return polynomials([{tuple(e[(k + j) % n] for k in range(n)): c for e, c in f.items()} for j in range(n)], n)
    if kind == 1:  # odd
        f = [dense_polynomial(r, n, 3 if n == 2 else r.choice([1, 3]), 5) for _ in range(n)]
        return polynomials([{e: c for e, c in g.items() if sum(e) % 2} for g in f], n)
    if kind == 2:  # Noonburg's
        c, equations = nonzero(r, 5), []
        for i in range(n):
            f = add(scaled(variable(n, i), -c), constant(n, r.randint(1, 3)))
            for j in range(n):
                if j != i:
                    f = add(f, times(variable(n, i), power(variable(n, j), 2, n)))
            equations.append(f)
        return polynomials(equations, n)
    # critical points of a function of squares
    v = {tuple(2 * k for k in exponents(r, n, 2)): nonzero(r, 5) for _ in range(r.randint(2, 5))}
    return polynomials([derivative(v, k) for k in range(n)], n)


# Models


def model(n_angles, n_coordinates, potential=None, equations=None, scale=None):
    y = System(n_angles, n_coordinates)
    y.model, y.potential, y.scale = True, potential, scale
    y.equations = equations or []
    sums = y.sums()
    if any(not f or all(not any(k) and not any(e) for _, k, e in f) for f in sums):
        return None
    for u in range(n_angles + n_coordinates):
        if all((k + e)[u] == 0 for f in sums for _, k, e in f):
            return None
    return y


def put(f, kind, k, e, c):
    """Adds a term, in its one form: the first harmonic that is not 0 is positive."""
    first = next((j for j in k if j), 0)
    if first == 0 and kind == "sin":
        return
    if first < 0:
        k = tuple(-j for j in k)
        if kind == "sin":
            c = -c
    s = f.get((kind, tuple(k), tuple(e)), 0) + c
    if s:
        f[(kind, tuple(k), tuple(e))] = s
    else:
        f.pop((kind, tuple(k), tuple(e)), None)


def coefficient(r):
    return nonzero(r) / r.choice([1, 1, 1, 2, 4])


def harmonics(r):
    most = r.choice([3, 6, 10, 15, 20])
    f = {}
    for _ in range(r.randint(1, 4)):
        put(f, r.choice(["cos", "sin"]), (r.randint(1, most),), (), coefficient(r))
    if r.random() < 0.5:
        return model(1, 0, potential=f)
    if r.random() < 0.5:
        put(f, "cos", (0,), (), coefficient(r))
    return model(1, 0, equations=[f])


def angles(r):
    n = 2
    f = {}
    if r.random() < 0.6:
        for _ in range(r.randint(2, 5)):
            put(f, r.choice(["cos", "sin"]), tuple(r.choice([-1, 0, 0, 1, 1, 2]) for _ in range(n)), (), coefficient(r))
        return model(n, 0, potential=f)
    equations = []
    for _ in range(n):
        g = {}
        for _ in range(r.randint(1, 3)):
            put(g, r.choice(["cos", "sin"]), tuple(r.choice([-1, 0, 0, 1, 1]) for _ in range(n)), (), coefficient(r))
        put(g, "cos", (0,) * n, (), coefficient(r))
        equations.append(g)
    return model(n, 0, equations=equations)


def coordinate_potential(r):
    n = r.choice([1, 2, 2, 3])
    f = {}
    for _ in range(r.randint(2, 6)):
        put(f, "cos", (), exponents(r, n, {1: 6, 2: 4, 3: 3}[n]), coefficient(r))
    return model(0, n, potential=f)


def mixed_potential(r):
    n = r.choice([1, 1, 2])
    f = {}
    for _ in range(r.randint(2, 5)):
        put(f, r.choice(["cos", "sin"]), (r.randint(0, 2),), exponents(r, n, 2), coefficient(r))
    for k in range(n):
        if r.random() < 0.7:
            put(f, "cos", (0,), tuple(r.choice([2, 2, 3, 4]) if j == k else 0 for j in range(n)), coefficient(r))
    return model(1, n, potential=f)


def units(r):
    """A potential whose coordinates have other units, by powers of two."""
    base = (mixed_potential if r.random() < 0.6 else coordinate_potential)(r)
    if not base:
        return None
    scale = [Fraction(2) ** r.randint(-30, 30) for _ in range(base.n_coordinates)]
    f = {(kind, k, e): c / prod(s**j for s, j in zip(scale, e)) for (kind, k, e), c in base.potential.items()}
    return model(base.n_angles, base.n_coordinates, potential=f, scale=scale)


def orthogonal(r, w):
    """Harmonics that do not change when the angles turn by multiples of w."""
    while True:
        k = [r.choice([-1, 0, 0, 1, 1]) for _ in w]
        if r.random() < 0.3:
            k[r.randrange(len(w))] = r.choice([-2, 2])
        if any(k) and sum(a * b for a, b in zip(k, w)) == 0:
            return tuple(k)


def turning(r):
    """Models that do not change when all angles, or some, turn together, each by its own multiple of an angle."""
    n = r.choice([2, 2, 3, 3, 3, 4, 4, 5])
    while True:
        w = [1] * n if r.random() < 0.6 else [r.choice([-1, 0, 1, 1, 2]) for _ in range(n)]
        if any(w) and not (n == 2 and 0 in w):
            break
    coordinates = r.choice([0, 0, 0, 1]) if n < 4 else 0

    def put_terms(f, terms):
        for _ in range(terms):
            e = tuple(r.choice([0, 1]) for _ in range(coordinates))
            put(f, r.choice(["cos", "cos", "sin"]), orthogonal(r, w), e, coefficient(r))

    def put_powers(f):
        for k in range(coordinates):
            put(f, "cos", (0,) * n, tuple(r.choice([2, 2, 4]) if j == k else 0 for j in range(coordinates)), coefficient(r))

    if r.random() < 0.75:
        f = {}
        put_terms(f, r.randint(n - 1, n + 2))
        put_powers(f)
        y = model(n, coordinates, potential=f)
    else:
        equations = []
        for k in range(n + coordinates):
            g = {}
            put_terms(g, r.randint(1, 2))
            if k >= n:
                put_powers(g)
            elif r.random() < 0.3:
                put(g, "cos", (0,) * n, (0,) * coordinates, coefficient(r))
            equations.append(g)
        y = model(n, coordinates, equations=equations)
    if y:
        y.turns = True
    return y


CLASSES = {
    "sparse": sparse,
    "dense": dense,
    "univariate": univariate,
    "clusters": clusters,
    "narrow": narrow,
    "multiple": multiple,
    "curves": curves,
    "surfaces": surfaces,
    "infinity": infinity,
    "scaled": scaled_unknowns,
    "extreme": extreme,
    "wide": wide,
    "far": far,
    "nearly-real": nearly_real,
    "symmetric": symmetric,
    "harmonics": harmonics,
    "angles": angles,
    "turning": turning,
    "potentials": coordinate_potential,
    "mixed": mixed_potential,
    "units": units,
    "known": None,
}


def draw(name, r, k):
    """The first system that the class makes and that is none that is refused; of the known ones the one with number k."""
    if name == "known":
        from known import known

        return known(k)
    while True:
        y = CLASSES[name](r)
        if y:
            return y
