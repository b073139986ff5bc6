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
///       "rates": ["w1", "w2", "v"],                                             optional, with a kinetic energy
///       "kinetic_energy": "0.5*w1^2 + ...",                                     optional, beside a potential
///       "dissipation": "0.5*damping*w1^2",                                      optional, with a kinetic energy
///       "generalised_forces": ["0", "torque*sin(rate*time)", "0"],              optional, with a kinetic energy
///       "time": "time"                                                          optional, with such forces
///     }
///
/// Formulas have numbers, names, pi, + - * / ^ (or **), parentheses, and sin, cos, tan, sqrt, exp, log. The rules are
/// those of models: an angle, as a sum of integer multiples of angles and of phases, stands inside sin and cos alone;
/// angles and coordinates enter by polynomials of their sines, cosines and values; parameters by any function. A
/// definition is a name for a formula, for those behind it. Equations are one for each unknown, angles' first.
///
/// A model that moves (model/kinetics.hpp) has names for the rates of its unknowns, angles' first, and for the time.
/// Its kinetic energy, its dissipation and its forces, and definitions that these alone use, hold unknowns, rates and,
/// in forces, the time by any function.
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

/// What an error in a formula counts lines and columns in.
enum class FormulaPlaces {
    in_text,     ///< the text of the model, as who reads a file wants it
    in_formula,  ///< the formula, as who typed that alone wants it
};

namespace detail {

class ModelReader {
public:
    ModelReader(std::string_view text, std::size_t most_bytes, FormulaPlaces places = FormulaPlaces::in_text)
        : text_(text), places_(places), json_(parse_json(text, most_bytes, 4)), root_(json_.root, ""), model_(names()),
          builder_(static_cast<int>(model_.angles.size()), static_cast<int>(model_.coordinates.size()),
                   static_cast<int>(model_.parameters.size())) {
        add(model_.angles, "an angle", [this](int k) { return builder_.angle(k); });
        add(model_.coordinates, "a coordinate", [this](int k) { return builder_.coordinate(k); });
        add(model_.parameters, "a parameter", [this](int k) { return builder_.parameter(k); });
        motion_names();
    }

    FormulaModel read() {
        use_ = moves_ ? Use::definition : Use::equilibria;
        builder_.set_rules(moves_ ? FormulaRules::motion : FormulaRules::equilibria);
        if (root_.find("definitions"))
            for (const std::string& name : json_.order["definitions"]) {
                const Formula formula = formula_of(root_.at("definitions").at(name));
                if (!formulas_.emplace(name, formula).second || is_reserved(name))
                    throw JsonError("definitions", name, "must not be a name twice, nor that of a function");
                allowed_ += ", " + name;
            }
        use_ = Use::equilibria;
        builder_.set_rules(FormulaRules::equilibria);
        std::vector<Formula> formulas;
        if (model_.has_potential) {
            formulas.push_back(formula_of(root_.at("potential")));
        } else {
            const JsonPlace equations = root_.at("equations");
            for (std::size_t k = 0; k < equations.size(); ++k) formulas.push_back(formula_of(equations[k]));
        }
        FormulaModel y = formula_model(std::move(model_), builder_, formulas);
        return moves_ ? moving(std::move(y)) : y;
    }

private:
    /// What a formula is for.
    enum class Use { equilibria, definition, energy, forces };

    /// Names of the rates and of the time, and whether the keys of a motion go together.
    void motion_names() {
        moves_ = root_.find("kinetic_energy").has_value();
        for (const char* key : {"rates", "dissipation", "generalised_forces", "time"})
            if (const auto place = root_.find(key); place && !moves_)
                place->refuse("must stand beside \"kinetic_energy\"");
        if (!moves_) return;
        if (!model_.has_potential)
            root_.at("kinetic_energy")
                .refuse("must stand beside \"potential\": a model of equations has no potential energy");
        const JsonPlace rates = root_.at("rates");
        const auto names = static_cast<std::size_t>(model_.unknowns());
        if (rates.size() != names) rates.refuse("must be one name for each unknown: " + std::to_string(names));
        for (std::size_t k = 0; k < names; ++k) kinetics_.rates.push_back(rates[k].string());
        add(kinetics_.rates, "a rate", [this](int k) { return builder_.rate(k); }, rates_);
        if (const auto time = root_.find("time")) {
            if (!root_.find("generalised_forces")) time->refuse("must stand beside \"generalised_forces\"");
            kinetics_.time = time->string();
            add({kinetics_.time}, "the time", [this](int) { return builder_.time(); }, time_);
        }
    }

    FormulaModel moving(FormulaModel model) {
        builder_.set_rules(FormulaRules::motion);
        use_ = Use::energy;
        const JsonPlace energy = root_.at("kinetic_energy");
        kinetics_.kinetic_energy = formula_of(energy);
        if (const auto place = root_.find("dissipation")) kinetics_.dissipation = formula_of(*place);
        use_ = Use::forces;
        if (const auto forces = root_.find("generalised_forces")) {
            if (forces->size() != kinetics_.rates.size())
                forces->refuse("must be one formula for each unknown: " + std::to_string(kinetics_.rates.size()));
            for (std::size_t k = 0; k < forces->size(); ++k)
                kinetics_.generalised_forces.push_back(formula_of((*forces)[k]));
        }
        try {
            return with_kinetics(std::move(model), builder_, kinetics_);
        } catch (const InvalidArgument& error) {
            const std::string what = error.what(), before = "kinetic_energy = ";
            if (!what.starts_with(before)) throw;
            const std::size_t colon = what.find(": ");
            throw JsonError("kinetic_energy, " + line_of(energy, 0), what.substr(before.size(), colon - before.size()),
                            what.substr(colon + 2));
        }
    }

    /// The formula of a name, where it may stand in a formula of this use.
    Formula of_name(const std::string& name, const Formula& formula) const {
        if (formula.kind != FormulaKind::motion || use_ == Use::definition || use_ == Use::forces) return formula;
        if (use_ == Use::equilibria)
            throw InvalidArgument("formula", name,
                                  "must not stand in a potential: it holds a rate or the time, or is no polynomial of "
                                  "sines, cosines and coordinates");
        if (!kinetics_.time.empty() && builder_.steps().depends_on(formula.step, FormulaOperation::time))
            throw InvalidArgument("formula", name, "must stand in generalised_forces alone: it depends on the time");
        return formula;
    }
    std::string allowed() const {
        return allowed_ + (use_ != Use::equilibria ? rates_ : "") +
               (use_ == Use::definition || use_ == Use::forces ? time_ : "");
    }

    static bool is_reserved(const std::string& name) {
        const auto& functions = FormulaBuilder::functions();
        return name == "pi" || std::find(functions.begin(), functions.end(), name) != functions.end();
    }

    FormulaModel names() {
        FormulaModel y;
        root_.keys("a model", {},
                   {"name", "angles", "coordinates", "parameters", "definitions", "potential", "equations", "rates",
                    "kinetic_energy", "dissipation", "generalised_forces", "time"});
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
        add(names, what, make, allowed_);
    }
    template <class Make>
    void add(const std::vector<std::string>& names, const char* what, const Make& make, std::string& allowed) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (!formulas_.emplace(names[k], make(static_cast<int>(k))).second)
                throw JsonError(what, names[k], "must not have a name that is used already");
            allowed += (allowed_.empty() ? "" : ", ") + names[k];
        }
    }
    Formula formula_of(const JsonPlace& place) {
        const auto resolve = [this](const std::string& name) {
            const auto found = formulas_.find(name);
            if (found == formulas_.end())
                throw InvalidArgument("formula", "no name " + name, "must be one of " + allowed());
            return of_name(name, found->second);
        };
        try {
            return formula_text::parse(place.string(), builder_, resolve);
        } catch (const formula_text::FormulaError& error) {
            throw JsonError(place.name() + ", " + line_of(place, error.byte), error.what_is_there,
                            error.what_is_allowed);
        }
    }

    /// Line and column of the byte of a string's value.
    std::string line_of(const JsonPlace& place, std::size_t byte) const {
        const bool in_formula = places_ == FormulaPlaces::in_formula;
        const std::string_view text = in_formula ? std::string_view(place.string()) : text_;
        std::size_t at = in_formula ? byte : string_at(text_, place.name());
        for (std::size_t k = 0; !in_formula && k < byte && at < text.size(); ++k) {
            if (text[at] == '\\') at += at + 1 < text.size() && text[at + 1] == 'u' ? 5 : 1;
            ++at;
        }
        at = std::min(at, text.size());
        const auto line = std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n') + 1;
        const std::size_t last = text.substr(0, at).rfind('\n');
        const std::size_t column = at - (last == text.npos ? 0 : last + 1) + 1;
        return "line " + std::to_string(line) + ", column " + std::to_string(column);
    }

    std::string_view text_;
    FormulaPlaces places_;
    JsonText json_;
    JsonPlace root_;
    FormulaModel model_;
    FormulaBuilder builder_;
    std::map<std::string, Formula> formulas_;
    std::string allowed_, rates_, time_;  ///< the names, as an error lists them
    KineticFormulas kinetics_;
    bool moves_ = false;
    Use use_ = Use::equilibria;
};

}  // namespace detail

/// The model that a text says. Throws InvalidArgument for a text that is not one, with the place in it, and for
/// formulas that are none of a model, with line and column.
inline FormulaModel parse_model(std::string_view text, std::size_t most_bytes = std::size_t{16} << 20,
                                FormulaPlaces places = FormulaPlaces::in_text) {
    return detail::ModelReader(text, most_bytes, places).read();
}
/// The model in a file. Throws InvalidArgument also where the file cannot be read.
inline FormulaModel read_model(const std::string& path, std::size_t most_bytes = std::size_t{16} << 20) {
    return parse_model(read_text(path, most_bytes), most_bytes);
}

}  // namespace equilibria
