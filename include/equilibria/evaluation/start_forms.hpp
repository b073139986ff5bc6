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
        int equation;                      ///< equation and unknown, from 0
        int code;                          ///< see Monomial
        std::complex<double> coefficient;  ///< gamma included
    };
    /// constant + sum of factor * (cos of the unknown, or the unknown).
    struct LinearForm {
        /// factor * (cos of the unknown, or the unknown).
        struct Part {
            int unknown;                  ///< from 0
            std::complex<double> factor;  ///< random complex number
        };
        std::complex<double> constant;  ///< the value where all cosines and coordinates are 0
        std::vector<Part> parts;        ///< one an unknown of its group
    };
    /// weight * product of linear forms.
    struct Product {
        int equation;                   ///< from 0; one product an equation at most
        std::complex<double> weight;    ///< gamma included
        std::vector<LinearForm> forms;  ///< as many as the degree of the equation
    };
    std::vector<Term> terms;        ///< of all equations
    std::vector<Product> products;  ///< of all equations that have one
};

}  // namespace equilibria
