#include <equilibria/enumerate/detail/alarms_definitions.hpp>
#include <equilibria/enumerate/detail/classify_definitions.hpp>
#include <equilibria/enumerate/detail/enumerate_definitions.hpp>
#include <equilibria/enumerate/detail/families_definitions.hpp>
#include <equilibria/enumerate/detail/family_definitions.hpp>
#include <equilibria/enumerate/detail/root_set_definitions.hpp>
#include <equilibria/enumerate/detail/stream_definitions.hpp>
