#include <complex>

#include <equilibria/algebra/runtime_scalar.hpp>
#include <equilibria/start/detail/coefficient_path_definitions.hpp>
#include <equilibria/start/detail/linear_product_definitions.hpp>
#include <equilibria/start/detail/solved_instance_definitions.hpp>
#include <equilibria/start/detail/total_degree_start_definitions.hpp>
#include <equilibria/start/detail/total_degree_system_definitions.hpp>
#include <equilibria/system/detail/critical_system_definitions.hpp>
#include <equilibria/system/detail/laurent_terms_definitions.hpp>
#include <equilibria/system/detail/mixed_volumes_definitions.hpp>
#include <equilibria/system/detail/path_bounds_definitions.hpp>
#include <equilibria/system/detail/runtime_formulation_definitions.hpp>
#include <equilibria/system/detail/sparse_system_definitions.hpp>
#include <equilibria/system/detail/symmetric_branches_definitions.hpp>
#include <equilibria/system/detail/symmetric_system_definitions.hpp>
#include <equilibria/system/detail/system_family_definitions.hpp>
#include <equilibria/system/detail/unit_scaling_definitions.hpp>

namespace equilibria {

template class RuntimePool<double>;
template class RuntimeScalar<double>;
template class RuntimeAngle<double>;
template class RuntimePool<std::complex<double>>;
template class RuntimeScalar<std::complex<double>>;
template class RuntimeAngle<std::complex<double>>;

}  // namespace equilibria
