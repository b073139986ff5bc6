/// \file
/// What is done with models, of models that are data (formula/formula_model.hpp): compiled once, so that a program or a
/// package needs no compiler for a model of its own. Arguments, results and errors are those of the functions of the
/// same names for models at run time; parameters are all of the model's, in its order.
#pragma once

#include <array>
#include <functional>

#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/every_equilibrium.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/formula/formula_model.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

/// Which start an enumeration takes.
enum class FormulaStart { least_cost, total_degree, polyhedral };

/// with_more_digits: paths that fail in double are tracked with 50 digits.
RootSet<RuntimeUnknowns> enumerate(const FormulaModel& model, const RuntimeArray<double>& p, const RunOptions& run = {},
                                   FormulaStart start = FormulaStart::least_cost, bool with_more_digits = false);
/// Every equilibrium, proved, with a verdict on their completeness.
EveryEquilibrium every_equilibrium(const FormulaModel& model, const RuntimeArray<double>& p, const RunOptions& run = {},
                                   FormulaStart start = FormulaStart::least_cost);
/// From the roots at other parameters.
RootSet<RuntimeUnknowns> enumerate(const FormulaModel& model, const RootSet<RuntimeUnknowns>& solved,
                                   const RuntimeArray<double>& p, const RunOptions& run = {});
/// As of the functions of the same names for models at run time.
/// \{
ProofOfRoots prove(const FormulaModel& model, const RootSet<RuntimeUnknowns>& set, const RunOptions& run = {},
                   const ProveOptions& options = {});
LineEvents<RuntimeUnknowns> find_events(const FormulaModel& model, const RuntimeArray<double>& p, int active,
                                        const Interval& range, const RunOptions& run = {});
BifurcationDiagram<RuntimeUnknowns> trace_diagram(const FormulaModel& model, const RuntimeArray<double>& p, int active,
                                                  const Interval& range, const RunOptions& run = {},
                                                  const BranchOptions& branch = diagram_steps);
/// \}
/// active: the numbers of the parameters x and y.
Locus<RuntimeUnknowns> trace_locus(const FormulaModel& model, const RuntimeArray<double>& p,
                                   const std::array<int, 2>& active, const Window& window, const RunOptions& run = {},
                                   const LocusOptions& options = {});
/// As of the function of the same name for models at run time.
SweepCounts sweep(const FormulaModel& model, const ParameterPoints& points,
                  const std::function<void(const SweptPoint&)>& take, const RunOptions& run = {},
                  const SweepOptions& options = {});

/// The equations at these unknowns (angles in radians, then coordinates).
RuntimeArray<double> equations_of(const FormulaModel& model, const RuntimeArray<double>& q,
                                  const RuntimeArray<double>& p);
/// Their Jacobian, n rows of n entries.
RuntimeMatrix<double> jacobian_of(const FormulaModel& model, const RuntimeArray<double>& q,
                                  const RuntimeArray<double>& p);
/// The potential there; NaN of a model without one.
double potential_of(const FormulaModel& model, const RuntimeArray<double>& q, const RuntimeArray<double>& p);

/// The equations as polynomials in the cosine c_i and the sine s_i of each angle, with c_i^2 + s_i^2 = 1 for each, and
/// in the coordinates: what other solvers read (io/polynomial_formats.hpp).
PolynomialSystem<double> polynomials_of(const FormulaModel& model, const RuntimeArray<double>& p);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/studies/formula_model/detail/formula_searches_definitions.hpp>
#endif
