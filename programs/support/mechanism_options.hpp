// The holonomic mechanism's parameters from the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <string>

#include "fail.hpp"
#include "numbers.hpp"

namespace support {

/// A data set, and what replaces its values. All in kg, m, N, s and radians.
class MechanismOptions {
public:
    using Mechanism = equilibria::mechanisms::HolonomicMechanism;
    using Parameters = equilibria::Parameters<Mechanism>;

    /// decay: whether the force may fall in time.
    MechanismOptions(CLI::App& app, std::string force, bool decay) : app_(&app), force_(std::move(force)) {
        app.add_option(
            "--data", data_,
            "paper (default: g = 9.80665, c2 = 1100/3, which give the paper's digits) or appendix (g = 9.81, c2 "
            "= 366.67, to the letter)");
        app.add_option("--force", force_, "on M2 along x, N (default " + force_ + ")");
        if (decay)
            app.add_option("--decay", decay_, "alpha of the force F exp(-alpha t), 1/s (default " + decay_ + ")");
        app.add_option("--masses", masses_, "of M1, M2, M3, kg, commas between (default 10,10,10)");
        app.add_option("--length", length_, "of the rods to M1 and M2, half of that to M3, m (default 1.25)");
        app.add_option("--gravity", gravity_, "m/s^2 (default: of the data set)");
        app.add_option("--c1", stiffness_1_, "stiffness of the spring at M2, N/m (default 162.5)");
        app.add_option("--c2", stiffness_2_, "stiffness of the spring at M1, N/m (default: of the data set)");
        app.add_option("--damping", damping_, "beta, N s/m (default 121)");
    }

    /// Ends the program with one line where a value is wrong.
    Parameters parameters() const {
        if (data_ != "paper" && data_ != "appendix") fail("--data", shown(data_), "must be paper or appendix");
        const auto any = [](double) { return true; };
        const double force = number("--force", force_, "must be a finite number", any);
        Parameters p = data_ == "paper" ? Mechanism::paper_parameters(force) : Mechanism::appendix_parameters(force);
        const auto replace = [&](const char* option, const std::string& text, int k, bool positive) {
            if (app_->count(option) > 0)
                p[k] = number(option, text, positive ? "must be a positive number" : "must be a number, 0 or more",
                              [&](double x) { return positive ? x > 0 : x >= 0; });
        };
        if (app_->count("--masses") > 0) {
            const auto masses = positive_list("--masses", masses_, 3);
            p[Mechanism::mass_1] = masses[0], p[Mechanism::mass_2] = masses[1], p[Mechanism::mass_3] = masses[2];
        }
        replace("--length", length_, Mechanism::length, true);
        replace("--c1", stiffness_1_, Mechanism::stiffness_1, false);
        replace("--c2", stiffness_2_, Mechanism::stiffness_2, false);
        replace("--damping", damping_, Mechanism::damping, false);
        if (app_->count("--gravity") > 0)
            p[Mechanism::gravity] = number("--gravity", gravity_, "must be a finite number", any);
        if (app_->get_option_no_throw("--decay"))
            p[Mechanism::decay] =
                number("--decay", decay_, "must be a number, 0 or more", [](double x) { return x >= 0; });
        Mechanism::validate(p);
        return p;
    }
    const std::string& data() const { return data_; }

private:
    CLI::App* app_;
    std::string data_ = "paper", force_, decay_ = "0.7", masses_, length_, gravity_, stiffness_1_, stiffness_2_,
                damping_;
};

}  // namespace support
