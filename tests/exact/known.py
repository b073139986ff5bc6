"""Systems by hand: small ones, each of a kind that homotopy continuation easily answers amiss."""

import ast
from fractions import Fraction

from polynomials import add, constant, power, scaled, times, variable
from systems import model, polynomials, put

POLYNOMIALS = [
    ("x", "(x-1)**2 - Fraction(1, 10**10)"),
    ("x", "(x-1)**3*(200*x-201)"),
    ("x", "x**2 - 10**12"),
    ("x", "x**2 + Fraction(1, 10**18)"),
    ("xy", "x**2 + x*y - 200", "x**12 + y - 200"),
    ("xy", "x*y**8 + 1", "x**6 + x**3*y**6"),
    ("xy", "8*y**4 - 2*x**5*y", "8*x**5*y - 2*x**2*y**3 + 1"),
    ("xy", "(x+y-1)**2", "x - 3*y - 1"),
    ("xy", "-2*x**9 - 9*x**5*y**2 + 9*x**3*y**4", "5*x*y**4 - 2*x**8*y"),
    ("xyzw", "2*x*y**2*z**2 - 2*w*x", "2*x**2*y*z**2 - 2*w*y", "2*x**2*y**2*z - 2*w*z", "x**2 + y**2 + z**2 - 1"),
    ("xy", "5*x**2*y**3 - 6*x**4*y**3", "-7*x**5 - x**3*y - 4*y**4 - 6*y**2"),
    ("xyz", "-4*x*y**2", "-4*x**2*y + 8*y*z**2", "8*y**2*z"),
    ("yx", "y**4 - 2*y**3 - 8*y**2 - Fraction(5, 10**110)*y", "x - 3*y**2 + y"),
    ("yx", "y**4 - 2*y**3 - 8*y**2 - Fraction(5, 10**175)*y", "x - 3*y**2 + y"),
    ("xyz", "-(x-2*y+z+1)*(y+2*z+2)**2", "-2*(y+2*z+2)**2*(2*x+y+2*z+1)**2", "(y+2*z+2)*(x-y-2*z-2)"),
    ("xyz", "-8*x**3 + 2*x*y**2 + 2*x*z**2", "2*x**2*y", "2*x**2*z"),
    ("xyz", "3*z**2", "z", "6*x*z + y"),
    ("xyz", "4*z**3", "-3*z**2", "12*x*z**2 - 6*y*z"),
    ("xyz", "-(x-y+2)*(2*x-2*y-z-1)**2*(2*x-2*y+z-1)", "2*(x-y+2)**2", "(x-y+2)**4"),
    ("xy", "(2*x-3*y)**3 + 7*(2*x-3*y)**2 - Fraction(1, 2**191)*(2*x-3*y)", "-3*x + 4*y + 2"),
    ("xyz", "-(x-2*y+2*z)**2*(y+z+1)", "(2*x+2*y+z-1)**2", "-(y-z)*(x-2*y+2*z)*(2*x+2*y+z-1)"),
    ("xyz", "(2*y+z)*(2*x-2*y-2*z+1)", "2*(2*y+z)*(x-2*y+z+2)*(2*x-2*y-2*z+1)", "-3*(2*y+z)**2*(2*x-2*y-2*z+1)"),
    ("xy", "y**4 + 11*y**3 + 18*y**2 + Fraction(11, 2**792)*y + Fraction(18, 2**792)", "x + 3*y**2 + 2*y"),
    ("xy", "8*y**5 - 3*x**3*y**3", "7*x**4 - 9*y**4 + 9*y**2 + 4*y"),
]
# name of the kind, angles, coordinates, formulas: a term is (coefficient, kind, harmonics, exponents)
MODELS = [
    ("equations", 0, 2, [[(5, (1, 0)), (-1, (0, 0))], [(1, (9, 0)), (1, (0, 1)), (-20, (0, 0))]]),
    ("equations", 0, 2, [[(1, (2, 0)), (1, (1, 1)), (-200, (0, 0))], [(1, (7, 0)), (1, (0, 1)), (-200, (0, 0))]]),
    ("potential", 0, 1, [(Fraction(1, 2), (2,)), (Fraction(-1, 10**15), (4,))]),
    ("potential", 0, 1, [(1, (3,)), (-3 * 10**12, (1,))]),
    ("equations", 1, 0, [[(1, "sin", (1,), ()), (Fraction(1, 10**10) - 1, "cos", (0,), ())]]),
    ("potential", 1, 1, [(5 * 10**7, "cos", (0,), (2,)), (-(10**4), "cos", (1,), (1,)), (2, "sin", (1,), (0,))]),
    ("potential", 1, 1, [(5, "sin", (1,), (1,)), (Fraction(-9, 2), "cos", (0,), (4,)), (-5, "cos", (0,), (1,))]),
    ("potential", 2, 0, [(4, "cos", (1, -1), ()), (9, "sin", (1, -1), ()), (-1, "cos", (2, -2), ())]),
    ("potential", 1, 0, [(1, "cos", (20,), ()), (3, "sin", (19,), ())]),
    ("potential", 1, 0, [(1, "cos", (50,), ()), (3, "sin", (49,), ())]),
]


def _value(node, n, names):
    if isinstance(node, ast.BinOp):
        if isinstance(node.op, ast.Pow) and isinstance(node.right, ast.Constant):
            return power(_value(node.left, n, names), node.right.value, n)
        a, b = _value(node.left, n, names), _value(node.right, n, names)
        return times(a, b) if isinstance(node.op, ast.Mult) else add(a, b if isinstance(node.op, ast.Add) else scaled(b, -1))
    if isinstance(node, ast.UnaryOp):
        return scaled(_value(node.operand, n, names), -1)
    if isinstance(node, ast.Call):
        numerator, denominator = (_value(a, 0, "")[()] for a in node.args)
        return constant(n, numerator / denominator)
    return variable(n, names.index(node.id)) if isinstance(node, ast.Name) else constant(n, node.value)


def _sum(terms, n_angles):
    f = {}
    for term in terms:
        c, kind, k, e = term if len(term) == 4 else (term[0], "cos", (), term[1])
        put(f, kind, k or (0,) * n_angles, e, Fraction(float(c)))
    return f


def known(k):
    """The system with this number; they come again when all have been."""
    k %= len(POLYNOMIALS) + len(MODELS)
    if k < len(POLYNOMIALS):
        names, *formulas = POLYNOMIALS[k]
        return polynomials([_value(ast.parse(f, mode="eval").body, len(names), names) for f in formulas], len(names), most=1000)
    kind, n_angles, n_coordinates, formulas = MODELS[k - len(POLYNOMIALS)]
    if kind == "potential":
        return model(n_angles, n_coordinates, potential=_sum(formulas, n_angles))
    return model(n_angles, n_coordinates, equations=[_sum(f, n_angles) for f in formulas])
