/// \file
/// The function of a model at run time as ModelFunctions, which follows branches, refines singularities and traces
/// loci.
#pragma once

#include <tuple>
#include <utility>

#include <equilibria/model/model_functions.hpp>
#include <equilibria/model/runtime_model.hpp>

namespace equilibria {

template <RuntimeModel T, class S = double>
class RuntimeModelFunctions final : public ModelFunctions<S> {
public:
    explicit RuntimeModelFunctions(const T& model)
        : ModelFunctions<S>(sizes_of(model), model.parameters(), RuntimePotentialModel<T>), model_(model) {}

    void linearize(const RuntimeArray<S>& q, const RuntimeArray<S>& p, RuntimeArray<S>& f,
                   RuntimeMatrix<S>& j) const override {
        const auto [theta, x] = split_unknowns(q, this->sizes());
        std::tie(f, j) = equations_and_jacobian(model_, theta, x, p);
    }
    void derivatives_along(const RuntimeArray<S>& q, const RuntimeArray<S>& v, const RuntimeArray<S>& p,
                           const RuntimeArray<S>& w, RuntimeArray<S>& f, RuntimeMatrix<S>& j) const override {
        using D = Dual<S, 1>;
        const auto along = [](const RuntimeArray<S>& from, const RuntimeArray<S>& by) {
            RuntimeArray<D> y(from.size());
            for (int k = 0; k < y.size(); ++k) y[k] = D(from[k]), y[k].derivative[0] = by[k];
            return y;
        };
        const auto [theta, x] = split_unknowns(along(q, v), this->sizes());
        const auto [values, slopes] = equations_and_jacobian(model_, theta, x, along(p, w));
        const int n = this->unknowns();
        f.resize(n);
        j = RuntimeMatrix<S>(n);
        for (int r = 0; r < n; ++r) {
            f[r] = values[r].derivative[0];
            for (int c = 0; c < n; ++c) j[r][c] = slopes[r][c].derivative[0];
        }
    }
    RuntimeArray<Jet<S>> equations(const RuntimeArray<Jet<S>>& q, const RuntimeArray<Jet<S>>& p) const override {
        const auto [theta, x] = split_unknowns(q, this->sizes());
        return equations_at(model_, theta, x, p);
    }

private:
    T model_;
};

}  // namespace equilibria
