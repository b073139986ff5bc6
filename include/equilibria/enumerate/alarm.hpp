/// \file
/// What tests of completeness say that prove nothing, but betray a lost or a doubled root.
#pragma once

#include <string>

namespace equilibria {

/// The outcome of one test.
struct Alarm {
    bool applied = false;  ///< whether its premises hold: otherwise it says nothing
    double value = 0;      ///< what was measured
    double tolerance = 0;  ///< what |value| may be
    std::string sentence;  ///< what was found, or why the test does not apply

    /// NaN raises it.
    bool raised() const { return applied && !(value <= tolerance && value >= -tolerance); }
};

/// The tests of an enumeration. The first four are done by `enumerate`, the last one by `torque_trace`, on demand.
struct Alarms {
    /// Sum over the real equilibria of (-1)^index, which is 0 on a torus (Poincare-Hopf): angles only, none degenerate.
    Alarm poincare_hopf;
    /// The number of roots whose complex conjugate is not among the roots.
    Alarm conjugates;
    /// The number of roots whose image under theta -> -theta is missing: models with that symmetry.
    Alarm mirror;
    /// The number of roots that another one is closer to than their condition allows two regular roots to be.
    Alarm duplicates;
    /// The largest relative second difference of the sums of z_i and of 1/z_i along a line of torques.
    Alarm trace;

    /// Whether any test raises its alarm.
    bool raised() const {
        return poincare_hopf.raised() || conjugates.raised() || mirror.raised() || duplicates.raised() ||
               trace.raised();
    }
    /// The sentences of the raised ones, "; " between.
    std::string sentences() const {
        std::string all;
        for (const Alarm* a : {&poincare_hopf, &conjugates, &mirror, &duplicates, &trace})
            if (a->raised()) all += (all.empty() ? "" : "; ") + a->sentence;
        return all;
    }
};

}  // namespace equilibria
