/// \file
/// See fem/structure.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/problem.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/rotation/tangent_map.hpp>

namespace equilibria::fem {

template <bool Conservative>
BasicStructure<Conservative>::BasicStructure(Model model, const StructureOptions& options)
    : model_(std::make_shared<const Model>(std::move(model))), options_(options) {
    number();
    make_pattern();
    set_loads();
    choose_scales();
}

template <bool Conservative>
template <class Add>
void BasicStructure<Conservative>::assemble_group(const GroupAssembly& assembly, const Configuration& q, double p,
                                                  Need need, const Add& add) const {
    const ElementGroup& group = assembly.group();
    assembly.for_each(
        options_.executor,
        [&](std::size_t e, ElementValues& out) {
            group.evaluate(e, q.frames.data(), query(assembly, e, q, p, need), out);
        },
        [&](std::size_t e, const ElementValues& out) { add(assembly, e, out); });
}

template <bool Conservative>
template <class Add>
void BasicStructure<Conservative>::assemble(const Configuration& q, double p, Need need, const Add& add) const {
    for (const GroupAssembly& group : assemblies_)
        if (need != Need::parameter_derivative || changes(group.group())) assemble_group(group, q, p, need, add);
}

template <bool Conservative>
StructureState BasicStructure<Conservative>::initial() const {
    Configuration y;
    y.frames.resize(static_cast<std::size_t>(model_->nodes()));
    for (int k = 0; k < model_->nodes(); ++k) y.frames[static_cast<std::size_t>(k)].x = model_->at(k);
    y.multipliers = Eigen::VectorXd::Zero(multipliers_);
    return y;
}

template <bool Conservative>
Eigen::VectorXd BasicStructure<Conservative>::residual(const Configuration& q, double p) const {
    Eigen::VectorXd g = -factor(LoadKind::constant, p) * constant_load_;
    g -= factor(LoadKind::proportional, p) * proportional_load_;
    assemble(q, p, Need::residual, [&](const GroupAssembly& group, std::size_t e, const ElementValues& out) {
        group.add(e, out.residual, g);
    });
    for (const NodalLoad& m : moments_) {
        const Eigen::Vector3d moment = factor(m.kind, p) * (q.frames[node_of(m)].q.conjugate() * m.moment);
        for (int c = 0; c < 3; ++c)
            if (const int i = unknown(m.node, Component(rx + c)); i >= 0) g(i) -= moment(c);
    }
    return g;
}

template <bool Conservative>
Eigen::SparseMatrix<double> BasicStructure<Conservative>::tangent(const Configuration& q, double p) const {
    Eigen::SparseMatrix<double> k = pattern_;
    assemble(q, p, Need::tangent, [&](const GroupAssembly& group, std::size_t e, const ElementValues& out) {
        group.add(e, out.tangent, k);
    });
    // -(R exp(d))^T m = -M - M x d with M = R^T m, and the chart's d x (-M) / 2: none where a node turns about one
    // axis
    for (const NodalLoad& m : moments_) {
        const Eigen::Vector3d moment = factor(m.kind, p) * (q.frames[node_of(m)].q.conjugate() * m.moment);
        const Eigen::Matrix3d s = skew(moment);
        for (int r = 0; r < 3; ++r)
            for (int c = 0; c < 3; ++c) {
                const int i = unknown(m.node, Component(rx + r)), j = unknown(m.node, Component(rx + c));
                if (i >= 0 && j >= 0 && i != j) k.coeffRef(i, j) -= 0.5 * s(r, c);
            }
    }
    return k;
}

template <bool Conservative>
Eigen::VectorXd BasicStructure<Conservative>::parameter_derivative(const Configuration& q, double p) const {
    Eigen::VectorXd g_p = options_.first_stage ? -constant_load_ : -proportional_load_;
    assemble(q, p, Need::parameter_derivative,
             [&](const GroupAssembly& group, std::size_t e, const ElementValues& out) {
                 group.add(e, out.parameter_derivative, g_p);
             });
    for (const NodalLoad& m : moments_) {
        if (!grows(m.kind)) continue;
        const Eigen::Vector3d moment = q.frames[node_of(m)].q.conjugate() * m.moment;
        for (int c = 0; c < 3; ++c)
            if (const int i = unknown(m.node, Component(rx + c)); i >= 0) g_p(i) -= moment(c);
    }
    return g_p;
}

template <bool Conservative>
Eigen::VectorXd BasicStructure<Conservative>::parameter_derivative_along(const Configuration& q, double p,
                                                                         const Eigen::VectorXd& v) const {
    const bool depends =
        std::ranges::any_of(assemblies_, [this](const GroupAssembly& group) { return changes(group.group()); }) ||
        std::ranges::any_of(moments_, [this](const NodalLoad& m) { return grows(m.kind); });
    return depends ? parameter_difference_along(*this, q, p, v) : Eigen::VectorXd::Zero(size_);
}

template <bool Conservative>
std::vector<NodalForce> BasicStructure<Conservative>::support_forces(const Configuration& q, double p) const {
    std::vector<NodalForce> y(static_cast<std::size_t>(model_->nodes()));
    const auto rotating = [&](int node) { return static_cast<std::size_t>(model_->rotates_with(node)); };
    assemble(q, p, Need::residual, [&](const GroupAssembly& assembly, std::size_t e, const ElementValues& out) {
        const ElementGroup& group = assembly.group();
        Eigen::Index next = 0;
        for (int k = 0; k < group.n_nodes(); ++k)
            for (int c = 0; c < group.n_components(); ++c) {
                const int node = group.nodes(e)[k];
                const Component component = group.components()[c];
                if (component < rx)
                    y[static_cast<std::size_t>(node)].force(component) += out.residual(next++);
                else
                    y[rotating(node)].moment(component - rx) += out.residual(next++);
            }
    });
    // elements' moments are in the axes of the nodes
    for (std::size_t k = 0; k < y.size(); ++k) y[k].moment = q.frames[k].q * y[k].moment;
    for (const NodalLoad& load : model_->loads()) {
        y[node_of(load)].force -= factor(load.kind, p) * load.force;
        y[rotating(load.node)].moment -= factor(load.kind, p) * load.moment;
    }
    return y;
}

template <bool Conservative>
StructureState BasicStructure<Conservative>::retract(const Configuration& q, const Eigen::VectorXd& increment) const {
    Configuration y = q;
    for (int k = 0; k < model_->nodes(); ++k) {
        auto& frame = y.frames[static_cast<std::size_t>(k)];
        frame = fem::retract(frame, part(increment, k, ux), part(increment, k, rx));
    }
    y.multipliers += increment.tail(multipliers_);
    return y;
}

template <bool Conservative>
Eigen::VectorXd BasicStructure<Conservative>::transport(const Configuration&, const Eigen::VectorXd& increment,
                                                        const Eigen::VectorXd& v) const {
    Eigen::VectorXd y = v;
    for (int k = 0; k < model_->nodes(); ++k) {
        if (model_->rotates_with(k) != k) continue;
        const Eigen::Vector3d psi = part(increment, k, rx);
        if (psi.isZero(0)) continue;
        const Eigen::Vector3d turned = tangent_map(psi).value() * part(v, k, rx);
        set_part(y, k, rx, turned);
    }
    return y;
}

template <bool Conservative>
Eigen::VectorXd BasicStructure<Conservative>::difference(const Configuration& q, const Configuration& near) const {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(size_);
    for (int k = 0; k < model_->nodes(); ++k) {
        const auto &a = q.frames[static_cast<std::size_t>(k)], &b = near.frames[static_cast<std::size_t>(k)];
        set_part(y, k, ux, b.x - a.x);
        set_part(y, k, rx, shortest_rotation_vector(Eigen::Quaterniond(a.q.conjugate() * b.q)));
    }
    y.tail(multipliers_) = near.multipliers - q.multipliers;
    return y;
}

template <bool Conservative>
Eigen::Vector3d BasicStructure<Conservative>::part(const Eigen::VectorXd& v, int node, Component first) const {
    Eigen::Vector3d y = Eigen::Vector3d::Zero();
    for (int c = 0; c < 3; ++c)
        if (const int i = unknown(node, Component(first + c)); i >= 0) y(c) = v(i);
    return y;
}

template <bool Conservative>
void BasicStructure<Conservative>::set_part(Eigen::VectorXd& v, int node, Component first,
                                            const Eigen::Vector3d& value) const {
    for (int c = 0; c < 3; ++c)
        if (const int i = unknown(node, Component(first + c)); i >= 0) v(i) = value(c);
}

template <bool Conservative>
void BasicStructure<Conservative>::number() {
    const std::size_t nodes = static_cast<std::size_t>(model_->nodes());
    for (const auto& group : model_->groups())
        require(!Conservative || group->conservative(), "model", "an element without energy",
                "must be given to NonconservativeStructure");
    used_ = model_->used();
    const auto held = model_->held();
    unknowns_.assign(nodes, {-1, -1, -1, -1, -1, -1});
    for (int k = 0; k < model_->nodes(); ++k)
        for (const Component c : spatial)
            if (used_[static_cast<std::size_t>(k)][c] && !held[static_cast<std::size_t>(k)][c])
                unknowns_[static_cast<std::size_t>(k)][c] = size_++;
    // right increments without one of their components do not add up to a rotation: such a hold has no energy
    for (int k = 0; k < model_->nodes(); ++k)
        require((unknown(k, rx) >= 0) + (unknown(k, ry) >= 0) + (unknown(k, rz) >= 0) != 2,
                "rotation of node " + std::to_string(k), "free about two axes",
                "must be free, free about one axis or fixed; two revolute joints leave two axes");
    for (int k = 0; k < model_->nodes(); ++k)
        for (const Component c : {rx, ry, rz})
            unknowns_[static_cast<std::size_t>(k)][c] = unknowns_[static_cast<std::size_t>(model_->rotates_with(k))][c];
    require(size_ > 0, "model", std::to_string(nodes) + " nodes", "must have a component that can move");
    for (const auto& group : model_->groups()) {
        std::vector<int> places;
        for (std::size_t e = 0; e < group->size(); ++e) {
            for (int k = 0; k < group->n_nodes(); ++k)
                for (int c = 0; c < group->n_components(); ++c)
                    places.push_back(unknown(group->nodes(e)[k], group->components()[c]));
            for (int m = 0; m < group->multipliers(); ++m) places.push_back(size_ + multipliers_++);
        }
        assemblies_.emplace_back(*group, std::move(places));
    }
    size_ += multipliers_;
}

template <bool Conservative>
void BasicStructure<Conservative>::make_pattern() {
    std::vector<Eigen::Triplet<double>> entries;
    for (int i = 0; i < size_; ++i) entries.emplace_back(i, i, 0.0);
    for (const GroupAssembly& group : assemblies_) group.add_pattern(entries);
    for (const NodalLoad& load : model_->loads())
        if (!load.moment.isZero(0))
            for (const Component r : {rx, ry, rz})
                for (const Component c : {rx, ry, rz})
                    if (unknown(load.node, r) >= 0 && unknown(load.node, c) >= 0)
                        entries.emplace_back(unknown(load.node, r), unknown(load.node, c), 0.0);
    pattern_.resize(size_, size_);
    pattern_.setFromTriplets(entries.begin(), entries.end());
    pattern_.makeCompressed();
    for (GroupAssembly& group : assemblies_) group.find_places(pattern_);
}

template <bool Conservative>
void BasicStructure<Conservative>::set_loads() {
    proportional_load_ = constant_load_ = Eigen::VectorXd::Zero(size_);
    for (const NodalLoad& load : model_->loads()) {
        const std::string where = "load on node " + std::to_string(load.node);
        int axes = 0;
        for (int c = 0; c < 3; ++c) {
            const std::size_t node = static_cast<std::size_t>(load.node),
                              root = static_cast<std::size_t>(model_->rotates_with(load.node));
            require(load.force(c) == 0 || used_[node][ux + c] || model_->fixed(load.node, Component(c)), where,
                    streamed(load.force.transpose()), "must act on components that an element uses");
            require(load.moment(c) == 0 || used_[root][rx + c] || unknown(load.node, Component(rx + c)) >= 0 ||
                        model_->fixed(load.node, Component(rx + c)),
                    where, streamed(load.moment.transpose()), "must act on rotations that an element uses");
            axes += unknown(load.node, Component(rx + c)) >= 0;
        }
        require(!Conservative || axes <= 1 || load.moment.isZero(0), where, streamed(load.moment.transpose()),
                "a moment on a node that turns about several axes has no energy: NonconservativeStructure takes it");
        Eigen::VectorXd& to = load.kind == LoadKind::constant ? constant_load_ : proportional_load_;
        for (int c = 0; c < 3; ++c)
            if (const int i = unknown(load.node, Component(ux + c)); i >= 0) to(i) += load.force(c);
        if (!load.moment.isZero(0)) moments_.push_back(load);
    }
}

template <bool Conservative>
void BasicStructure<Conservative>::choose_scales() {
    if (options_.length == 0) {
        Eigen::Vector3d low = model_->at(0), high = low;
        for (int k = 1; k < model_->nodes(); ++k) {
            low = low.cwiseMin(model_->at(k));
            high = high.cwiseMax(model_->at(k));
        }
        options_.length = (high - low).norm() > 0 ? (high - low).norm() : 1.0;
    }
    require(options_.length > 0 && std::isfinite(options_.length), "length", options_.length,
            "must be 0 (chosen) or positive and finite");
    // multipliers next to none: then the weakest directions are motions, as of the energy under the constraints
    weights_ = Eigen::VectorXd::Constant(size_, 1e-8 / model_->nodes());
    weights_.head(size_ - multipliers_) *= 1e8;
    for (int k = 0; k < model_->nodes(); ++k)
        for (const Component c : positions)
            if (const int i = unknown(k, c); i >= 0) weights_(i) /= options_.length * options_.length;
    double stiffest = 0;
    if (multipliers_ > 0 && (options_.scale.multiplier == 0 || options_.scale.penalty == 0)) {
        // with scales of 0 constraints have no stiffness
        const Eigen::SparseMatrix<double> k = tangent(initial(), 0);
        for (int i = 0; i < size_; ++i) stiffest = std::max(stiffest, std::abs(k.coeff(i, i)));
    }
    if (!(stiffest > 0)) stiffest = 1;
    for (double* scale : {&options_.scale.multiplier, &options_.scale.penalty}) {
        if (*scale == 0) *scale = stiffest;
        require(*scale > 0 && std::isfinite(*scale), "scale", *scale, "must be 0 (chosen) or positive and finite");
    }
}

}  // namespace equilibria::fem
