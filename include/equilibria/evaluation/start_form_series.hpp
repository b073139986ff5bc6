/// \file
/// What a start adds in a form of its own (start_forms.hpp), evaluated.
#pragma once

#include <complex>
#include <cstddef>
#include <span>
#include <vector>

#include <equilibria/core/aligned_vector.hpp>
#include <equilibria/core/complex.hpp>
#include <equilibria/evaluation/factor_series.hpp>
#include <equilibria/evaluation/start_forms.hpp>

namespace equilibria::detail {

/// The products of G, their Taylor coefficients and their Jacobian: a form and its series first, then the products.
template <class R>
class StartFormSeries {
public:
    using Z = Complex<R>;

    StartFormSeries(const StartForms& forms, const TermTables& tables) {
        for (const auto& product : forms.products) {
            products_.push_back(
                {product.equation, product.weight, forms_.size(), forms_.size() + product.forms.size()});
            for (const auto& form : product.forms) {
                const std::size_t first = parts_.size();
                for (const auto& part : form.parts)
                    parts_.push_back({part.unknown, tables.factor(part.unknown, 1), part.factor});
                forms_.push_back({form.constant, first, parts_.size()});
            }
        }
        series_.resize(forms_.size());
        partial_.resize(forms_.size());
    }
    bool empty() const { return products_.empty(); }

    /// The Taylor coefficients k of G, those below being known.
    void series(int k, const FactorSeries<R>& factors, auto& g) {
        for (Z& entry : g) entry = zero();
        for (std::size_t m = 0; m < forms_.size(); ++m) {
            Z sum = k == 0 ? broadcast_complex<R>(forms_[m].constant) : zero();
            for (const Part& part : parts_of(forms_[m])) sum += broadcast_complex<R>(part.by) * factors(k, part.factor);
            series_[m][k] = sum;
        }
        for (const Product& product : products_) {
            for (std::size_t m = product.first; m < product.last; ++m) {
                const auto& form = series_[m];
                auto& so_far = partial_[m];
                if (m == product.first) {
                    so_far[k] = broadcast_complex<R>(product.weight) * form[k];
                    continue;
                }
                const auto& before = partial_[m - 1];
                Z sum = before[0] * form[k];
                for (int l = 1; l <= k; ++l) sum += before[l] * form[k - l];
                so_far[k] = sum;
            }
            g[product.equation] += partial_[product.last - 1][k];
        }
    }

    /// After `series(0, ..)`.
    void slopes(const FactorSeries<R>& factors, auto& j) const {
        for (const Product& product : products_) {
            Z behind(1.0);  // of the forms behind number m
            for (std::size_t m = product.last; m-- > product.first;) {
                const Z others = m == product.first ? Z(broadcast_complex<R>(product.weight) * behind)
                                                    : Z(partial_[m - 1][0] * behind);
                for (const Part& part : parts_of(forms_[m]))
                    j[product.equation][part.unknown] +=
                        others * (broadcast_complex<R>(part.by) * factors.slope(part.factor));
                behind = behind * series_[m][0];
            }
        }
    }

private:
    struct Part {
        int unknown, factor;
        std::complex<double> by;
    };
    struct Form {
        std::complex<double> constant;
        std::size_t first, last;  // of the parts
    };
    struct Product {
        int equation;
        std::complex<double> weight;
        std::size_t first, last;  // of the forms
    };
    struct Series {
        Z value[FactorSeries<R>::order + 1];
        Z& operator[](int k) { return value[k]; }
        const Z& operator[](int k) const { return value[k]; }
    };
    std::span<const Part> parts_of(const Form& form) const {
        return {parts_.data() + form.first, form.last - form.first};
    }
    static Z zero() { return {broadcast<R>(0.0), broadcast<R>(0.0)}; }

    std::vector<Part> parts_;
    std::vector<Form> forms_;
    std::vector<Product> products_;
    AlignedVector<Series> series_, partial_;  // of each form; of each product up to form number m
};

}  // namespace equilibria::detail
