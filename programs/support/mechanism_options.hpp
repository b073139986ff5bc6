// The holonomic mechanism's parameters from the command line.
#pragma once

#include <equilibria/core/error.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <optional>
#include <string>

#include "options.hpp"

namespace support {

/// A data set, and what replaces its values. All in kg, m, N, s and radians.
class MechanismOptions {
public:
    using Mechanism = equilibria::mechanisms::HolonomicMechanism;
    using Parameters = equilibria::Parameters<Mechanism>;

    /// decay: whether the force may fall in time. `app` must not outlive this.
    MechanismOptions(CommandLine& app, double force, bool decay) : force_(force), with_decay_(decay) {
        app.add_option("--data", data_,
                       "paper (default: g = 9.80665, c2 = 1100/3, which give the paper's digits) or appendix (g = "
                       "9.81, c2 "
                       "= 366.67, to the letter)")
            .transform(one_of({"paper", "appendix"}, "must be paper or appendix"));
        app.add_option("--force", force_, "on M2 along x, N (default " + equilibria::to_text(force) + ")")
            .transform(finite());
        if (decay)
            app.add_option("--decay", decay_, "alpha of the force F exp(-alpha t), 1/s (default 0.7)")
                .transform(not_negative());
        app.add_option("--masses", masses_, "of M1, M2, M3, kg, commas between (default 10,10,10)")
            .transform(positive_list([] { return 3; }));
        app.add_option("--length", length_, "of the rods to M1 and M2, half of that to M3, m (default 1.25)")
            .transform(positive());
        app.add_option("--gravity", gravity_, "m/s^2 (default: of the data set)").transform(finite());
        app.add_option("--c1", stiffness_1_, "stiffness of the spring at M2, N/m (default 162.5)")
            .transform(not_negative());
        app.add_option("--c2", stiffness_2_, "stiffness of the spring at M1, N/m (default: of the data set)")
            .transform(not_negative());
        app.add_option("--damping", damping_, "beta, N s/m (default 121)").transform(not_negative());
    }
    MechanismOptions(const MechanismOptions&) = delete;

    Parameters parameters() const {
        Parameters p = data_ == "paper" ? Mechanism::paper_parameters(force_) : Mechanism::appendix_parameters(force_);
        const auto replace = [&](int k, const std::optional<double>& value) {
            if (value) p[k] = *value;
        };
        for (std::size_t k = 0; k < masses_.values.size(); ++k)
            p[Mechanism::mass_1 + static_cast<int>(k)] = masses_.values[k];
        replace(Mechanism::length, length_);
        replace(Mechanism::gravity, gravity_);
        replace(Mechanism::stiffness_1, stiffness_1_);
        replace(Mechanism::stiffness_2, stiffness_2_);
        replace(Mechanism::damping, damping_);
        if (with_decay_) p[Mechanism::decay] = decay_;
        Mechanism::validate(p);
        return p;
    }
    const std::string& data() const { return data_; }

private:
    std::string data_ = "paper";
    double force_, decay_ = 0.7;
    bool with_decay_;
    List masses_;
    std::optional<double> length_, gravity_, stiffness_1_, stiffness_2_, damping_;
};

}  // namespace support
