/// \file
/// Whether a singular solution is isolated or lies on a curve or surface of solutions: a local numerical dimension.
///
/// Where the Jacobian at q_0 has a null space N of dimension k, solutions of F = 0 near q_0 are sought on d slices
///     <a_i, q - q_0> = delta_i,  a_i in N random,  |delta| = h,
/// by Gauss-Newton steps, for d = k, k - 1, ..., 1. A family of dimension d meets every such set of slices close by, an
/// isolated root of whatever multiplicity none: there |F| stays at the size of h^m, m the order of its lowest term. A
/// dimension counts only if solutions are there at the distance, at half and at double of it, and if those on nearer
/// and nearer slices come back to q_0, or lead to a point that |F| does not part from it.
///
/// Where it fails: an isolated root whose lowest term is of order eight or more is flatter than rounding at the largest
/// distance, and passes for a family; so does a family that bends within the smallest distance for an isolated root.
/// Source of the idea: Bates, Hauenstein, Peterson, Sommese, A numerical local dimension test for points on
/// the solution set of a system of polynomial equations, SIAM J. Numer. Anal. 47 (2009).
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <optional>
#include <vector>

#include <equilibria/core/random.hpp>
#include <equilibria/core/singular_values.hpp>

namespace equilibria::detail {

/// A square analytic system of n equations. Equations are scaled so that rounding is about 1e-16, unknowns so that a
/// change of 1 is large: angles in radians, coordinates against their size.
class FamilyProbe {
public:
    using Vector = std::vector<std::complex<double>>;
    /// Sets f to F(q) and j to the Jacobian, column after column.
    using System = std::function<void(const Vector& q, Vector& f, Vector& j)>;

    /// A singular value below this share of the largest one counts as zero: the endpoint of a path is a multiple root
    /// to 1e-5 or better, and the singular value is wrong by as much.
    static constexpr double null_share = 1e-4;
    static constexpr double negligible = 3e-13;  ///< a residual that counts as zero

    static constexpr double inaccuracy = 1e-3;  ///< the largest, of endpoints on multiple families

    struct Finding {
        int nullity = 0, dimension = 0;  ///< dimension 0: isolated, as far as the probe can tell
        std::vector<Vector> tangent;     ///< an orthonormal basis of the null space
        Vector neighbour;
        double distance = 0, residual = 0;
        bool rank_drops = false;  ///< against other points of the family: walks begin at the neighbour
    };

    FamilyProbe(int n, System system) : n_(n), system_(std::move(system)) {}

    /// The local dimension of the solutions at q. real: within the real points, q being real.
    [[gnu::cold]] Finding at(const Vector& q, bool real = false) const {
        Finding y;
        Vector f, j;
        system_(q, f, j);
        const SingularValues svd(n_, n_, j);
        y.nullity = n_ - (svd[0] > negligible ? svd.rank(null_share) : 0);
        for (int k = n_ - y.nullity; k < n_; ++k) y.tangent.push_back(svd.right(k));
        Generator generator(0x2545f4914f6cdd1d);
        for (int d = y.nullity; d > 0; --d)
            for (const double distance : {0.1, 0.02})
                for (int attempt = 0; attempt < (d == y.nullity ? 1 : 4); ++attempt)
                    if (confirmed(q, d, distance, real, generator, y)) return y;
        return y;
    }

    /// Whether q lies on a family of dimension d, more than was found there, with more attempts and slices of all the
    /// space. The finding is then that. Another component through q may hide the family: Gauss-Newton steps towards it
    /// end at minima of |F|, and where all equations are singular the null space is one of rounding.
    [[gnu::cold]] bool lies_on(const Vector& q, int d, Finding& found) const {
        constexpr int attempts = 25;
        Generator generator(0x3c6ef372fe94f82b);
        Finding with = found;
        with.nullity = n_;
        with.tangent.assign(index(n_), Vector(index(n_)));
        for (int i = 0; i < n_; ++i) with.tangent[index(i)][index(i)] = 1;
        for (int attempt = 0; attempt < attempts; ++attempt)
            for (const double distance : {0.1, 0.02}) {
                if (!confirmed(q, d, distance, false, generator, with)) continue;
                with.nullity = std::max(found.nullity, d);
                with.tangent = std::move(found.tangent);
                with.rank_drops = true;
                found = std::move(with);
                return true;
            }
        return false;
    }

    /// The nearest solution of F = 0 that Gauss-Newton steps of least length lead to, the Jacobian having that rank.
    /// Nothing if they do not converge, or lead farther away than `most`.
    [[gnu::cold]] std::optional<Vector> projected(Vector q, int rank, double most) const {
        const Vector begin = q;
        Vector f, j;
        for (int round = 0; round < 30; ++round) {
            system_(q, f, j);
            const Vector step = SingularValues(n_, n_, j).solve(f, rank);
            for (int i = 0; i < n_; ++i) q[index(i)] -= step[index(i)];
            if (!(distance(q, begin) <= most)) return std::nullopt;
            if (largest(step) < 1e-12) {
                system_(q, f, j);
                if (vanishes(q, f)) return q;
                return std::nullopt;
            }
        }
        return std::nullopt;
    }

    struct Walk {
        Vector at;  ///< where it ended, on the family
        bool arrived = false;
    };

    /// A walk on the family from q, steps along the tangent space that `direction(at)` points to, until there is no
    /// direction any more (it has arrived), no progress, or the steps run out. The rank of the Jacobian must not
    /// change.
    template <class Direction>
    Walk walk(const Vector& q, int dimension, Direction&& direction, int most_steps) const {
        constexpr double longest = 0.15;
        Walk y{q};
        Vector f, j;
        for (int step = 0; step < most_steps; ++step) {
            const std::optional<Vector> wanted = direction(y.at);
            if (!wanted) {
                y.arrived = true;
                return y;
            }
            system_(y.at, f, j);
            const SingularValues svd(n_, n_, j);
            if (svd.rank(1e-7) > n_ - dimension || svd.rank(1e-3) < n_ - dimension) return y;
            Vector along(index(n_));
            for (int k = n_ - dimension; k < n_; ++k) {
                const Vector t = svd.right(k);
                const auto by = inner(t, *wanted);
                for (int i = 0; i < n_; ++i) along[index(i)] += by * t[index(i)];
            }
            const double length = largest(along);
            if (!(length > 1e-4 * largest(*wanted))) return y;  // as near as this walk comes
            const double by = std::min(1.0, longest / length);
            Vector next = y.at;
            for (int i = 0; i < n_; ++i) next[index(i)] += by * along[index(i)];
            const auto landed = projected(next, n_ - dimension, 0.5 * by * length);
            if (!landed) return y;
            y.at = *landed;
        }
        return y;
    }

    static double largest(const Vector& v) {
        double y = 0;
        for (const auto& x : v) y = std::max(y, std::abs(x) < 1e300 ? std::abs(x) : 1e300);
        return y;
    }
    static double distance(const Vector& a, const Vector& b) {
        Vector d = a;
        for (std::size_t i = 0; i < d.size(); ++i) d[i] -= b[i];
        return largest(d);
    }

private:
    static std::size_t index(int i) { return static_cast<std::size_t>(i); }
    static std::complex<double> inner(const Vector& a, const Vector& b) {
        std::complex<double> sum = 0;
        for (std::size_t i = 0; i < a.size(); ++i) sum += std::conj(a[i]) * b[i];
        return sum;
    }
    /// Whether F(q) = f is 0 to rounding: that of F's scale, or what the last digits of q make of it, where terms far
    /// larger than that scale cancel.
    bool vanishes(const Vector& q, const Vector& f) const {
        const double residual = largest(f);
        if (residual < negligible || !(residual < 1e-6)) return residual < negligible;
        double noise = 0;
        for (const double by : {1 + 0x1p-51, 1 - 0x1p-51, 1 + 0x1p-50}) {
            Vector next = q, there, j;
            for (auto& x : next) x *= by;
            system_(next, there, j);
            noise = std::max(noise, distance(there, f));
        }
        return residual < 8 * noise;
    }
    static std::complex<double> draw(bool real, Generator& generator) {
        const double re = uniform(generator, -1, 1), im = uniform(generator, -1, 1);
        return {re, real ? 0 : im};
    }

    /// Solutions on d random slices at distance, half of it and its double; the one at `distance` goes to y.
    [[gnu::cold]] bool confirmed(const Vector& q, int d, double distance, bool real, Generator& generator,
                                 Finding& y) const {
        // orthonormal rows a_i: random combinations of the null vectors; the complement serves to vary the first guess
        std::vector<Vector> rows;
        for (int r = 0; r < y.nullity; ++r) {
            Vector a(index(n_));
            for (const Vector& t : y.tangent) {
                const auto by = draw(real, generator);
                for (int i = 0; i < n_; ++i) a[index(i)] += by * t[index(i)];
            }
            for (int pass = 0; pass < 2; ++pass)
                for (const Vector& b : rows) {
                    const auto by = inner(b, a);
                    for (int i = 0; i < n_; ++i) a[index(i)] -= by * b[index(i)];
                }
            const double size = std::sqrt(inner(a, a).real());
            for (auto& x : a) x /= size;
            rows.push_back(a);
        }
        Vector unit;
        for (int r = 0; r < y.nullity; ++r) unit.push_back(draw(real, generator));
        double size = 0;
        for (int r = 0; r < d; ++r) size += std::norm(unit[index(r)]);
        for (auto& x : unit) x /= std::sqrt(size);
        for (const double h : {2 * distance, 0.5 * distance, distance}) {
            Slices slices{q, rows, Vector(unit.begin(), unit.begin() + d), h};
            for (auto& x : slices.offsets) x *= h;
            bool solved = false;
            for (int guess = 0; !solved && guess < (d < y.nullity ? 4 : 1); ++guess) {
                Vector at = q;
                for (int r = 0; r < y.nullity; ++r) {
                    if (guess > 0 && r >= d) unit[index(r)] = draw(real, generator);
                    for (int i = 0; i < n_; ++i) at[index(i)] += h * unit[index(r)] * rows[index(r)][index(i)];
                }
                solved = solve_on_slices(at, slices, y.residual);
                if (solved) y.neighbour = at;
            }
            if (!solved) return false;
        }
        // another family may pass near an isolated root: this one must come back to q
        constexpr double nearest = 1e-5;
        Vector at = y.neighbour;
        for (double h = distance / 2; h > nearest; h /= 2) {
            for (int i = 0; i < n_; ++i) at[index(i)] = 0.5 * (at[index(i)] + q[index(i)]);
            Slices slices{q, rows, Vector(unit.begin(), unit.begin() + d), h};
            for (auto& x : slices.offsets) x *= h;
            double residual = 0;
            if (!solve_on_slices(at, slices, residual)) return false;
        }
        if (FamilyProbe::distance(at, q) > 20 * nearest && parted(q, at)) return false;
        y.distance = FamilyProbe::distance(y.neighbour, q);
        y.dimension = d;
        return true;
    }

    /// Whether |F| rises between two points: then they are on two families, or one of them is an isolated root. The way
    /// from a point that is known to few digits to its own family leads down.
    bool parted(const Vector& q, const Vector& other) const {
        Vector f, j;
        system_(q, f, j);
        const double most = 1e3 * std::max(largest(f), negligible);
        for (const double share : {0.5, 0.25, 0.75}) {
            Vector between = q;
            for (int i = 0; i < n_; ++i) between[index(i)] += share * (other[index(i)] - q[index(i)]);
            system_(between, f, j);
            if (largest(f) > most && !vanishes(between, f)) return true;
        }
        return false;
    }

    /// The hyperplanes rows[r] . (q - centre) = offsets[r], as many as there are offsets, some `distance` away.
    struct Slices {
        const Vector& centre;
        const std::vector<Vector>& rows;
        Vector offsets;
        double distance;
    };
    [[gnu::cold]] bool solve_on_slices(Vector& q, const Slices& slices, double& residual) const {
        const auto& [centre, rows, offsets, h] = slices;
        const int d = static_cast<int>(offsets.size());
        Vector f, j;
        for (int round = 0; round < 40; ++round) {
            system_(q, f, j);
            residual = largest(f);
            Vector stacked(index((n_ + d) * n_)), right(f);
            for (int c = 0; c < n_; ++c)
                for (int r = 0; r < n_ + d; ++r)
                    stacked[index(c * (n_ + d) + r)] =
                        r < n_ ? j[index(c * n_ + r)] : std::conj(rows[index(r - n_)][index(c)]);
            Vector shift = q;
            for (int i = 0; i < n_; ++i) shift[index(i)] -= centre[index(i)];
            double off = 0;
            for (int r = 0; r < d; ++r) {
                right.push_back(inner(rows[index(r)], shift) - offsets[index(r)]);
                off = std::max(off, std::abs(right.back()));
            }
            if (off < 1e-9 * h && vanishes(q, f)) return largest(shift) < 4 * h + inaccuracy;
            const SingularValues svd(n_ + d, n_, std::move(stacked));
            const Vector step = svd.solve(right, svd.rank(1e-9));
            const double length = largest(step);
            // no solution, but a minimum of |F|, where steps end
            if (!(length < 1e300) || (length < 1e-10 * h && residual > 1e-9)) return false;
            const double by = std::min(1.0, h / (length + 1e-300));
            for (int i = 0; i < n_; ++i) q[index(i)] -= by * step[index(i)];
        }
        return false;
    }

    int n_;
    System system_;
};

}  // namespace equilibria::detail
