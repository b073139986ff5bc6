/// \file
/// See studies/formula_model/formula_searches.hpp.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include <equilibria/enumerate/enumerate_at_run_time.hpp>
#include <equilibria/enumerate/more_digits.hpp>
#include <equilibria/locus/line/count_equilibria.hpp>
#include <equilibria/model/runtime_model_functions.hpp>
#include <equilibria/studies/formula_model/formula_searches.hpp>
#include <equilibria/system/runtime_formulation.hpp>
#include <equilibria/system/runtime_model_polynomials.hpp>

namespace equilibria {

namespace detail {

/// Throws InvalidArgument, by the names of the file, where an unknown does not enter the model, or a parameter that is
/// to change does not enter it as a polynomial.
template <class T>
void explain_refusal(const FormulaModel& formulas, const T& model, std::span<const int> active) {
    const RuntimeArray<double> generic = RuntimeFormulation::generic_parameters(model.parameters());
    const auto equations = symbolic_equations<double>(model, generic);
    for (std::size_t i = 0; i < equations.size(); ++i) {
        if (!equations[i].pruned().is_constant()) continue;
        if (!formulas.has_potential)
            throw InvalidArgument("equation", std::to_string(i + 1), "must depend on the unknowns");
        const std::string& name =
            i < formulas.angles.size() ? formulas.angles[i] : formulas.coordinates[i - formulas.angles.size()];
        throw InvalidArgument("unknown", name, "must enter the potential, and not by a constant slope alone");
    }
    const int first = static_cast<int>(formulas.coordinates.size());
    constexpr double one[] = {1.0};
    for (const int k : active) {
        const int alone[] = {k};
        const auto f = symbolic_equations_of<double>(model, [&](const RuntimePool<double>& pool) {
            RuntimeArray<RuntimeScalar<>> y(generic.size());
            for (int i = 0; i < y.size(); ++i) y[i] = generic[i];
            set_active<double>(y, pool, alone, one, first);
            return y;
        });
        for (const auto& equation : f) {
            if (equation.fault() == NotPolynomial::no) continue;
            const std::string& name = formulas.parameters[static_cast<std::size_t>(k)];
            throw InvalidArgument("parameter", name,
                                  "must enter the model's equations as a polynomial to be varied: give what it enters, "
                                  "such as sin(" +
                                      name + "), a parameter of its own");
        }
    }
}

/// what() of the model; what is wrong with the model is said by the names of the file.
template <class What>
auto said_by_names(const FormulaModel& formulas, std::span<const int> active, const What& what) {
    return visit(formulas, [&](const auto& model) {
        try {
            return what(model);
        } catch (const InvalidArgument&) {
            explain_refusal(formulas, model, active);
            throw;
        }
    });
}

/// search(searched, model, functions) of the model as loci and events search it.
template <class Search>
auto search_formula_model(const FormulaModel& formulas, std::span<const int> active, const Search& search) {
    return said_by_names(formulas, active, [&](const auto& model) {
        using T = std::remove_cvref_t<decltype(model)>;
        const RuntimeModelFunctions<T> functions(model);
        const RuntimeModelPolynomials<T> polynomials(model);
        const SearchedModel searched{
            &functions, &polynomials,
            [&](const RuntimeArray<double>& at, const RunOptions& how) { return count_equilibria(model, at, how); }};
        return search(searched, model);
    });
}

inline void require_parameter(const FormulaModel& model, int active) {
    require(active >= 0 && active < static_cast<int>(model.parameters.size()), "active", active,
            "must be the number of a parameter");
}
inline void require_parameters(const FormulaModel& model, const RuntimeArray<double>& p) {
    require(p.size() == static_cast<int>(model.parameters.size()), "parameters", p.size(),
            "must be as many as the model's: " + std::to_string(model.parameters.size()));
    require_finite(p, "parameters");
}

}  // namespace detail

EQUILIBRIA_INLINE RootSet<RuntimeUnknowns> enumerate(const FormulaModel& formulas, const RuntimeArray<double>& p,
                                                     const RunOptions& run, FormulaStart start, bool with_more_digits) {
    const MoreDigits<> resort = with_more_digits ? more_digits : nullptr;
    return detail::said_by_names(formulas, {}, [&](const auto& model) {
        switch (start) {
            case FormulaStart::total_degree: return enumerate_from<TotalDegreeStart>(model, p, run, {}, resort);
            case FormulaStart::polyhedral: return enumerate_from<Polyhedral>(model, p, run, {}, resort);
            case FormulaStart::least_cost: break;
        }
        return enumerate_from<LeastCost>(model, p, run, {}, resort);
    });
}
EQUILIBRIA_INLINE EveryEquilibrium every_equilibrium(const FormulaModel& formulas, const RuntimeArray<double>& p,
                                                     const RunOptions& run, FormulaStart start) {
    return detail::said_by_names(formulas, {}, [&](const auto& model) {
        switch (start) {
            case FormulaStart::total_degree: return every_equilibrium<TotalDegreeStart>(model, p, run);
            case FormulaStart::polyhedral: return every_equilibrium<Polyhedral>(model, p, run);
            case FormulaStart::least_cost: break;
        }
        return every_equilibrium<LeastCost>(model, p, run);
    });
}
EQUILIBRIA_INLINE RootSet<RuntimeUnknowns> enumerate(const FormulaModel& formulas,
                                                     const RootSet<RuntimeUnknowns>& solved,
                                                     const RuntimeArray<double>& p, const RunOptions& run) {
    return visit(formulas, [&](const auto& model) { return equilibria::enumerate(model, solved, p, run); });
}
EQUILIBRIA_INLINE ProofOfRoots prove(const FormulaModel& formulas, const RootSet<RuntimeUnknowns>& set,
                                     const RunOptions& run, const ProveOptions& options) {
    return visit(formulas, [&](const auto& model) { return equilibria::prove(model, set, run, options); });
}
EQUILIBRIA_INLINE LineEvents<RuntimeUnknowns> find_events(const FormulaModel& formulas, const RuntimeArray<double>& p,
                                                          int active, const Interval& range, const RunOptions& run) {
    detail::require_parameters(formulas, p);
    detail::require_parameter(formulas, active);
    const int active_numbers[] = {active};
    return detail::search_formula_model(formulas, active_numbers, [&](const SearchedModel& searched, const auto&) {
        return find_events(searched, p, active, range, run);
    });
}
EQUILIBRIA_INLINE BifurcationDiagram<RuntimeUnknowns> trace_diagram(const FormulaModel& formulas,
                                                                    const RuntimeArray<double>& p, int active,
                                                                    const Interval& range, const RunOptions& run,
                                                                    const BranchOptions& branch) {
    detail::require_parameters(formulas, p);
    detail::require_parameter(formulas, active);
    const int active_numbers[] = {active};
    return detail::search_formula_model(
        formulas, active_numbers, [&](const SearchedModel& searched, const auto& model) {
            const EquilibriaAt equilibria = [&](const RuntimeArray<double>& at, const RunOptions& how) {
                return equilibria::enumerate(model, at, how).equilibria;
            };
            return trace_diagram(searched, equilibria, p, active, range, run, branch);
        });
}
EQUILIBRIA_INLINE Locus<RuntimeUnknowns> trace_locus(const FormulaModel& formulas, const RuntimeArray<double>& p,
                                                     const std::array<int, 2>& active, const Window& window,
                                                     const RunOptions& run, const LocusOptions& options) {
    detail::require_parameters(formulas, p);
    for (const int k : active) detail::require_parameter(formulas, k);
    require(active[0] != active[1], "active", active[1], "must be two different parameters");
    const std::span<const int> active_numbers(active);
    return detail::search_formula_model(formulas, active_numbers, [&](const SearchedModel& searched, const auto&) {
        return trace_locus(searched, p, std::span<const int>(active), window, run, options);
    });
}
EQUILIBRIA_INLINE SweepCounts sweep(const FormulaModel& formulas, const ParameterPoints& points,
                                    const std::function<void(const SweptPoint&)>& take, const RunOptions& run,
                                    const SweepOptions& options) {
    return detail::said_by_names(
        formulas, {}, [&](const auto& model) { return equilibria::sweep(model, points, take, run, options); });
}

namespace detail {

/// f(functions) of the model's functions at unknowns and parameters that fit it.
template <class F>
auto at_unknowns(const FormulaModel& formulas, const RuntimeArray<double>& q, const RuntimeArray<double>& p,
                 const F& f) {
    require_parameters(formulas, p);
    require(q.size() == formulas.unknowns(), "q", q.size(),
            "must be a number for each unknown: " + std::to_string(formulas.unknowns()));
    return visit(formulas,
                 [&](const auto& model) { return f(model, RuntimeModelPoint<double>(q.begin(), sizes_of(model))); });
}

}  // namespace detail

EQUILIBRIA_INLINE RuntimeArray<double> equations_of(const FormulaModel& formulas, const RuntimeArray<double>& q,
                                                    const RuntimeArray<double>& p) {
    return detail::at_unknowns(formulas, q, p, [&](const auto& model, const RuntimeModelPoint<double>& at) {
        RuntimeArray<double> f(q.size());
        equations_at(model, at.theta, at.x, p, f.begin());
        return f;
    });
}
EQUILIBRIA_INLINE RuntimeMatrix<double> jacobian_of(const FormulaModel& formulas, const RuntimeArray<double>& q,
                                                    const RuntimeArray<double>& p) {
    return detail::at_unknowns(formulas, q, p, [&](const auto& model, const RuntimeModelPoint<double>& at) {
        RuntimeArray<double> f(q.size());
        RuntimeMatrix<double> j(q.size());
        equations_and_jacobian(model, at.theta, at.x, p, f.begin(), j[0]);
        return j;
    });
}
EQUILIBRIA_INLINE double potential_of(const FormulaModel& formulas, const RuntimeArray<double>& q,
                                      const RuntimeArray<double>& p) {
    return detail::at_unknowns(formulas, q, p, [&](const auto& model, const RuntimeModelPoint<double>& at) {
        if constexpr (RuntimePotentialModel<std::remove_cvref_t<decltype(model)>>)
            return static_cast<double>(model.potential(at.theta, at.x, p));
        else
            return std::numeric_limits<double>::quiet_NaN();
    });
}
EQUILIBRIA_INLINE PolynomialSystem<double> polynomials_of(const FormulaModel& formulas, const RuntimeArray<double>& p) {
    detail::require_parameters(formulas, p);
    return visit(formulas, [&](const auto& model) {
        const RuntimeFormulation formulation(model);
        const auto terms = formulation.terms(model, p);
        return detail::polynomial_system_of<double>(
            formulation.sizes().angles, formulation.sizes().coordinates, terms,
            [&](int k) { return terms[static_cast<std::size_t>(k)].coefficient; });
    });
}

}  // namespace equilibria
