/// \file
/// Degenerate equilibria as JSON: points of a plane of two parameters, cusps, singularities of every kind. Here alone
/// is known how these types name their members.
#pragma once

#include <string>
#include <string_view>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

/// The names of the parameters that change: they are keys of JSON and columns of CSV.
struct AxisNames {
    std::string x = "x";  ///< the first parameter
    std::string y = "y";  ///< the second
    std::string z = "z";  ///< the third, of a space
};

constexpr std::string_view kind_name(CriticalKind kind) { return to_string(kind); }  ///< in words, as to_string
/// With '_' for what is no letter: it is a word of JSON.
inline std::string kind_name(SingularityKind kind) {
    std::string text(to_string(kind));
    for (char& c : text)
        if (c == ' ' || c == '-') c = '_';
    return text;
}

/// A point of a plane: its two active parameters by their names, and "angles".
template <class M>
Json point_json(const Singularity<M>& at, const AxisNames& names, const Sizes<M>& sizes = {}) {
    Json out{{names.x, json_of(at.x())}, {names.y, json_of(at.y())}};
    add_unknowns<M>(out, at.q, sizes);
    return out;
}

/// As a point, with "residual" and "fourth_derivative", of the potential along the null vector.
template <class M>
Json cusp_json(const Singularity<M>& cusp, const AxisNames& names, const Sizes<M>& sizes = {}) {
    Json out = point_json(cusp, names, sizes);
    out["residual"] = cusp.residual;
    out["fourth_derivative"] = json_of(cusp.derivative(4));
    return out;
}

/// As a point, with its curve's "kind" and "of": the name of the parameter that is extremal.
template <class M>
Json extremal_json(const Singularity<M>& at, const AxisNames& names, const Sizes<M>& sizes = {}) {
    Json out{{"kind", kind_name(curve_of(at.kind))}, {"of", at.extremal == at.active[0] ? names.x : names.y}};
    add_keys(out, point_json(at, names, sizes));
    return out;
}

/// "kind", "residual", "nullity", "angles", "derivatives": of the reduced potential, from the third; with two null
/// vectors the cubic on their plane. Of lips and beak-to-beak also "form": the eigenvalues of the second-order form.
template <PotentialModel M>
Json json_of(const Singularity<M>& s) {
    Json out{{"kind", kind_name(s.kind)}, {"residual", s.residual}, {"nullity", s.nullity}};
    add_unknowns<M>(out, s.q);
    if (s.nullity == 2)
        out["derivatives"] = json_list(s.cubic);
    else
        out["derivatives"] = json_list(s.derivatives);
    if (s.kind == SingularityKind::lips || s.kind == SingularityKind::beak_to_beak) out["form"] = json_list(s.form);
    return out;
}

}  // namespace equilibria
