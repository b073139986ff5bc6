/// \file
/// See system/symmetric_system.hpp.
#pragma once

#include <cmath>

#include <equilibria/system/symmetric_system.hpp>

namespace equilibria {

EQUILIBRIA_INLINE SymmetricSystem::Numbers SymmetricSystem::numbers(const RuntimeArray<double>& p,
                                                                    std::vector<double> scales,
                                                                    const RuntimeArray<double>& branch,
                                                                    Generator& generator) const {
    Numbers y;
    y.plane.p = p;
    y.plane.scale = std::move(scales);
    y.plane.basis = RuntimeMatrix<double>(n_);
    for (int r = 0; r < n_; ++r)
        for (int c = 0; c < n_; ++c) y.plane.basis[r][c] = uniform(generator, -1, 1);
    y.cosine = RuntimeArray<double>(n_);
    for (int i = 0; i < n_; ++i) y.cosine[i] = std::cos(branch[i]) < 0 ? -1 : 1;
    return y;
}

EQUILIBRIA_INLINE RuntimePolynomials<> SymmetricSystem::equations(const Numbers& numbers) const {
    const auto& plane = numbers.plane;
    return equations(numbers,
                     plane_->model().equations(plane.p, plane_->active(), plane.scale, plane_->first_active()));
}

}  // namespace equilibria
