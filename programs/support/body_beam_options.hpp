// The rotating body with a beam from the command line.
#pragma once

#include <cstddef>
#include <equilibria/model/model.hpp>
#include <sstream>
#include <string>

#include "options.hpp"

namespace support {

/// The parameters of mechanisms::RotatingBodyBeam but for the speed, in any consistent units with line density 1 of the
/// beam, and which of its models.
struct BodyBeamOptions {
    static constexpr int most_modes = 4;

    double body_mass = 2;
    List inertia{{1.2, 1.3, 0.8}}, centre{{0, 0, 0}};
    double length = 1;
    List mu{{1, 1.2, 100}};
    int modes = 2;  ///< a direction
    std::string strain = "linear";

    bool coupled() const { return strain == "coupled"; }
};

inline Rule three_numbers() { return list("must be 3 finite numbers, with commas between", 3); }

/// Three principal moments of some body.
inline Rule moments() {
    return [](std::string& text) {
        List l;
        if (!lexical_cast(text, l) || l.values.size() != 3) return std::string();
        const double sum = l.values[0] + l.values[1] + l.values[2];
        bool good = true;
        for (const double moment : l.values) good = good && moment <= sum - moment;
        return verdict(good, text, "must be moments of which none is larger than the sum of the others");
    };
}

/// `options` must outlive the parsing.
inline void add_body_beam_options(CommandLine& app, BodyBeamOptions& options) {
    const auto three = [] { return 3; };
    app.add_option("--body-mass", options.body_mass, "mass of the rigid body; the beam's is its length (default 2)")
        .transform(positive());
    app.add_option(
           "--inertia", options.inertia,
           "principal moments of the rigid body about the point where the beam is clamped (default 1.2,1.3,0.8)")
        .transform(moments())
        .transform(positive_list(three));
    app.add_option("--centre", options.centre, "the rigid body's centre of mass (default 0,0,0)")
        .transform(three_numbers());
    app.add_option("--length", options.length, "of the beam, which lies along the third axis (default 1)")
        .transform(positive());
    app.add_option("--mu", options.mu,
                   "stiffnesses mu_1, mu_2 (bending along the axes 1 and 2) and mu_3 (stretching) (default 1,1.2,100)")
        .transform(positive_list(three));
    app.add_option("--modes", options.modes, "of the beam in each direction, 1 to 4 (default 2)")
        .transform(integer(1, BodyBeamOptions::most_modes));
    app.add_option("--strain", options.strain, "energy: linear (default), or coupled, with centrifugal stiffening")
        .transform(one_of({"linear", "coupled"}, "must be linear or coupled"));
}

/// Ends the program with one line unless there is such a body: its inertia about its own centre of mass must be
/// positive definite. What only asks for relative equilibria can do without.
inline void check_body_beam(const BodyBeamOptions& o) {
    const auto &i = o.inertia.values, &c = o.centre.values;
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
        p[M::inertia_1 + k] = options.inertia.values[at];
        p[M::centre_1 + k] = options.centre.values[at];
        p[M::bending_1 + k] = options.mu.values[at];
    }
    p[M::length] = options.length;
    p[M::speed] = speed;
    M::validate(p);
    return p;
}

}  // namespace support
