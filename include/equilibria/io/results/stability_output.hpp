/// \file
/// What the criteria say of an equilibrium's stability as JSON.
#pragma once

#include <optional>
#include <utility>

#include <equilibria/io/results/json.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/pole_count.hpp>

namespace equilibria {

/// Of the energy: "hessian" (rows) and its leading principal "minors".
template <class Matrix>
Json json_of(const LagrangeDirichlet<Matrix>& energy) {
    return {{"hessian", json_rows(energy.hessian)}, {"minors", json_list(energy.minors)}};
}

/// Of the linearised motion: "characteristic_polynomial" (the leading coefficient first), "routh_first_column",
/// "routh_table", "routh_special_cases", "hurwitz_minors", "hurwitz_matrix", "poles" ([real, imaginary] each, a unit of
/// time), "poles_right_half_plane" (null where the criteria disagree), "poles_on_axis", "verdict".
template <class Matrix>
Json json_of(const PoleCount<Matrix>& motion) {
    Json special = Json::array();
    for (const auto& s : motion.routh.special) special.push_back({{"row", s.row}, {"kind", to_string(s.kind)}});
    return {{"characteristic_polynomial", json_list(motion.polynomial)},
            {"routh_first_column", json_list(motion.routh.first_column().eval())},
            {"hurwitz_minors", json_list(motion.hurwitz.minors)},
            {"poles_right_half_plane", json_or_null(motion.right_half_plane())},
            {"poles", json_list(motion.poles)},
            {"verdict", to_string(motion.verdict())},
            {"poles_on_axis", motion.on_axis},
            {"routh_table", json_rows(motion.routh.rows)},
            {"routh_special_cases", std::move(special)},
            {"hurwitz_matrix", json_rows(motion.hurwitz.matrix)}};
}

}  // namespace equilibria
