/// \file
/// What a start adds in a form of its own, G in (1-t) G, as data: sums of a term or two an unknown (total degree), or
/// products of linear forms, which are evaluated as they are (start_form_series.hpp): multiplied out, they would have
/// ten times the terms of the target.
#pragma once

#include <complex>
#include <vector>

namespace equilibria {

/// G_i = sum of terms of equation i + weight_i * product of its forms, where it has any.
struct StartForms {
    /// coefficient * the factor with this code of the equation's own unknown.
    struct Term {
        int equation, code;
        std::complex<double> coefficient;
    };
    /// constant + sum of factor * (cos of the unknown, or the unknown).
    struct LinearForm {
        struct Part {
            int unknown;
            std::complex<double> factor;
        };
        std::complex<double> constant;
        std::vector<Part> parts;
    };
    struct Product {
        int equation;
        std::complex<double> weight;  ///< gamma included
        std::vector<LinearForm> forms;
    };
    std::vector<Term> terms;
    std::vector<Product> products;
};

}  // namespace equilibria
