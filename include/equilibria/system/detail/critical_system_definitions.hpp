/// \file
/// See system/critical_system.hpp.
#pragma once

#include <algorithm>
#include <numeric>

#include <equilibria/core/error.hpp>
#include <equilibria/system/critical_system.hpp>

namespace equilibria {

EQUILIBRIA_INLINE CriticalSystem::CriticalSystem(const ModelPolynomials& model, std::span<const int> active)
    : model_(&model), active_(active.begin(), active.end()), unknowns_(model.sizes().unknowns) {
    require(actives() == 1 || actives() == 2, "active parameters", actives(), "must be one or two");
    for (const int k : active_)
        require(k >= 0 && k < model.generic_parameters().size(), "active parameter", k,
                "must be the number of a parameter of the model");
    require(actives() == 1 || active_[0] != active_[1], "active parameters", active_[0], "must be different ones");
    sizes_ = RuntimeSizes(model.sizes().angles, reciprocal() + off_symmetric_branches());
    grouping_.assign(at(sizes_.unknowns), 0);
    for (int k = 0; k < unknowns_ - 1; ++k) grouping_[at(sizes_.angles + first_null() + k)] = 1;
    for (int k = first_active(); k < sizes_.coordinates; ++k)
        grouping_[at(sizes_.angles + k)] = (unknowns_ > 1 ? 2 : 1) + k - first_active();
    entry_ = find_entry();
}

EQUILIBRIA_INLINE ActiveEntry CriticalSystem::find_entry() const {
    const std::vector<double> one(active_.size(), 1.0);
    auto f = model_->equations(model_->generic_parameters(), active_, one, first_active());
    for (auto& equation : f) equation = equation.pruned();
    const auto for_each_exponent = [&](const auto& take) {
        for (int i = 0; i < unknowns_; ++i)
            for (const auto& term : f[at(i)].terms())
                for (int k = 0; k < actives(); ++k)
                    take(at(i), at(k), term.monomial.code(most_angles + first_active() + k));
    };
    ActiveEntry y;
    for_each_exponent([&](std::size_t, std::size_t k, int code) { y.power[k] = std::gcd(y.power[k], code); });
    for (int& g : y.power) g = g > 0 && g % 2 == 0 ? 2 : 1;
    y.content.assign(at(unknowns_), {});
    for (auto& row : y.content)
        for (int k = 0; k < actives(); ++k) row[at(k)] = RuntimePolynomial<>::Basis::highest;
    for_each_exponent([&](std::size_t i, std::size_t k, int code) {
        y.degree[k] = std::max(y.degree[k], code);
        y.content[i][k] = std::min(y.content[i][k], code / y.power[k]);
    });
    return y;
}

EQUILIBRIA_INLINE CriticalSystem::Numbers CriticalSystem::numbers(const RuntimeArray<double>& p,
                                                                  std::vector<double> scales,
                                                                  Generator& generator) const {
    Numbers y{.p = p,
              .scale = std::move(scales),
              .basis = RuntimeMatrix<double>(unknowns_),
              .sine = RuntimeArray<double>(sizes_.angles)};
    for (int r = 0; r < unknowns_; ++r)
        for (int c = 0; c < unknowns_; ++c) y.basis[r][c] = uniform(generator, -1, 1);
    if (off_symmetric_branches())
        for (double& r : y.sine) r = uniform(generator, -1, 1);
    return y;
}

EQUILIBRIA_INLINE RuntimePolynomials<> CriticalSystem::equations(const Numbers& numbers) const {
    return equations(numbers, model_->equations(numbers.p, active_, numbers.scale, first_active()));
}
EQUILIBRIA_INLINE SparseSystem CriticalSystem::system(const Numbers& numbers) const {
    return sparse_system(equations(numbers), sizes_);
}

}  // namespace equilibria
