// What follows branches of problems of any type, compiled for tangents of the type Tangent, which is the includer's.
#include <optional>
#include <vector>

#include <equilibria/continuation/detail/branch_definitions.hpp>
#include <equilibria/continuation/detail/branch_images_definitions.hpp>
#include <equilibria/continuation/detail/branch_stepper_definitions.hpp>
#include <equilibria/continuation/detail/check_derivatives_definitions.hpp>
#include <equilibria/continuation/detail/corrector_definitions.hpp>
#include <equilibria/continuation/detail/critical_point_definitions.hpp>
#include <equilibria/continuation/detail/event_function_definitions.hpp>
#include <equilibria/continuation/detail/events_definitions.hpp>
#include <equilibria/continuation/detail/step_correction_definitions.hpp>
#include <equilibria/continuation/diagrams/detail/branch_graph_definitions.hpp>
#include <equilibria/continuation/diagrams/detail/deflation_definitions.hpp>

namespace equilibria {

using Problem = AnyProblem<Tangent>;
using Stepper = AnyBranchStepper<Tangent>;
using Point = BranchPoint<Erased>;
using Configurations = std::vector<AnyConfiguration>;
using Functions = std::vector<EventFunction<Erased>>;

template class AnyBranchStepper<Tangent>;
template class detail::Corrector<Tangent>;
template DerivativeErrors check_derivatives(const Problem&, const AnyConfiguration&, double, double);
template Correction correct_at(const Problem&, AnyConfiguration&, double, const CorrectionOptions&);
template std::optional<CriticalPoint<Erased>> critical_point_near(const Problem&, const AnyConfiguration&, double,
                                                                  const CriticalPointOptions&, Border,
                                                                  BorderedSolver<Tangent>*, const Eigen::VectorXd&,
                                                                  bool);
template std::optional<Point> zero_between(Stepper&, const EventFunction<Erased>&, const Point&, const Point&);
template StepEvents<Erased> events_between(Stepper&, const CriticalPointOptions&, const Point&, const Point&);
template Branch<Erased> follow(Stepper&, const Point&, const ContinuationOptions&, const Functions&);
template Branch<Erased> continue_branch(const Problem&, const AnyConfiguration&, double, int,
                                        const ContinuationOptions&, const Functions&);
template bool lies_on(Stepper&, const Branch<Erased>&, const Point&);
template Branch<Erased> image_of(Stepper&, const Branch<Erased>&, std::size_t, const Functions&);
template std::optional<Branch<Erased>> known_image(Stepper&, const Branch<Erased>&, const Point&, const Functions&);
template std::vector<Point> switch_branch(Stepper&, const CriticalPoint<Erased>&, const Direction&, double);
template std::optional<AnyConfiguration> deflated_newton(const Problem&, double, AnyConfiguration,
                                                         const Configurations&, const DeflationOptions&);
template Configurations deflated_search(const Problem&, double, const Configurations&, Configurations,
                                        const DeflationOptions&);
template BranchGraph<Erased> bifurcation_diagram(const Problem&, const AnyConfiguration&, double,
                                                 const DiagramOptions&);

}  // namespace equilibria
