/// \file
/// Models from JSON, read strictly (strict_json.hpp; needs nlohmann/json and PEGTL):
///
///     {
///       "name": "rotating double pendulum",                                     optional
///       "angles": ["t1", "t2"],                                                 optional
///       "coordinates": ["x"],                                                   optional
///       "parameters": {"alpha": 0.33, "omega": 2},                              optional, with their values
///       "definitions": {"stretch": "sin(t1) - alpha"},                          optional
///       "potential": "-0.5*omega^2*((1 - alpha)*sin(t1)^2 + ...) - ..."         or "equations": ["...", "..."]
///     }
///
/// Formulas have numbers, names, pi, + - * / ^ (or **), parentheses, and sin, cos, tan, sqrt, exp, log. The rules are
/// those of models: an angle, as a sum of integer multiples of angles and of phases, stands inside sin and cos alone;
/// angles and coordinates enter by polynomials of their sines, cosines and values; parameters by any function. A
/// definition is a name for a formula, for those behind it. Equations are one for each unknown, angles' first.
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/formula/formula_model.hpp>
#include <equilibria/io/detail/formula_grammar.hpp>
#include <equilibria/io/read_text.hpp>
#include <equilibria/io/strict_json.hpp>

namespace equilibria {

namespace detail {

class ModelReader {
public:
    ModelReader(std::string_view text, std::size_t most_bytes)
        : text_(text), json_(parse_json(text, most_bytes, 4)), root_(json_.root, ""), model_(names()),
          builder_(static_cast<int>(model_.angles.size()), static_cast<int>(model_.coordinates.size()),
                   static_cast<int>(model_.parameters.size())) {
        add(model_.angles, "an angle", [this](int k) { return builder_.angle(k); });
        add(model_.coordinates, "a coordinate", [this](int k) { return builder_.coordinate(k); });
        add(model_.parameters, "a parameter", [this](int k) { return builder_.parameter(k); });
    }

    FormulaModel read() {
        if (root_.find("definitions"))
            for (const std::string& name : json_.order["definitions"]) {
                const Formula formula = formula_of(root_.at("definitions").at(name));
                if (!formulas_.emplace(name, formula).second || is_reserved(name))
                    throw JsonError("definitions", name, "must not be a name twice, nor that of a function");
                allowed_ += ", " + name;
            }
        std::vector<Formula> formulas;
        if (model_.has_potential) {
            formulas.push_back(formula_of(root_.at("potential")));
        } else {
            const JsonPlace equations = root_.at("equations");
            for (std::size_t k = 0; k < equations.size(); ++k) formulas.push_back(formula_of(equations[k]));
        }
        return formula_model(std::move(model_), builder_, formulas);
    }

private:
    static bool is_reserved(const std::string& name) {
        const auto& functions = FormulaBuilder::functions();
        return name == "pi" || std::find(functions.begin(), functions.end(), name) != functions.end();
    }

    FormulaModel names() {
        FormulaModel y;
        root_.keys("a model", {},
                   {"name", "angles", "coordinates", "parameters", "definitions", "potential", "equations"});
        const auto list = [&](const char* key, std::vector<std::string>& to) {
            if (const auto place = root_.find(key))
                for (std::size_t k = 0; k < place->size(); ++k) to.push_back((*place)[k].string());
        };
        if (const auto name = root_.find("name")) y.name = name->string();
        list("angles", y.angles);
        list("coordinates", y.coordinates);
        if (const auto values = root_.find("parameters")) {
            values->object();
            y.parameters = json_.order["parameters"];
            y.values = RuntimeArray<double>(static_cast<int>(y.parameters.size()));
            for (int k = 0; k < y.values.size(); ++k)
                y.values[k] = values->at(y.parameters[static_cast<std::size_t>(k)]).number();
        }
        if (root_.find("definitions")) root_.at("definitions").object();
        y.has_potential = root_.find("potential").has_value();
        if (y.has_potential == root_.find("equations").has_value())
            root_.refuse("must have either \"potential\" or \"equations\"");
        return y;
    }
    template <class Make>
    void add(const std::vector<std::string>& names, const char* what, const Make& make) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (!formulas_.emplace(names[k], make(static_cast<int>(k))).second)
                throw JsonError(what, names[k], "must not have a name that is used already");
            allowed_ += (allowed_.empty() ? "" : ", ") + names[k];
        }
    }
    Formula formula_of(const JsonPlace& place) {
        const auto resolve = [this](const std::string& name) {
            const auto found = formulas_.find(name);
            if (found == formulas_.end())
                throw InvalidArgument("formula", "no name " + name, "must be one of " + allowed_);
            return found->second;
        };
        try {
            return formula_text::parse(place.string(), builder_, resolve);
        } catch (const formula_text::FormulaError& error) {
            throw JsonError(place.name() + ", " + in_text(place.name(), error.byte), error.what_is_there,
                            error.what_is_allowed);
        }
    }

    /// Line and column in the text of the byte of a string's value.
    std::string in_text(const std::string& place, std::size_t byte) const {
        const std::size_t begin = string_at(text_, place);
        std::size_t at = begin;
        for (std::size_t k = 0; k < byte && at < text_.size(); ++k) {
            if (text_[at] == '\\') at += at + 1 < text_.size() && text_[at + 1] == 'u' ? 5 : 1;
            ++at;
        }
        at = std::min(at, text_.size());
        const auto line = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
        const std::size_t last = text_.substr(0, at).rfind('\n');
        const std::size_t column = at - (last == text_.npos ? 0 : last + 1) + 1;
        return "line " + std::to_string(line) + ", column " + std::to_string(column);
    }

    std::string_view text_;
    JsonText json_;
    JsonPlace root_;
    FormulaModel model_;
    FormulaBuilder builder_;
    std::map<std::string, Formula> formulas_;
    std::string allowed_;  ///< the names, as an error lists them
};

}  // namespace detail

/// The model that a text says. Throws InvalidArgument for a text that is not one, with the place in it, and for
/// formulas that are none of a model, with line and column.
inline FormulaModel parse_model(std::string_view text, std::size_t most_bytes = std::size_t{16} << 20) {
    return detail::ModelReader(text, most_bytes).read();
}
/// The model in a file. Throws InvalidArgument also where the file cannot be read.
inline FormulaModel read_model(const std::string& path, std::size_t most_bytes = std::size_t{16} << 20) {
    return parse_model(read_text(path, most_bytes), most_bytes);
}

}  // namespace equilibria
