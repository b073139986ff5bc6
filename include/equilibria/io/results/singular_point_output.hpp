/// \file
/// Degenerate equilibria as JSON: points of a plane of two parameters, cusps, singularities of every kind. Here alone
/// is known how these types name their members.
#pragma once

#include <string>
#include <string_view>

#include <equilibria/continuation/critical_point.hpp>
#include <equilibria/io/results/json.hpp>
#include <equilibria/locus/plane/locus_result.hpp>
#include <equilibria/singularity/locus_point.hpp>
#include <equilibria/singularity/singularity.hpp>

namespace equilibria {

/// The names of the parameters that change: they are keys of JSON and columns of CSV.
struct AxisNames {
    std::string x = "x", y = "y", z = "z";
};

constexpr std::string_view kind_name(LocusKind kind) { return kind == LocusKind::fold ? "fold" : "pitchfork"; }
constexpr std::string_view kind_name(CriticalKind kind) { return to_string(kind); }
/// With '_' for what is no letter: it is a word of JSON.
inline std::string kind_name(SingularityKind kind) {
    std::string text(to_string(kind));
    for (char& c : text)
        if (c == ' ' || c == '-') c = '_';
    return text;
}

/// The name of the parameter, "x", "y", .. of it, and "angles".
template <Model M>
Json json_of(const LocusPoint<M>& at, const AxisNames& names) {
    Json out{{names.x, json_of(at.x)}, {names.y, json_of(at.y)}};
    add_unknowns<M>(out, at.q);
    return out;
}

/// As a point, with "residual" and "fourth_derivative", of the potential along the null vector.
template <Model M>
Json json_of(const Cusp<M>& cusp, const AxisNames& names) {
    Json out = json_of(cusp.at, names);
    out["residual"] = cusp.residual;
    out["fourth_derivative"] = json_of(cusp.fourth);
    return out;
}

/// As a point, with its curve's "kind" and "of": the name of the parameter that is extremal, whose number is compared
/// with `x`, that of the first one.
template <Model M>
Json json_of(const ExtremalPoint<M>& point, const AxisNames& names, int x) {
    Json out{{"kind", kind_name(point.kind)}, {"of", point.parameter == x ? names.x : names.y}};
    add_keys(out, json_of(point.at, names));
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
