#include <equilibria/system/detail/critical_system_definitions.hpp>
#include <equilibria/system/detail/runtime_formulation_definitions.hpp>
#include <equilibria/system/detail/sparse_system_definitions.hpp>
#include <equilibria/system/detail/symmetric_branches_definitions.hpp>
#include <equilibria/system/detail/symmetric_system_definitions.hpp>
