// Parameters of a model that nothing but its structure makes special.
#pragma once

#include <equilibria/core/random.hpp>
#include <equilibria/model/model.hpp>

namespace tests {

template <class M>
equilibria::Parameters<M> random_parameters(equilibria::Generator& generator) {
    equilibria::Parameters<M> p;
    for (double& x : p) x = equilibria::uniform(generator, 0.3, 1.7);
    return p;
}

}  // namespace tests
