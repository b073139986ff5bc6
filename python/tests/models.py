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


def mechanism():
    """Vesovic and Radulovic's holonomic mechanism, which moves (docs/mechanism.md)."""

    def potential(q, p):
        weight = p.gravity * p.length * ((p.m1 + p.m2) * eq.sin(q[0]) - p.m2 * eq.cos(q[1]))
        springs = p.length**2 * (p.c1 * (1 - eq.sin(q[0] + q[1])) + p.c2 * (1 - eq.sin(q[0])))
        return weight + springs - p.force * p.length * (eq.cos(q[0]) - eq.sin(q[1]))

    def slider(q, v, p):
        return -p.length * eq.sin(q[0]) * (1 + eq.cos(q[0]) / eq.sqrt(3 + eq.cos(q[0]) ** 2)) * v.w1

    def kinetic_energy(q, v, p):
        rods = p.m1 * v.w1**2 + p.m2 * (v.w1**2 + 2 * eq.sin(q[0] + q[1]) * v.w1 * v.w2 + v.w2**2)
        return 0.5 * p.length**2 * rods + 0.5 * p.m3 * slider(q, v, p) ** 2

    def forces(t, q, v, p):
        change = p.force * p.length * (eq.exp(-p.decay * t) - 1)
        return [-change * eq.sin(q[0]), -change * eq.cos(q[1])]

    return eq.Model(
        potential,
        angles=["q1", "q2"],
        parameters={
            **{"m1": 10, "m2": 10, "m3": 10, "gravity": 9.80665, "length": 1.25, "c1": 162.5, "c2": 1100 / 3},
            **{"damping": 121, "force": 100, "decay": 0.7},
        },
        kinetic_energy=kinetic_energy,
        dissipation=lambda q, v, p: p.damping / 2 * slider(q, v, p) ** 2,
        generalised_forces=forces,
        rates=["w1", "w2"],
    )
