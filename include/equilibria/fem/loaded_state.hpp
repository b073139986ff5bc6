/// \file
/// Stages of loading: what is constant comes first, from 0 to 1, and p then begins at 0 from the state that is reached.
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/core/error.hpp>
#include <equilibria/fem/loose_motion.hpp>
#include <equilibria/fem/structure.hpp>

namespace equilibria::fem {

/// The state under all that is constant, at p = 0, and how it was reached.
struct LoadedState {
    StructureState state;  ///< where the first stage ended: the loaded state, if `share` is 1
    double share = 1;      ///< how much of the constant loads acts at the state
    /// Critical points on the way, their kinds and shares of the loads: branches that leave there are not followed.
    std::vector<std::pair<CriticalKind, double>> passed;
    std::vector<std::string> unexplained;  ///< steps whose changes of sign the critical points do not account for
    BranchEnd end = BranchEnd::window;     ///< why the first stage's branch ended

    bool reached() const { return share == 1; }  ///< whether all constant loads act
    /// What is to be said: nothing, or what was passed and where the stage ended.
    std::string summary() const {
        std::string y;
        for (const auto& [kind, at] : passed)
            y += std::string(y.empty() ? "" : ", ") + to_string(kind) + " at " + to_text(at) + " of the constant loads";
        if (!reached())
            y += (y.empty() ? "" : ", ") + std::string("the constant loads are carried up to the share ") +
                 to_text(share) + " alone";
        return y;
    }
};

/// Follows the structure from its drawn state while what is constant grows from 0 to 1, all else being 0. Where the
/// drawn state resists no force in some direction, as a cable net without stress, the stage begins at a small share.
template <bool Conservative>
LoadedState loaded_state(const BasicStructure<Conservative>& structure, ContinuationOptions options = {}) {
    LoadedState y{structure.initial(), 1, {}, {}, BranchEnd::window};
    if (!structure.model().has_constant_loads()) return y;
    StructureOptions first = structure.options();
    first.first_stage = true;
    const BasicStructure<Conservative> stage(structure.model(), first);
    options.range = {0, 1};
    BranchStepper<BasicStructure<Conservative>> stepper(stage, options.stepping());
    y.share = 0;
    for (const double begin : {0.0, 1e-6, 1e-3, 0.1}) {
        if (loose_motion(stage, y.state, begin)) continue;
        const auto start = stepper.start(y.state, begin, 1);
        if (!start) continue;
        const auto branch = follow(stepper, *start, options);
        if (branch.points.empty()) continue;
        for (const auto& event : branch.events) y.passed.emplace_back(event.point.kind, event.point.p);
        for (const auto& step : branch.unexplained) y.unexplained.push_back(step.reason);
        y.end = branch.end;
        // a branch that turns back ends at 0 again: the largest share is what is carried
        const auto most = std::ranges::max_element(branch.points, {}, &BranchPoint<BasicStructure<Conservative>>::p);
        y.state = most->q;
        y.share = most->p;
        break;
    }
    return y;
}

}  // namespace equilibria::fem
