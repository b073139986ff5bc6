/// \file
/// The function of a model at run time as ModelFunctions, which follows branches, refines singularities and traces
/// loci.
#pragma once

#include <equilibria/model/model_functions.hpp>
#include <equilibria/model/runtime_model.hpp>

namespace equilibria {

/// The functions of a model of type T, over the scalar S.
template <RuntimeModel T, class S = double>
class RuntimeModelFunctions final : public ModelFunctions<S> {
public:
    /// The model is copied. Throws InvalidArgument as sizes_of does.
    explicit RuntimeModelFunctions(const T& model)
        : ModelFunctions<S>(sizes_of(model), model.parameters(), RuntimePotentialModel<T>), model_(model) {}

    /// As of ModelFunctions; the Jacobian by duals of four directions at a time.
    /// \{
    void linearize(const RuntimeArray<S>& q, const RuntimeArray<S>& p, RuntimeArray<S>& f,
                   RuntimeMatrix<S>& j) const override {
        const RuntimeModelPoint<S> at(q.begin(), this->sizes());
        f.resize(this->unknowns());
        j = RuntimeMatrix<S>(this->unknowns());
        equations_and_jacobian(model_, at.theta, at.x, p, f.begin(), j[0]);
    }
    void derivatives_along(const RuntimeArray<S>& q, const RuntimeArray<S>& v, const RuntimeArray<S>& p,
                           const RuntimeArray<S>& w, RuntimeArray<S>& f, RuntimeMatrix<S>& j) const override {
        using D = Dual<S, 1>;
        const auto along = [](const RuntimeArray<S>& from, const RuntimeArray<S>& by) {
            LocalArray<D> y(from.size());
            for (int k = 0; k < y.size(); ++k) y[k] = D(from[k]), y[k].derivative[0] = by[k];
            return y;
        };
        const RuntimeModelPoint<D> at(along(q, v).begin(), this->sizes());
        const int n = this->unknowns();
        LocalArray<D> values(n), slopes(n * n);
        equations_and_jacobian(model_, at.theta, at.x, along(p, w), values.begin(), slopes.begin());
        f.resize(n);
        j = RuntimeMatrix<S>(n);
        for (int r = 0; r < n; ++r) {
            f[r] = values[r].derivative[0];
            for (int c = 0; c < n; ++c) j[r][c] = slopes[r * n + c].derivative[0];
        }
    }
    RuntimeArray<Jet<S>> equations(const RuntimeArray<Jet<S>>& q, const RuntimeArray<Jet<S>>& p) const override {
        const RuntimeModelPoint<Jet<S>> at(q.begin(), this->sizes());
        RuntimeArray<Jet<S>> f(this->unknowns());
        equations_at(model_, at.theta, at.x, p, f.begin());
        return f;
    }
    /// \}

private:
    T model_;
};

}  // namespace equilibria
