/// \file
/// The curves of cusps in a box of three parameters x, y, z of a model:
///
///     const auto locus = find_cusp_locus<Chain, Chain::alpha, Chain::omega, Chain::ratio>(p, {{0, 1}, {0, 20}, {1,
///     3}}); std::cout << locus.curves.size() << " curves; " << locus.argument() << '\n';
///
/// Completeness. All cusps of planes z = const are solved for, as the complex solutions of a polynomial system
/// (plane_solver.hpp): the two ends of the range and planes between them, off round values. Every cusp is a seed that
/// some curve must pass, up to the mirror image theta -> -theta; and where a curve crosses a plane there must be one of
/// its cusps. So a curve is missed only if it crosses no plane: if it is closed, or runs from face to face of the box,
/// between two neighbouring planes.
/// Where it fails: next to parameters at which the model is degenerate solutions come together, and paths remain
/// undecided. A plane that leaves such paths, or has fewer regular solutions than another, is given up for one a small
/// part of the range away; a part of the box next to its face is then beyond the planes, which is said. Solutions that
/// a plane still lacks are counted, and speak against completeness.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/locus/line/searched_model.hpp>
#include <equilibria/locus/plane/plane_solver.hpp>
#include <equilibria/locus/space/cusp_curve.hpp>
#include <equilibria/locus/space/cusp_locus_result.hpp>
#include <equilibria/model/active_parameters.hpp>
#include <equilibria/model/torus.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/system/critical_system.hpp>
#include <equilibria/system/model_polynomials.hpp>

namespace equilibria {

/// How a box is searched for curves of cusps.
struct CuspLocusOptions {
    int planes = 9;            ///< that are solved, the two at the ends of the range included
    CuspCurveOptions curve{};  ///< of each curve

    /// Throws InvalidArgument for an option out of range.
    void validate() const {
        require(planes >= 2 && planes <= 10000, "planes", planes, "must be 2 to 10000");
        curve.validate();
    }
};

namespace detail {

template <PotentialModel M, int X, int Y, int Z>
class CuspLocusFinder {
public:
    static constexpr int n = n_unknowns<M>;

    CuspLocusFinder(const Parameters<M>& p, const Box& box, const RunOptions& run, const CuspLocusOptions& options,
                    MoreDigits<> resort)
        : run_(run), options_(options) {
        model_.more_digits = resort;
        model_.systems_in_double = 0;  // few paths, and next to a degenerate plane badly conditioned ones
        locus_.box = box;
        locus_.parameters = p;
    }

    CuspLocus<M> run() {
        const detail::Stopwatch begin;
        solve_planes();
        std::vector<std::vector<bool>> traced;
        for (const auto& plane : locus_.planes) traced.emplace_back(plane.cusps.size());
        for (std::size_t k = 0; k < locus_.planes.size(); ++k)
            for (std::size_t c = 0; c < locus_.planes[k].cusps.size(); ++c)
                if (!traced[k][c]) trace_from(locus_.planes[k], locus_.planes[k].cusps[c], traced);
        auto& e = locus_.evidence;
        for (const auto& plane : traced)
            e.untraced_cusps += static_cast<std::uint64_t>(std::ranges::count(plane, false));
        for (const auto& curve : locus_.curves) {
            e.broken_curves += std::ranges::any_of(
                curve.ends, [](auto end) { return end == CurveEnd::step || end == CurveEnd::length; });
            for (const auto& t : curve.transitions)
                e.unconfirmed_transitions += t.at.kind == SingularityKind::undecided;
        }
        e.seconds = begin.seconds();
        return std::move(locus_);
    }

private:
    double range() const { return locus_.box.z.high - locus_.box.z.low; }

    /// All planes where they are wanted; then those that lack solutions a little way off, and once more.
    void solve_planes() {
        const Box& box = locus_.box;
        Generator generator(run_.seed);
        const std::size_t last = static_cast<std::size_t>(options_.planes) - 1;
        const double spacing = range() / static_cast<double>(last);
        std::vector<std::array<double, 3>> at;
        auto& planes = locus_.planes;
        for (std::size_t k = 0; k <= last; ++k) {
            double z = k == 0 ? box.z.low : box.z.high, step = k == 0 ? range() / 256 : -range() / 256;
            if (k > 0 && k < last) {
                z = box.z.low + spacing * (static_cast<double>(k) + uniform(generator, -0.1, 0.1));
                step = 0.05 * spacing;
            }
            at.push_back({z, z + step, k > 0 && k < last ? z - step : z + 16 * step});
            planes.push_back(solved_at(z));
        }
        for (std::size_t attempt = 1; attempt < 3; ++attempt) {
            const std::uint64_t most = most_solutions();
            for (std::size_t k = 0; k <= last; ++k) {
                const std::uint64_t failed = planes[k].counts.paths.failed, solutions = planes[k].counts.solutions;
                if (failed == 0 && solutions == most) continue;
                auto given_up = std::move(planes[k].given_up);
                given_up.push_back({planes[k].z, failed, solutions});
                planes[k] = solved_at(at[k][attempt]);
                planes[k].given_up = std::move(given_up);
            }
        }
        locus_.evidence.beyond = {(planes.front().z - box.z.low) / range(), (box.z.high - planes.back().z) / range()};
        for (const auto& plane : planes) {
            locus_.evidence.solved.add(plane.counts);
            locus_.evidence.cusps += plane.cusps.size();
            locus_.evidence.missing_solutions += most_solutions() - plane.counts.solutions;
        }
    }

    std::uint64_t most_solutions() const {
        std::uint64_t most = 0;
        for (const auto& plane : locus_.planes) most = std::max(most, plane.counts.solutions);
        return most;
    }

    CuspPlane<M> solved_at(double z) {
        CuspPlane<M> plane;
        plane.z = z;
        const PlaneSolver solver(model_, plane_system_, runtime_array(with_active<Z>(locus_.parameters, z)), run_,
                                 {1, 1}, {locus_.box.x.low < 0, locus_.box.y.low < 0});
        std::vector<Singularity<M>> taken;
        for (const auto& found : solver.cusps(plane.counts)) {
            const auto at = typed<M>(found);
            if (std::ranges::any_of(taken, [&](const auto& other) { return same(other, at, 1e-7); })) continue;
            taken.push_back(at);
            if (!within(at))
                ++plane.outside;
            else if (at_face(at) && !is_cusp(at))
                ++plane.degenerate;
            else
                plane.cusps.push_back(at);
        }
        return plane;
    }

    static bool is_cusp(const Singularity<M>& at) {
        return refine_singularity<M, SingularityKind::cusp, X, Y>(at.q, at.p, at.v).kind == SingularityKind::cusp;
    }
    /// Parts of the box, beyond which x or y is off the range; below 0 inside.
    double beyond(const Singularity<M>& at) const {
        const Box& b = locus_.box;
        return std::max(std::max(b.x.low - at.x(), at.x() - b.x.high) / (b.x.high - b.x.low),
                        std::max(b.y.low - at.y(), at.y() - b.y.high) / (b.y.high - b.y.low));
    }
    bool within(const Singularity<M>& at) const { return beyond(at) < 1e-9; }
    bool at_face(const Singularity<M>& at) const { return std::abs(beyond(at)) < 1e-12; }

    /// The same cusp, or its mirror image.
    bool same(const Singularity<M>& a, const Singularity<M>& b, double tolerance) const {
        const Box& box = locus_.box;
        if (!(std::abs(a.x() - b.x()) <= tolerance * (box.x.high - box.x.low))) return false;
        if (!(std::abs(a.y() - b.y()) <= tolerance * (box.y.high - box.y.low))) return false;
        return same_unknowns<M>(a.q, b.q, tolerance) ||
               (Formulation<M>::reflection_symmetric && same_unknowns<M>(a.q, mirrored<M>(b.q), tolerance));
    }

    void trace_from(const CuspPlane<M>& plane, const Singularity<M>& cusp, std::vector<std::vector<bool>>& traced) {
        auto curve = trace_cusp_curve<M, X, Y, Z>(with_active<Z>(cusp.p, plane.z), cusp.q, locus_.box, options_.curve);
        if (curve.points.empty()) return;
        for (std::size_t k = 0; k < locus_.planes.size(); ++k) {
            const auto& other = locus_.planes[k];
            for (const auto& crossing : crossings(curve, other.z)) {
                ++locus_.evidence.crossings;
                bool found = false;
                for (std::size_t c = 0; c < other.cusps.size(); ++c)
                    if (same(other.cusps[c], crossing, 1e-6)) traced[k][c] = found = true;
                locus_.evidence.unsolved_crossings += !found;
            }
        }
        locus_.curves.push_back(std::move(curve));
    }

    /// Where the curve crosses the plane. Between its points are its transitions, at which it may turn back.
    std::vector<Singularity<M>> crossings(const CuspCurve<M>& curve, double z) const {
        std::vector<Singularity<M>> nodes;
        for (std::size_t i = 0; i < curve.points.size(); ++i) {
            nodes.push_back(curve.points[i]);
            for (const auto& t : curve.transitions)
                if (t.step == i) nodes.push_back(t.at);
        }
        std::vector<Singularity<M>> found;
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            const Singularity<M>&a = nodes[i], &b = nodes[i + 1];
            if (!((a.z() - z) * (b.z() - z) <= 0)) continue;
            const auto at = crossing(a, b, a.z() == b.z() ? 0 : (z - a.z()) / (b.z() - a.z()), z);
            if (std::ranges::none_of(found, [&](const auto& other) { return same(other, at, 1e-7); }))
                found.push_back(at);
        }
        return found;
    }

    /// The cusp of the plane a part of the way from a to b; where Newton's method fails, the point of the chord.
    Singularity<M> crossing(const Singularity<M>& a, const Singularity<M>& b, double part, double z) const {
        const auto between = [&](double u, double v) { return u + part * (v - u); };
        Singularity<M> at = a;
        at.p = with_active<X, Y, Z>(locus_.parameters, between(a.x(), b.x()), between(a.y(), b.y()), z);
        const auto d = displacement<M>(a.q, b.q);
        for (int i = 0; i < n; ++i) at.q[i] = a.q[i] + part * d[i];
        const auto refined = refine_singularity<M, SingularityKind::cusp, X, Y>(at.q, at.p, at.v);
        return refined.settled() && same(refined, at, 1e-2) ? refined : at;
    }

    static constexpr int active_[] = {X, Y};
    SearchedModel model_ = searched_model<M>();
    CriticalSystem plane_system_{polynomials_of<M>(), active_};
    RunOptions run_;
    CuspLocusOptions options_;
    CuspLocus<M> locus_;
};

}  // namespace detail

/// The curves of cusps of the model within the box of its parameters number X, Y and Z, the others being those of p.
/// resort: more_digits (enumerate/more_digits.hpp) ends paths that fail in double with more digits.
///
/// Throws InvalidArgument for a box that is empty or not finite, for parameters that are not finite and for options out
/// of range, and for a run with a checkpoint or a cancel.
template <PotentialModel M, int X, int Y, int Z>
CuspLocus<M> find_cusp_locus(const Parameters<M>& p, const Box& box, const RunOptions& run = {},
                             const CuspLocusOptions& options = {}, MoreDigits<> resort = nullptr) {
    detail::check_active<M, X, Y, Z>();
    require_finite(p, "p");
    box.validate();
    options.validate();
    run.require_alone("a search for cusps");
    return detail::CuspLocusFinder<M, X, Y, Z>(p, box, run, options, resort).run();
}

}  // namespace equilibria
