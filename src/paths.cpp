#include <equilibria/homotopy/detail/polynomial_homotopy_definitions.hpp>
#include <equilibria/paths/detail/coincidence_definitions.hpp>
#include <equilibria/paths/detail/complex_roots_definitions.hpp>
#include <equilibria/paths/detail/merge_definitions.hpp>
#include <equilibria/paths/detail/path_set_definitions.hpp>
#include <equilibria/paths/detail/track_definitions.hpp>
#include <equilibria/storage/detail/checkpoint_fields_definitions.hpp>
