/// \file
/// See enumerate/classify.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <utility>

#include <Eigen/Core>

#include <equilibria/core/dense_factorization.hpp>
#include <equilibria/core/eigenvalues.hpp>
#include <equilibria/core/sorted_order.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/detail/mirror_images.hpp>
#include <equilibria/stability/inertia.hpp>

namespace equilibria::detail {

/// No root with a larger imaginary part is real.
inline constexpr double nearly_real = 1e-5;

/// D H D with powers of two for D, so that the largest entry of each row is about 1: a congruence, which keeps the
/// inertia and makes it independent of the unknowns' units.
void equilibrate(auto& hessian) {
    const auto n = hessian.rows();
    for (int round = 0; round < 3; ++round) {
        std::array<int, 64> power{};
        for (Eigen::Index i = 0; i < n && i < 64; ++i) {
            const double largest = hessian.row(i).cwiseAbs().maxCoeff();
            if (std::isnormal(largest)) power[static_cast<std::size_t>(i)] = -(std::ilogb(largest) / 2);
        }
        for (Eigen::Index i = 0; i < n && i < 64; ++i)
            for (Eigen::Index j = 0; j < n && j < 64; ++j)
                hessian(i, j) =
                    std::ldexp(hessian(i, j), power[static_cast<std::size_t>(i)] + power[static_cast<std::size_t>(j)]);
    }
}

struct RootClassifier::Workspace {
    RuntimeArray<double> step;
    RuntimeMatrix<double> jacobian;
    DenseFactorization<double, at_run_time> lu;

    explicit Workspace(int n) : step(n), jacobian(n), lu(n) {}
    double* entries() { return &jacobian[0][0]; }
};

EQUILIBRIA_INLINE RootClassifier::RootClassifier(const RealEquations& equations)
    : equations_(&equations), with_(std::make_unique<Workspace>(equations.sizes.unknowns)) {}
EQUILIBRIA_INLINE RootClassifier::~RootClassifier() = default;

EQUILIBRIA_INLINE bool RootClassifier::is_real(const RootView& root, std::span<double> q) {
    auto& [step, jacobian, lu] = *with_;
    const auto n = q.size(), angles = static_cast<std::size_t>(equations_->sizes.angles);
    double imaginary = 0;
    for (const auto& z : root.q) imaginary = std::max(imaginary, std::abs(z.imag()));
    if (!(imaginary < nearly_real)) return false;
    for (std::size_t u = 0; u < n; ++u) q[u] = root.q[u].real();
    linearized_ = false;
    if (root.singular) return true;
    double moved = 0;
    for (int round = 0; round < 3; ++round) {
        equations_->linearize(q.data(), &step[0], with_->entries());
        lu.factor(jacobian);
        if (!lu.regular()) return imaginary < 1e-12;
        lu.solve_in_place(step);
        double size = 0;
        for (const double d : step) {
            if (!std::isfinite(d)) return imaginary < 1e-12;
            size = std::max(size, std::abs(d));
        }
        for (std::size_t u = 0; u < n; ++u) q[u] -= step[static_cast<int>(u)];
        moved += size;
        if (moved > 1e-4) return false;
        if (size < 1e-10) {  // what Newton's method would still change is its square
            linearized_ = true;
            break;
        }
    }
    for (std::size_t u = 0; u < angles; ++u) {
        q[u] = std::remainder(q[u], 2 * std::numbers::pi);
        if (q[u] <= -std::numbers::pi) q[u] = std::numbers::pi;
    }
    // the real Newton iteration moves by the size of the imaginary part if root and conjugate are two, and by rounding
    // if they are one
    return imaginary <= 1e-13 * root.condition + 1e-12;
}

EQUILIBRIA_INLINE Classification RootClassifier::classify(std::span<const double> q) {
    const int n = with_->step.size();
    if (!linearized_) equations_->linearize(q.data(), &with_->step[0], with_->entries());
    linearized_ = false;  // the matrix is overwritten
    Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> jacobian(with_->entries(), n, n);
    Classification y;
    y.energy = equations_->energy(q.data());
    if (equations_->has_potential) {
        equilibrate(jacobian);
        const Inertia hessian = inertia_in_place(jacobian);
        y.index = hessian.negative;
        y.nullity = hessian.zero;
        y.margin = hessian.margin;
        return y;
    }
    jacobian.transposeInPlace();  // column after column
    const auto values =
        eigenvalues<double>(static_cast<int>(jacobian.rows()), {jacobian.data(), jacobian.data() + jacobian.size()});
    double largest = 0, smallest = std::numeric_limits<double>::infinity();
    for (const auto& z : values) {
        largest = std::max(largest, std::abs(z));
        smallest = std::min(smallest, std::abs(z));
    }
    for (const auto& z : values)
        if (!(std::abs(z) > zero_eigenvalue * largest))
            ++y.nullity;
        else
            y.index += z.real() < 0;
    y.margin = largest > 0 ? smallest / largest : 0;
    return y;
}

EQUILIBRIA_INLINE double largest_imaginary(const Root<RuntimeUnknowns>& root) {
    double y = 0;
    for (const auto& q : root.q) y = std::max(y, std::abs(q.imag()));
    return y;
}

EQUILIBRIA_INLINE Equilibrium<RuntimeUnknowns> equilibrium_of(const Root<RuntimeUnknowns>& root, RuntimeArray<double> q,
                                                              const Classification& found) {
    Equilibrium<RuntimeUnknowns> e;
    e.q = std::move(q);
    e.energy = found.energy;
    e.index = found.index;
    e.nullity = found.nullity;
    e.margin = found.margin;
    e.residual = root.residual;
    e.condition = root.condition;
    e.path = root.path;
    e.multiplicity = root.paths;
    if (root.status == PathStatus::singular && e.nullity == 0) e.nullity = 1;
    return e;
}

EQUILIBRIA_INLINE RuntimeArray<double> mirrored(RuntimeArray<double> angles) {
    for (double& angle : angles) angle = angle == std::numbers::pi ? angle : 0 - angle;
    return angles;
}

EQUILIBRIA_INLINE RealRoots classify(const std::vector<Root<RuntimeUnknowns>>& roots, const RealEquations& equations,
                                     bool odd, const Executor& executor) {
    RealRoots y;
    std::vector<const Root<RuntimeUnknowns>*> near;  // the real points
    for (const auto& root : roots)
        if (const double imaginary = largest_imaginary(root); imaginary < nearly_real)
            near.push_back(&root);
        else
            y.smallest_nonreal_imaginary = std::min(y.smallest_nonreal_imaginary, imaginary);
    MirrorImages mirror;
    if (odd) mirror = MirrorImages(near.size(), [&](std::size_t k) { return view(*near[k]).q; });
    constexpr std::size_t block = 256;
    std::vector<RealRoots> found((near.size() + block - 1) / block);
    executor.for_blocks(near.size(), block, [&](std::size_t first, std::size_t last) {
        RootClassifier classifier(equations);
        RuntimeArray<double> q(equations.sizes.unknowns);
        RealRoots& here = found[first / block];
        for (std::size_t k = first; k < last; ++k) {
            if (odd && mirror.is_image[k]) continue;
            const auto& root = *near[k];
            const double imaginary = largest_imaginary(root);
            if (!classifier.is_real(view(root), {q.begin(), q.end()})) {
                here.smallest_nonreal_imaginary = std::min(here.smallest_nonreal_imaginary, imaginary);
                continue;
            }
            here.largest_real_imaginary = std::max(here.largest_real_imaginary, imaginary);
            const Classification classification = classifier.classify({q.begin(), q.end()});
            here.equilibria.push_back(equilibrium_of(root, q, classification));
            if (!odd || mirror.image[k] == MirrorImages::none) continue;
            here.equilibria.push_back(equilibrium_of(*near[mirror.image[k]], mirrored(q), classification));
        }
    });
    for (RealRoots& here : found) {
        std::move(here.equilibria.begin(), here.equilibria.end(), std::back_inserter(y.equilibria));
        y.largest_real_imaginary = std::max(y.largest_real_imaginary, here.largest_real_imaginary);
        y.smallest_nonreal_imaginary = std::min(y.smallest_nonreal_imaginary, here.smallest_nonreal_imaginary);
    }
    std::vector<std::array<std::int64_t, 3>> keys;
    keys.reserve(y.equilibria.size());
    for (const auto& e : y.equilibria) keys.push_back({e.index, e.nullity, static_cast<std::int64_t>(e.path)});
    y.equilibria = in_order(sorted_order(keys), std::move(y.equilibria));
    return y;
}

}  // namespace equilibria::detail
