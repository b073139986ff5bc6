// The definition of what events.hpp declares, instantiated by units that compile side by side.
#pragma once

#include "equilibrium_events/events.hpp"

#include <chrono>
#include <cmath>
#include <cstddef>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/io/results/line_events_output.hpp>
#include <equilibria/io/results/proof_output.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <optional>

#include "instances/enumerate/chain_proofs.hpp"
#include "instances/locus/chain_events.hpp"

namespace {

/// Whether a pitchfork is supercritical: its pair lives where the branch has one more negative eigenvalue. The energy
/// along the null vector is slope (omega - omega_c) x^2 / 2 + fourth x^4 / 24. Nothing where one of them is next to 0.
std::optional<bool> supercritical(const Chain& chain, double omega, double slope, double fourth) {
    double size = 0, reach = 0;
    for (std::size_t k = 0; k < chain.lengths.size(); ++k) {
        reach += chain.lengths[k];
        size += chain.masses[k] * reach * (chain.gravity + omega * omega * reach);
    }
    if (!(std::abs(fourth) > 1e-9 * size && std::abs(slope) * omega > 1e-9 * size)) return {};
    return fourth > 0;
}

/// The equilibria in the middle of each interval, proved.
template <class Model>
void add_proofs(equilibria::Json& out, const equilibria::LineEvents<Model>& found, equilibria::Parameters<Model> p,
                const equilibria::RunOptions& how) {
    const auto begin = std::chrono::steady_clock::now();
    for (std::size_t k = 0; k < found.intervals.size(); ++k) {
        const auto& interval = found.intervals[k];
        p[Model::omega] = interval.at;
        const auto proof = equilibria::prove(equilibria::enumerate<Model>(p, how), {.executor = how.executor});
        auto& json = out["intervals"][k]["proof"] = equilibria::json_of(proof);
        json["proved"] = proof.complete && proof.contradictions == 0 && proof.by_index == interval.by_index;
    }
    out["proving_seconds"] = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

}  // namespace

template <int Links>
equilibria::Json chain_events(const Chain& chain, const Options& options) {
    using Model = equilibria::mechanisms::RotatingChain<Links>;
    equilibria::Parameters<Model> p;
    for (int k = 0; k < Links; ++k) {
        p[Model::length + k] = chain.lengths[static_cast<std::size_t>(k)];
        p[Model::mass + k] = chain.masses[static_cast<std::size_t>(k)];
    }
    p[Model::omega] = options.low;
    p[Model::gravity] = chain.gravity;
    equilibria::RunOptions how{
        .seed = options.seed, .executor = equilibria::threads(options.threads), .progress = options.progress};
    const auto found = equilibria::find_events<Model, Model::omega>(p, {options.low, options.high}, how);

    auto out = equilibria::json_of(found, "omega");
    for (std::size_t k = 0; k < found.events.size(); ++k) {
        const auto& e = found.events[k];
        if (e.kind != equilibria::CriticalKind::pitchfork) continue;
        if (const auto so = supercritical(chain, e.value, e.slope, e.reduced.fourth))
            out["events"][k]["supercritical"] = *so;
    }
    how.progress = nullptr;
    if (options.prove) add_proofs<Model>(out, found, p, how);
    return out;
}
