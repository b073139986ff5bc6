// The shallow arch of programs/support/structures.hpp by its energy, generic over scalars.
#pragma once

#include <Eigen/Core>

struct ArchEnergy {
    double l;
    template <class T>
    T energy(const Eigen::VectorX<T>& a, const T& p) const {
        const T bend = a(0) - l, stretch = a(0) * a(0) + 4 * a(1) * a(1) - l * l;
        return 0.5 * bend * bend + 8 * a(1) * a(1) + 0.25 * stretch * stretch + p * a(0);
    }
};
