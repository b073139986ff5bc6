#include <equilibria/core/detail/cholesky_definitions.hpp>
#include <equilibria/core/detail/error_definitions.hpp>
#include <equilibria/core/detail/huge_pages_definitions.hpp>
#include <equilibria/core/detail/sorted_order_definitions.hpp>
#include <equilibria/run/detail/elapsed_definitions.hpp>
#include <equilibria/run/detail/ranks_definitions.hpp>
#include <equilibria/run/detail/threads_definitions.hpp>
