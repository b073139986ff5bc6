#include <equilibria/algebra/runtime_scalar.hpp>

namespace equilibria {

template class RuntimePool<double>;
template class RuntimeScalar<double>;
template class RuntimeAngle<double>;

}  // namespace equilibria
