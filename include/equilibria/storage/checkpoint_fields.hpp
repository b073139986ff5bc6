/// \file
/// What the header of a checkpoint is made of, and what it says of a model.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <equilibria/algebra/formulation.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/core/lanes.hpp>
#include <equilibria/model/sizes.hpp>
#include <equilibria/system/sparse_term.hpp>

namespace equilibria::detail {

struct CheckpointField {
    std::string name, value;  ///< neither with an end of line
};
using CheckpointFields = std::vector<CheckpointField>;

/// Lines "name: value", and back.
std::string text_of(const CheckpointFields& fields);
CheckpointFields fields_of(const std::string& text);
/// What differs, up to three fields of it: "its seed is 2, this run's is 1; its ...", where `ours` is "this run's".
std::string differences(const CheckpointFields& theirs, const CheckpointFields& here, const std::string& ours);

/// The name of a type as the compiler spells it.
template <class M>
std::string type_name() {
    const std::string_view here = __PRETTY_FUNCTION__;
    const std::size_t begin = here.find("M = ") + 4, semicolon = here.find(';', begin);
    return std::string(here.substr(begin, (semicolon == here.npos ? here.rfind(']') : semicolon) - begin));
}

/// The compiler of this unit and its flags, as far as they change the last bits.
static inline std::string build_name() {
    std::string name =
#if defined(__clang__)
        "clang " __clang_version__;
#else
        "g++ " __VERSION__;
#endif
#if defined(__x86_64__)
    name += ", x86-64";
#elif defined(__aarch64__)
    name += ", AArch64";
#endif
    name += ", " + std::to_string(native_lanes) + " lanes";
#if defined(__FMA__)
    name += ", fused multiply-add";
#endif
#if defined(__FAST_MATH__)
    name += ", fast-math";
#endif
#if !defined(__OPTIMIZE__)
    name += ", not optimised";
#endif
    return name;
}

/// What a header says of a model, and of the unit that tracks its paths. support: a number for each term and factor.
CheckpointFields model_fields(const std::string& name, const RuntimeSizes& sizes, int terms,
                              const std::vector<std::uint64_t>& support, std::span<const double> parameters,
                              const std::string& build);

/// Equation and exponents of each term, word by word.
inline std::vector<std::uint64_t> support_words(int unknowns, const auto& terms) {
    std::vector<std::uint64_t> y;
    for (const auto& term : terms) {
        y.push_back(static_cast<std::uint64_t>(term.equation));
        for (int u = 0; u < unknowns; ++u) y.push_back(static_cast<std::uint64_t>(term.monomial.code(u)));
    }
    return y;
}

template <Model M>
[[gnu::cold]] CheckpointFields model_fields(const Parameters<M>& p) {
    return model_fields(type_name<M>(), Sizes<M>(), Formulation<M>::terms,
                        support_words(n_unknowns<M>, Formulation<M>::support), {p.begin(), p.end()}, build_name());
}

/// Of a model at run time.
inline CheckpointFields model_fields(const std::string& name, const RuntimeSizes& sizes,
                                     const std::vector<SparseTerm>& terms, std::span<const double> parameters) {
    return model_fields(name, sizes, static_cast<int>(terms.size()), support_words(sizes.unknowns, terms), parameters,
                        build_name());
}

}  // namespace equilibria::detail

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/storage/detail/checkpoint_fields_definitions.hpp>
#endif
