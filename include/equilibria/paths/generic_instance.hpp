/// \file
/// A system with generic coefficients on given supports, solved by a polyhedral homotopy, and every system within these
/// supports from its roots: as many paths as the mixed volume, once for all of them.
///
/// Source: Huber, Sturmfels, A polyhedral method for solving sparse polynomial systems, Math. Comp. 64 (1995)
/// (polyhedral homotopies); Morgan, Sommese, Coefficient-parameter polynomial continuation, Appl. Math. Comput. 29
/// (1989) (from a generic member of a family to all others).
#pragma once

#include <algorithm>
#include <complex>
#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/homotopy/laurent_column.hpp>
#include <equilibria/homotopy/polynomial_homotopy.hpp>
#include <equilibria/paths/complex_roots.hpp>
#include <equilibria/polyhedral/supports.hpp>
#include <equilibria/start/path_numbering.hpp>
#include <equilibria/system/laurent_terms.hpp>

namespace equilibria {

/// The solved system, from whose roots others are solved.
class GenericInstance {
public:
    /// Complex angles in radians, then coordinates.
    using Unknowns = UnknownArray<RuntimeUnknowns, std::complex<double>>;

    /// Solves a system with the exponents of `typical` (affine_supports) and coefficients of about its size, whose
    /// phases are turned at random, by less than a right angle and a half: on the way to systems like it no coefficient
    /// comes near 0. A cancelled run leaves paths out. Throws InvalidArgument where the run names a checkpoint or
    /// options are out of range.
    explicit GenericInstance(const SparseSystem& typical, const RunOptions& run = {},
                             const TrackerOptions& options = {});

    bool cancelled() const { return cancelled_; }  ///< the run was, before all its paths were tracked
    /// Number of paths that were tracked to the generic system; 0 where the run was cancelled among its cells.
    std::uint64_t mixed_volume() const { return mixed_volume_; }
    const RuntimeSizes& sizes() const { return sizes_; }  ///< numbers of angles and coordinates
    /// Angles in complex radians, then coordinates, none of which is 0. Less than the mixed volume only where paths
    /// failed, which every result then counts.
    const std::vector<Unknowns>& roots() const { return roots_; }
    std::uint64_t failed() const { return mixed_volume_ - roots_.size(); }  ///< paths that reached no regular root
    /// Counts the paths that reached no regular root: as failed, or as cancelled where the run was. A run that was
    /// cancelled before its paths were numbered counts as one such path.
    void add_unsolved_to(PathCounts& counts) const {
        const std::uint64_t unsolved = cancelled_ ? std::max<std::uint64_t>(failed(), 1) : failed();
        counts.total += unsolved;
        (cancelled_ ? counts.cancelled : counts.failed) += unsolved;
    }
    /// Its paths: how many cells they began in, what was tracked again, and the effort.
    struct Effort {
        std::uint64_t cells = 0;      ///< mixed cells
        std::uint64_t retracked = 0;  ///< see PathCounts
        std::uint64_t crossed = 0;    ///< see PathCounts
        std::uint64_t in_double = 0;  ///< see PathCounts
        std::uint64_t steps = 0;      ///< see PathCounts
        double weight_ratio = 0;      ///< of largest to smallest weight of a term, of 90 % of the paths
        double cells_seconds = 0;     ///< of the search for mixed cells
        double tracking_seconds = 0;  ///< of the paths
    };
    const Effort& effort() const { return effort_; }  ///< of solving the generic system

    /// The way to a system whose exponents are among those of the typical one, from the generic roots. own: what is
    /// polished, where the system has equations of its own beside its polynomials. Throws InvalidArgument where it has
    /// other unknowns or exponents.
    PolynomialHomotopy homotopy(const SparseSystem& target, std::shared_ptr<const OwnEquations> own = nullptr) const;
    /// The terms of that way, in the order of the supports. Throws as `homotopy`.
    std::vector<LaurentColumn> columns(const SparseSystem& target) const;
    /// Where its paths begin.
    class Start {
    public:
        explicit Start(const GenericInstance& instance) : instance_(&instance) {}  ///< the instance has to outlive it
        static constexpr std::string_view name() { return "polyhedral"; }          ///< what results call it
        /// One path a generic root.
        PathNumbering numbering() const { return PathNumbering::all(instance_->roots_.size()); }
        /// Where path k begins.
        RuntimePoint<double> point(std::uint64_t k) const {
            return point_of<RuntimeUnknowns>(instance_->roots_[k], instance_->sizes_);
        }

    private:
        const GenericInstance* instance_;
    };
    /// All its isolated solutions.
    ComplexRoots<> solve(const SparseSystem& target, const RunOptions& run = {}, const TrackerOptions& options = {},
                         MoreDigits<> resort = nullptr) const;

private:
    RuntimeSizes sizes_;
    std::uint64_t mixed_volume_ = 0;
    bool cancelled_ = false;
    Supports supports_;
    std::vector<std::complex<double>> coefficients_;  // a column of the supports each
    std::vector<Unknowns> roots_;
    Effort effort_;
};

/// Every isolated solution of the system, by as many paths as the mixed volume of its supports (affine_supports).
ComplexRoots<> solve_polyhedral(const SparseSystem& system, const RunOptions& run = {},
                                const TrackerOptions& options = {}, MoreDigits<> resort = nullptr);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/paths/detail/generic_instance_definitions.hpp>
#endif
