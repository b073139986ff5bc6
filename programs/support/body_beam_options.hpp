// The rotating body with a beam from the command line.
#pragma once

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstddef>
#include <equilibria/model/model.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "fail.hpp"
#include "numbers.hpp"

namespace support {

/// The parameters of mechanisms::RotatingBodyBeam but for the speed, in any consistent units with line density 1 of the
/// beam, and which of its models.
struct BodyBeamOptions {
    static constexpr int most_modes = 4;

    double body_mass = 2;
    std::vector<double> inertia{1.2, 1.3, 0.8}, centre{0, 0, 0};
    double length = 1;
    std::vector<double> mu{1, 1.2, 100};
    int modes = 2;  ///< a direction
    std::string strain = "linear";

    bool coupled() const { return strain == "coupled"; }
};

/// Three finite numbers with commas between, all positive where `positive`.
inline std::vector<double> three_numbers(const std::string& option, const std::string& text, bool positive) {
    std::vector<double> y;
    for (std::size_t at = 0; at <= text.size();) {
        const std::size_t comma = std::min(text.find(',', at), text.size());
        const auto value = parsed_number(text.substr(at, comma - at), [&](double x) { return !positive || x > 0; });
        if (!value) break;
        y.push_back(*value);
        at = comma + 1;
        if (comma == text.size() && y.size() == 3) return y;
    }
    fail(
        option, shown(text),
        positive ? "must be 3 positive numbers, with commas between" : "must be 3 finite numbers, with commas between");
}

/// Each option is checked where CLI11 meets it: a wrong one ends the program with one line. `options` must outlive the
/// parsing.
inline void add_body_beam_options(CLI::App& app, BodyBeamOptions& options) {
    auto* const o = &options;
    const auto add = [&](const char* name, auto&& set, const char* text) {
        app.add_option_function<std::string>(name, set, text);
    };
    const auto positive = [](double x) { return x > 0; };
    add(
        "--body-mass",
        [o, positive](const std::string& text) {
            o->body_mass = number("--body-mass", text, "must be a positive number", positive);
        },
        "mass of the rigid body; the beam's is its length (default 2)");
    add(
        "--inertia",
        [o](const std::string& text) {
            o->inertia = three_numbers("--inertia", text, true);
            const double sum = o->inertia[0] + o->inertia[1] + o->inertia[2];
            for (const double moment : o->inertia)
                if (moment > sum - moment)
                    fail("--inertia", text, "must be moments of which none is larger than the sum of the others");
        },
        "principal moments of the rigid body about the point where the beam is clamped (default 1.2,1.3,0.8)");
    add(
        "--centre", [o](const std::string& text) { o->centre = three_numbers("--centre", text, false); },
        "the rigid body's centre of mass (default 0,0,0)");
    add(
        "--length",
        [o, positive](const std::string& text) {
            o->length = number("--length", text, "must be a positive number", positive);
        },
        "of the beam, which lies along the third axis (default 1)");
    add(
        "--mu", [o](const std::string& text) { o->mu = three_numbers("--mu", text, true); },
        "stiffnesses mu_1, mu_2 (bending along the axes 1 and 2) and mu_3 (stretching) (default 1,1.2,100)");
    add(
        "--modes",
        [o](const std::string& text) { o->modes = integer("--modes", text, 1, BodyBeamOptions::most_modes); },
        "of the beam in each direction, 1 to 4 (default 2)");
    add(
        "--strain",
        [o](const std::string& text) {
            if (text != "linear" && text != "coupled") fail("--strain", shown(text), "must be linear or coupled");
            o->strain = text;
        },
        "energy: linear (default), or coupled, with centrifugal stiffening");
}

/// Ends the program with one line unless there is such a body: its inertia about its own centre of mass must be
/// positive definite. What only asks for relative equilibria can do without.
inline void check_body_beam(const BodyBeamOptions& o) {
    const auto &i = o.inertia, &c = o.centre;
    // the leading minors of diag(inertia) - mass (|c|^2 - c c^T)
    const double square = c[0] * c[0] + c[1] * c[1] + c[2] * c[2];
    const auto entry = [&](std::size_t a, std::size_t b) {
        return (a == b ? i[a] - o.body_mass * square : 0) + o.body_mass * c[a] * c[b];
    };
    const auto minor = [&](std::size_t a, std::size_t b) {
        return entry(a, a) * entry(b, b) - entry(a, b) * entry(a, b);
    };
    const double determinant = entry(0, 0) * minor(1, 2) -
                               entry(0, 1) * (entry(0, 1) * entry(2, 2) - entry(1, 2) * entry(0, 2)) +
                               entry(0, 2) * (entry(0, 1) * entry(1, 2) - entry(1, 1) * entry(0, 2));
    if (entry(0, 0) > 0 && minor(0, 1) > 0 && determinant > 0) return;
    std::ostringstream text;
    text << c[0] << ',' << c[1] << ',' << c[2];
    fail("--centre", text.str(),
         "must be where the inertia about it, --inertia less the share of --body-mass, is positive definite");
}

/// The parameters of the model M, some mechanisms::RotatingBodyBeam, at an angular speed.
template <class M>
equilibria::Parameters<M> body_beam_parameters(const BodyBeamOptions& options, double speed) {
    equilibria::Parameters<M> p;
    p[M::body_mass] = options.body_mass;
    for (int k = 0; k < 3; ++k) {
        const auto at = static_cast<std::size_t>(k);
        p[M::inertia_1 + k] = options.inertia[at];
        p[M::centre_1 + k] = options.centre[at];
        p[M::bending_1 + k] = options.mu[at];
    }
    p[M::length] = options.length;
    p[M::speed] = speed;
    M::validate(p);
    return p;
}

}  // namespace support
