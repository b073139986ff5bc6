"""The models that several tests use."""

import equilibria as eq


def chain(t, p):
    """Baillieul's rotating chain of two links; lengths over the first one, alpha = m2 / (m1 + m2)."""
    s1, s2 = eq.sin(t[0]), eq.sin(t[1])
    kinetic = 0.5 * p.omega**2 * ((1 - p.alpha) * s1**2 + p.alpha * (s1 + p.r * s2) ** 2)
    return -kinetic - eq.cos(t[0]) - p.alpha * p.r * eq.cos(t[1])


def rotating_chain():
    return eq.Model(chain, angles=["t1", "t2"], parameters={"alpha": 0.33, "omega": 2.0, "r": 1.5})


text = """{
  "angles": ["t1", "t2"],
  "parameters": {"alpha": 0.33, "omega": 2, "r": 1.5},
  "potential": "-0.5*omega^2*((1-alpha)*sin(t1)^2 + alpha*(sin(t1)+r*sin(t2))^2) - cos(t1) - alpha*r*cos(t2)"
}"""


def from_sympy():
    import sympy
    from sympy import cos, sin

    t1, t2, alpha, omega, r = sympy.symbols("t1 t2 alpha omega r")
    v = (
        -(omega**2) / 2 * ((1 - alpha) * sin(t1) ** 2 + alpha * (sin(t1) + r * sin(t2)) ** 2)
        - cos(t1)
        - alpha * r * cos(t2)
    )
    return v, eq.Model.from_sympy(v, angles=[t1, t2], parameters={alpha: 0.33, omega: 2, r: 1.5})
