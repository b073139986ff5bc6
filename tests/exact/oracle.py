"""The truth about a system of polynomials with rational coefficients, by exact algebra: Singular and PARI/gp.

Singular finds the dimension, the components of positive dimension, and the matrices of multiplication by two random linear forms in
the quotient ring of the isolated part. gp factors their characteristic polynomials: a root of multiplicity m of the
system is a root of multiplicity m of that polynomial, and it is real where the form's value is, if the form separates the
roots. Of two forms the one that tells more roots apart is taken.
"""

import os
import selectors
import signal
import subprocess
import time
from fractions import Fraction

from polynomials import exact, text

SINGULAR = r"""
LIB "primdec.lib";
option(noredefine);
proc one_matrix(ideal I, poly t, poly all)
{
  ideal B = kbase(I);
  matrix M = coeffs(reduce(t*B, I), B, all);
  print("MATRIX " + string(ncols(B)));
  print(string(M));
}
proc truth(ideal I, poly t, poly u, poly all)
{
  ideal J = std(I);
  int d = dim(J);
  print("DIM " + string(d));
  if (d == 0) { one_matrix(J, t, all); one_matrix(J, u, all); }
  if (d > 0)
  {
    list L = primdecGTZ(I);
    int a; int b; int alone;
    for (a = 1; a <= size(L); a++)
    {
      ideal P = std(L[a][2]);
      int e = dim(P);
      alone = 1;
      for (b = 1; b <= size(L); b++)
      {
        if (b != a)
        {
          ideal R = L[b][2];
          if (dim(std(R)) > e) { if (size(reduce(R, P)) == 0) { alone = 0; } }
          kill R;
        }
      }
      if (alone == 1)
      {
        if (e > 0) { print("FAMILY " + string(e) + " " + string(mult(P))); }
        else { ideal Q = std(L[a][1]); one_matrix(Q, t, all); one_matrix(Q, u, all); kill Q; }
      }
      kill P; kill e;
    }
  }
}
"""

GP = r"""
default(parisizemax,2000000000);
default(realprecision,120);
{truth(v,n)=my(M=matrix(n,n,i,j,v[(i-1)*n+j]),f=factor(charpoly(M)));
for(k=1,#f~,print("FACTOR ",f[k,2]," ",poldegree(f[k,1])," ",polsturm(f[k,1])));}
{places(v,n)=my(M=matrix(n,n,i,j,v[(i-1)*n+j]),f=factor(charpoly(M)));
for(k=1,#f~,my(z=polroots(f[k,1]));for(j=1,#z,print("PLACE ",f[k,2]," ",precision(real(z[j])+0.,57)," ",precision(imag(z[j])+0.,57))));}
"""


class Slow(Exception):
    """No answer within the time limit."""


class Engine:
    """A program that answers line by line; it is started anew when an answer takes too long."""

    def __init__(self, command, first, echo):
        self.command, self.first, self.echo, self.process = command, first, echo, None

    def start(self):
        self.process = subprocess.Popen(
            self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, start_new_session=True
        )
        os.set_blocking(self.process.stdout.fileno(), False)
        self.selector = selectors.DefaultSelector()
        self.selector.register(self.process.stdout, selectors.EVENT_READ)
        self.rest = b""
        self.ask(self.first, 60)

    def stop(self):
        if self.process:
            try:
                os.killpg(self.process.pid, signal.SIGKILL)
            except ProcessLookupError:
                pass
            self.process.wait()
            self.process.stdin.close()
            self.process.stdout.close()
            self.process = None

    def ask(self, code, seconds):
        if not self.process:
            self.start()
        os.set_blocking(self.process.stdin.fileno(), True)
        try:
            self.process.stdin.write((code + "\n" + self.echo + "\n").encode())
            self.process.stdin.flush()
        except BrokenPipeError:
            self.stop()
            raise Slow("it ended")
        end = time.monotonic() + seconds
        data = self.rest
        while b"@@END\n" not in data:
            left = end - time.monotonic()
            if left <= 0 or not self.selector.select(left):
                self.stop()
                raise Slow(f"no answer within {seconds} s")
            piece = self.process.stdout.read(1 << 16)
            if piece == b"":
                self.stop()
                raise Slow("it ended")
            data += piece or b""
        answer, _, self.rest = data.partition(b"@@END\n")
        return answer.decode()


class Truth:
    """What is true of a system.

    roots: (multiplicity, number of roots, number of real ones), of isolated roots; families: {dimension: degree}; places: the
    value of the form at each isolated root, as (multiplicity, real part, imaginary part) in decimals. turns: every solution
    is one of a curve, and the families are not known.
    """

    def __init__(self):
        self.dimension, self.roots, self.families, self.form, self.places = -1, [], {}, [], []
        self.turns = False

    @property
    def distinct(self):
        return sum(n for _, n, _ in self.roots)

    @property
    def real(self):
        return sum(r for _, _, r in self.roots)

    @property
    def total(self):
        return sum(m * n for m, n, _ in self.roots)

    def multiplicities(self):
        y = {}
        for m, n, _ in self.roots:
            y[m] = y.get(m, 0) + n
        return y

    def document(self):
        return {
            "dimension": self.dimension,
            "distinct": self.distinct,
            "real": self.real,
            "with_multiplicity": self.total,
            "multiplicities": {str(m): n for m, n in sorted(self.multiplicities().items())},
            "families": {str(d): k for d, k in self.families.items()},
        }


class Oracle:
    def __init__(self, seconds=20):
        self.seconds = seconds
        self.singular = Engine(["Singular", "-q", "--ticks-per-sec=1000"], SINGULAR, 'print("@@END");')
        self.gp = Engine(["gp", "-q", "-f"], GP, 'print("@@END");')

    def stop(self):
        self.singular.stop()
        self.gp.stop()

    def truth(self, equations, n, scale=None):
        """Of equations in n unknowns. scale: sizes of the unknowns, by which they are divided first. Throws Slow."""
        names = [f"x({k + 1})" for k in range(n)]
        if scale:
            reduced = []
            for f in equations:
                g = {}
                for e, c in f.items():
                    for k, s in zip(e, scale):
                        c *= s**k
                    g[e] = c
                largest = max(abs(c) for c in g.values())
                reduced.append({e: c / largest for e, c in g.items()})
            equations = reduced
        # with coefficients below 40 both forms took the same value at two of the eight roots of sin(x - y) = -4/5 and its like
        forms = [[(457 * k * k + 613 * k + 103) % 997 + 1 for k in range(n)], [(311 * k * k + 509 * k + 217) % 991 + 2 for k in range(n)]]
        words = ["+".join(f"{c}*{x}" for c, x in zip(form, names)) for form in forms]
        code = f"ring r=0,(x(1..{n})),dp; short=0; ideal I={','.join(text(f, names, exact) for f in equations)};"
        code += f"truth(I,{words[0]},{words[1]},{'*'.join(names)}); kill I; kill r;"
        answer = self.singular.ask(code, self.seconds)
        y = Truth()
        matrices = []
        size = 0
        for line in answer.splitlines():
            if line.startswith("DIM "):
                y.dimension = int(line[4:])
            elif line.startswith("FAMILY "):
                d, k = map(int, line.split()[1:])
                y.families[d] = y.families.get(d, 0) + k
            elif line.startswith("MATRIX "):
                size = int(line[7:])
                matrices.append([size, ""])
            elif "?" in line or "error" in line:
                raise Slow("Singular: " + line.strip())
            elif matrices:
                matrices[-1][1] += line
        if "DIM" not in answer:
            raise Slow("Singular said nothing")
        pairs = list(zip(matrices[::2], matrices[1::2]))
        found = [[], []]
        for pair in pairs:
            for which, (size, entries) in enumerate(pair):
                out = self.gp.ask(f"truth([{entries}],{size})", self.seconds)
                if "***" in out:
                    raise Slow("gp: " + out.strip())
                found[which] += [tuple(map(int, line.split()[1:])) for line in out.splitlines() if line.startswith("FACTOR")]
        better = 0 if sum(d for _, d, _ in found[0]) >= sum(d for _, d, _ in found[1]) else 1
        y.roots = found[better]
        y.form = forms[better]
        self.asked = [pair[better] for pair in pairs]
        return y

    def find_places(self, y):
        """The values of the form at the isolated roots of the last system asked for."""
        for size, entries in self.asked:
            out = self.gp.ask(f"places([{entries}],{size})", self.seconds)
            if "***" in out:
                raise Slow("gp: " + out.strip())
            for line in out.splitlines():
                if line.startswith("PLACE"):
                    m, re, im = line.replace(" E", "e").split()[1:]
                    y.places.append((int(m), re.replace("E", "e"), im.replace("E", "e")))


def trigonometric_system(sums, n_angles, n_coordinates):
    """Equations in angles and coordinates as polynomials in cosines, sines and coordinates, with c^2 + s^2 = 1."""
    from polynomials import as_polynomial

    n = 2 * n_angles + n_coordinates
    equations = [as_polynomial(f, n_angles, n_coordinates) for f in sums]
    for a in range(n_angles):
        c = tuple(2 * int(j == 2 * a) for j in range(n))
        s = tuple(2 * int(j == 2 * a + 1) for j in range(n))
        equations.append({c: Fraction(1), s: Fraction(1), (0,) * n: Fraction(-1)})
    return equations


def turning_truth():
    """What is true of every model that does not change when angles turn together: no root is isolated. Its curves are not known."""
    y = Truth()
    y.turns, y.dimension, y.form = True, 1, [1] * 99
    return y
