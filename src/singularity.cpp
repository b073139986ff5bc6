#include <equilibria/singularity/detail/null_vector_definitions.hpp>
#include <equilibria/singularity/detail/reduced_coefficients_definitions.hpp>
#include <equilibria/singularity/detail/reduced_series_definitions.hpp>
#include <equilibria/singularity/detail/refine_singularity_definitions.hpp>
#include <equilibria/singularity/detail/singularity_evidence_definitions.hpp>
#include <equilibria/singularity/detail/versality_definitions.hpp>

namespace equilibria {

template class Jet<double>;
template ReducedSeries<double> reduced_series(const ModelFunctions<double>&, int, const RuntimeArray<double>&,
                                              const RuntimeArray<double>&, const RuntimeArray<double>&,
                                              const RuntimeArray<double>&);
template ReducedSeries<detail::FourDirections> reduced_series(const ModelFunctions<double>&, int,
                                                              const RuntimeArray<detail::FourDirections>&,
                                                              const RuntimeArray<detail::FourDirections>&,
                                                              const RuntimeArray<detail::FourDirections>&,
                                                              const RuntimeArray<detail::FourDirections>&);
template RuntimeSingularity<double> locate_singularity(const ModelFunctions<double>&, SingularityKind,
                                                       std::span<const int>, const RuntimeArray<double>&,
                                                       const RuntimeArray<double>&,
                                                       const std::optional<RuntimeArray<double>>&);
template RuntimeSingularity<double> refine_singularity(const ModelFunctions<double>&, SingularityKind,
                                                       std::span<const int>, const RuntimeArray<double>&,
                                                       const RuntimeArray<double>&,
                                                       const std::optional<RuntimeArray<double>>&);

}  // namespace equilibria
