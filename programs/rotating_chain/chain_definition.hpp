// The definition of what chain.hpp declares, instantiated by units that compile side by side.
#pragma once

#include "rotating_chain/chain.hpp"

#include <complex>
#include <cstddef>
#include <equilibria/certify/refine_root.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/io/results/root_set_output.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

#include "instances/enumerate/chain_enumerations.hpp"
#include "instances/enumerate/chain_proofs.hpp"

namespace {

template <class M>
void add_digits(equilibria::Json& equilibria, const equilibria::RootSet<M>& found, int digits) {
    for (std::size_t k = 0; k < found.equilibria.size(); ++k) {
        const auto& at = found.equilibria[k].q;
        equilibria::Array<std::complex<double>, M::n_angles> q;
        for (int i = 0; i < M::n_angles; ++i) q[i] = at[i];
        const auto refined = equilibria::refine<M>(q, found.parameters, digits);
        equilibria[k]["angles_in_digits"] = equilibria::json_list(refined.real);
        equilibria[k]["digits_proved"] = refined.proved;
        equilibria[k]["digits_error"] = refined.error;
    }
}

}  // namespace

template <int Links>
ChainResult enumerate_chain(const Chain& chain, const Options& options) {
    using Model = equilibria::mechanisms::RotatingChain<Links>;
    equilibria::Parameters<Model> p;
    for (int k = 0; k < Links; ++k) {
        p[Model::length + k] = chain.lengths[static_cast<std::size_t>(k)];
        p[Model::mass + k] = chain.masses[static_cast<std::size_t>(k)];
    }
    p[Model::omega] = chain.omega;
    p[Model::gravity] = chain.gravity;
    const auto found = equilibria::enumerate<Model>(p, {.seed = options.seed,
                                                        .executor = equilibria::threads(options.threads),
                                                        .progress = options.progress,
                                                        .checkpoint = options.checkpoint,
                                                        .cancel = options.cancel});
    ChainResult result{found.paths, equilibria::json_of(found, {.roots = false})};
    auto& out = result.json;
    out["complete"] = false;
    out["reason"] = "nothing was proved: --prove was not given";
    if (options.prove) {
        const auto proof = equilibria::prove(found, {.executor = equilibria::threads(options.threads)});
        equilibria::add_proof(out, proof);
        equilibria::add_certificates(out["equilibria"], proof);
        // names of before
        out["bound"] = proof.bound ? proof.bound->value : 0;
        out["more_digits"] = proof.more_digits;
    }
    if (options.digits > 0) add_digits(out["equilibria"], found, options.digits);
    return result;
}
