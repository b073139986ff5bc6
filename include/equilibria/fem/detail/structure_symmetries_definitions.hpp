/// \file
/// See fem/structure.hpp.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include <Eigen/QR>

#include <equilibria/core/random.hpp>
#include <equilibria/fem/structure.hpp>

namespace equilibria::fem {

template <bool Conservative>
const std::vector<Symmetry>& BasicStructure<Conservative>::symmetries() const {
    equilibria::detail::call_once(symmetries_->once, [this] {
        std::vector<Eigen::Vector3d> places;
        for (int k = 0; k < model_->nodes(); ++k) places.push_back(model_->at(k));
        for (Symmetry& s : symmetries_of(places))
            if (complete(s)) symmetries_->found.push_back(std::move(s));
    });
    return symmetries_->found;
}

template <bool Conservative>
StructureState BasicStructure<Conservative>::image(const Symmetry& symmetry, const Configuration& q) const {
    Configuration y = q;
    const Eigen::Quaterniond turn(symmetry.axial());
    for (std::size_t k = 0; k < q.frames.size(); ++k) {
        auto& frame = y.frames[static_cast<std::size_t>(symmetry.node[k])];
        frame.x = symmetry.center + symmetry.turn * (q.frames[k].x - symmetry.center);
        frame.q = turn * q.frames[k].q * turn.conjugate();
    }
    if (multipliers_ > 0) y.multipliers = symmetry.multipliers * q.multipliers;
    return y;
}

template <bool Conservative>
std::vector<StructureState> BasicStructure<Conservative>::images(const Configuration& q) const {
    std::vector<Configuration> y;
    if (options_.symmetric_images)
        for (const Symmetry& s : symmetries()) y.push_back(image(s, q));
    return y;
}

template <bool Conservative>
StructureState BasicStructure<Conservative>::generic_state(int number) const {
    Generator generator(static_cast<std::uint64_t>(number) + 1);
    Eigen::VectorXd increment = Eigen::VectorXd::Zero(size_);
    for (int i = 0; i < size_ - multipliers_; ++i) increment(i) = uniform(generator, -1, 1);
    for (int k = 0; k < model_->nodes(); ++k)
        for (const Component c : positions)
            if (const int i = unknown(k, c); i >= 0) increment(i) *= 0.01 * options_.length;
    for (int k = 0; k < model_->nodes(); ++k)
        if (model_->rotates_with(k) == k) set_part(increment, k, rx, 0.3 * part(increment, k, rx));
    return retract(initial(), increment);
}

template <bool Conservative>
Eigen::VectorXd BasicStructure<Conservative>::image_of_residual(const Symmetry& symmetry,
                                                                const Eigen::VectorXd& g) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(size_);
    const Eigen::Matrix3d axial = symmetry.axial();
    for (int k = 0; k < model_->nodes(); ++k) {
        const int to = symmetry.node[static_cast<std::size_t>(k)];
        set_part(y, to, ux, symmetry.turn * part(g, k, ux));
        if (model_->rotates_with(k) == k) set_part(y, to, rx, axial * part(g, k, rx));
    }
    if (multipliers_ > 0) y.tail(multipliers_) = symmetry.multipliers * g.tail(multipliers_);
    return y;
}

template <bool Conservative>
bool BasicStructure<Conservative>::complete(Symmetry& symmetry) const {
    for (int k = 0; k < model_->nodes(); ++k)
        if (symmetry.node[static_cast<std::size_t>(model_->rotates_with(k))] !=
            model_->rotates_with(symmetry.node[static_cast<std::size_t>(k)]))
            return false;
    // what one element's constraints are in generic states, its image's are by a linear map
    int most = 0;
    for (const auto& group : model_->groups()) most = std::max(most, group->multipliers());
    symmetry.multipliers.resize(multipliers_, multipliers_);
    std::vector<Eigen::VectorXd> here, there;
    if (multipliers_ > 0)
        for (int k = 0; k < most + 2; ++k) {
            const Configuration q = generic_state(k);
            here.push_back(residual(q, 0.7).tail(multipliers_));
            there.push_back(residual(image(symmetry, q), 0.7).tail(multipliers_));
        }
    std::vector<Eigen::Triplet<double>> entries;
    for (const GroupAssembly& assembly : assemblies_) {
        const ElementGroup& group = assembly.group();
        const int m = group.multipliers(), own = group.unknowns() - m;
        if (m == 0) continue;
        const auto nodes_of = [&](std::size_t e, bool moved) {
            std::vector<int> y(group.nodes(e), group.nodes(e) + group.n_nodes());
            if (moved)
                for (int& node : y) node = symmetry.node[static_cast<std::size_t>(node)];
            std::sort(y.begin(), y.end());
            return y;
        };
        std::multimap<std::vector<int>, std::size_t> elements;
        for (std::size_t e = 0; e < group.size(); ++e) elements.emplace(nodes_of(e, false), e);
        for (std::size_t e = 0; e < group.size(); ++e) {
            const auto found = elements.find(nodes_of(e, true));
            if (found == elements.end()) return false;
            const auto row = [&](std::size_t element, int c) {
                return assembly.unknowns(element)[own + c] - (size_ - multipliers_);
            };
            Eigen::MatrixXd from(here.size(), m), to(here.size(), m);
            for (std::size_t k = 0; k < here.size(); ++k)
                for (int c = 0; c < m; ++c) {
                    from(static_cast<Eigen::Index>(k), c) = here[k](row(e, c));
                    to(static_cast<Eigen::Index>(k), c) = there[k](row(found->second, c));
                }
            const Eigen::MatrixXd map = from.completeOrthogonalDecomposition().solve(to);
            for (int r = 0; r < m; ++r)
                for (int c = 0; c < m; ++c)
                    if (std::abs(map(c, r)) > 1e-6) {
                        // they are signs and permutations but for rounding, where they are any
                        const double entry =
                            std::abs(std::abs(map(c, r)) - 1) < 1e-6 ? (map(c, r) < 0 ? -1.0 : 1.0) : map(c, r);
                        entries.emplace_back(row(found->second, r), row(e, c), entry);
                    }
            elements.erase(found);
        }
    }
    symmetry.multipliers.setFromTriplets(entries.begin(), entries.end());
    Generator generator(7);
    for (int k = 0; k < 2; ++k) {
        Configuration q = generic_state(100 + k);
        for (int i = 0; i < multipliers_; ++i) q.multipliers(i) = uniform(generator, -1, 1);
        const Configuration moved = image(symmetry, q);
        // supports hold what they hold elsewhere
        const Configuration again = retract(initial(), difference(initial(), moved));
        for (std::size_t node = 0; node < moved.frames.size(); ++node) {
            const auto &a = moved.frames[node], &b = again.frames[node];
            if ((a.x - b.x).norm() > 1e-10 * options_.length || a.q.angularDistance(b.q) > 1e-7) return false;
        }
        const double p = k == 0 ? 0.7 : -1.3;
        const Eigen::VectorXd g = residual(moved, p), expected = image_of_residual(symmetry, residual(q, p));
        if (!((g - expected).lpNorm<Eigen::Infinity>() <= 1e-10 * g.lpNorm<Eigen::Infinity>())) return false;
        const Eigen::VectorXd load = parameter_derivative(moved, p),
                              expected_load = image_of_residual(symmetry, parameter_derivative(q, p));
        if (!((load - expected_load).lpNorm<Eigen::Infinity>() <= 1e-10 * load.lpNorm<Eigen::Infinity>())) return false;
    }
    return true;
}

}  // namespace equilibria::fem
