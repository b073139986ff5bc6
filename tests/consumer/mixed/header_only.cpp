#include <equilibria/system/sparse_system.hpp>

int angles_of(const equilibria::SparseSystem& system) { return system.sizes().angles; }
