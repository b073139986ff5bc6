// The definition of what events.hpp declares, instantiated by units that compile side by side.
#pragma once

#include "equilibrium_events/events.hpp"

#include <chrono>
#include <cmath>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/locus/line/line_events.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>

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

}  // namespace

template <int Links>
ChainEvents chain_events(const Chain& chain, const Options& options) {
    using Model = equilibria::mechanisms::RotatingChain<Links>;
    equilibria::Parameters<Model> p;
    for (int k = 0; k < Links; ++k) {
        p[Model::length + k] = chain.lengths[static_cast<std::size_t>(k)];
        p[Model::mass + k] = chain.masses[static_cast<std::size_t>(k)];
    }
    p[Model::omega] = options.low;
    p[Model::gravity] = chain.gravity;
    equilibria::RunOptions how{.seed = options.seed, .executor = equilibria::threads(options.threads), .progress = options.progress};
    const auto found = equilibria::find_events<Model, Model::omega>(p, options.low, options.high, how);

    ChainEvents result{.events = {},
                       .intervals = {},
                       .paths = found.paths,
                       .attempts = found.attempts,
                       .complex_solutions = found.complex_solutions,
                       .regular_solutions = found.regular_solutions,
                       .pitchfork_paths = found.pitchfork_paths,
                       .other_singular = found.other_singular,
                       .unexplained = found.unexplained,
                       .wrong_tables = found.wrong_tables,
                       .unclean = found.unclean,
                       .complete = found.complete(),
                       .argument = found.argument(),
                       .solve_seconds = found.solve_seconds,
                       .seconds = found.seconds,
                       .proving_seconds = 0};
    for (const auto& e : found.events) {
        ChainEvent event{to_string(e.kind),
                         e.value,
                         {e.q.begin(), e.q.end()},
                         {e.v.begin(), e.v.end()},
                         e.residual,
                         e.correction,
                         e.reduced.third + 0.0,  // -0 becomes 0
                         e.reduced.fourth + 0.0,
                         e.slope + 0.0,
                         {},
                         e.interval};
        for (auto* list : {&event.angles, &event.null_vector})
            for (double& x : *list) x += 0.0;
        if (e.kind == equilibria::CriticalKind::pitchfork)
            event.supercritical = supercritical(chain, e.value, e.slope, e.reduced.fourth);
        result.events.push_back(std::move(event));
    }
    for (const auto& i : found.intervals)
        result.intervals.push_back({i.low, i.high, i.at, i.count, i.by_index, i.clean, {}});
    if (options.prove) {
        const auto begin = std::chrono::steady_clock::now();
        how.progress = nullptr;
        for (ChainInterval& interval : result.intervals) {
            p[Model::omega] = interval.at;
            const auto proof = equilibria::prove(equilibria::enumerate<Model>(p, how), {.executor = equilibria::threads(options.threads)});
            interval.proof = {proof.distinct,
                              proof.real,
                              proof.undecided,
                              proof.index,
                              proof.contradictions,
                              proof.complete,
                              proof.reason,
                              proof.complete && proof.contradictions == 0 && proof.by_index == interval.by_index};
        }
        result.proving_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    }
    return result;
}
