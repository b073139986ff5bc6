/// \file
/// What all results have in common as JSON (needs nlohmann/json, as every header of io/results/ does).
///
/// A result is an ordered object: its keys stand in the order in which they are written down in docs/output.md. Numbers
/// have as few digits as are needed to read the same double again, with a point whatever the locale; what is not finite
/// is null, since JSON has no word for it. -0 is written as 0. Angles are in radians.
#pragma once

#include <complex>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

#include <Eigen/Core>
#include <nlohmann/json.hpp>

#include <equilibria/io/results/text_file.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/model/sizes.hpp>

#ifdef EQUILIBRIA_JSON_COMPILED  // some unit of the program instantiates it, so that the others need not
extern template class nlohmann::basic_json<nlohmann::ordered_map>;
#endif

namespace equilibria {

/// A value of JSON, whose objects keep the order of their keys.
using Json = nlohmann::ordered_json;

/// A number; -0 becomes 0.
inline Json json_of(double x) { return x + 0.0; }

/// [real part, imaginary part].
inline Json json_of(const std::complex<double>& z) { return Json::array({z.real() + 0.0, z.imag() + 0.0}); }

/// What is there, or null.
template <class T>
Json json_or_null(const std::optional<T>& value) {
    return value ? Json(*value) : Json(nullptr);
}

/// The values as an array: numbers, complex numbers as pairs, or what else Json can be made of.
template <class Values>
Json json_list(const Values& values) {
    Json out = Json::array();
    for (const auto& value : values) {
        using T = std::remove_cvref_t<decltype(value)>;
        if constexpr (std::same_as<T, double> || std::same_as<T, std::complex<double>>)
            out.push_back(json_of(value));
        else
            out.push_back(value);
    }
    return out;
}

/// A matrix as the array of its rows.
template <class Matrix>
Json json_rows(const Matrix& matrix) {
    Json out = Json::array();
    for (Eigen::Index i = 0; i < matrix.rows(); ++i) {
        Json row = Json::array();
        for (Eigen::Index k = 0; k < matrix.cols(); ++k) row.push_back(json_of(static_cast<double>(matrix(i, k))));
        out.push_back(std::move(row));
    }
    return out;
}

/// A range of a parameter as [low, high].
inline Json json_range(double low, double high) { return Json::array({json_of(low), json_of(high)}); }

/// The keys "angles" (radians) and, where the model has plain coordinates, "coordinates".
template <class M>
void add_unknowns(Json& out, const UnknownArray<M, double>& q, const Sizes<M>& sizes = {}) {
    Json angles = Json::array(), coordinates = Json::array();
    for (int i = 0; i < sizes.unknowns; ++i) (i < sizes.angles ? angles : coordinates).push_back(json_of(q[i]));
    out["angles"] = std::move(angles);
    if (!coordinates.empty()) out["coordinates"] = std::move(coordinates);
}

/// All keys of `from`, in its order, put into `out`; those that are there already get new values.
inline void add_keys(Json& out, const Json& from) { out.update(from); }

/// The text of a document, with a line end behind it. indent: of each level; -1 for one line.
inline std::string json_text(const Json& json, int indent = 2) { return json.dump(indent) + "\n"; }

/// Writes a document to a file. Throws std::system_error where that cannot be written.
inline void write_json(const std::filesystem::path& path, const Json& json, int indent = 2) {
    write_text(path, json_text(json, indent));
}

}  // namespace equilibria
