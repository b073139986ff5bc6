/// \file
/// The relative equilibria of a body with a beam as one parametric polynomial system, for homotopies in its parameters.
/// See rotating_body_beam.hpp for the body, and body_beam_solver.hpp for what follows its members.
#pragma once

#include <cmath>
#include <type_traits>

#include <equilibria/core/array.hpp>
#include <equilibria/core/random.hpp>
#include <equilibria/studies/rotating_body_beam/rotating_body_beam.hpp>

namespace equilibria::mechanisms {

/// Relative equilibria at a given speed or a given momentum, as members of one parametric polynomial system: what is
/// solved once, at generic parameters, is followed to the others. The strain energy is BeamStrain::either.
///
/// At a given momentum A: critical points of V(u) - w^T J(u) w / 2 + lambda (|w|^2 - omega^2) / 2 + A omega over the
/// angular velocity w, u, lambda and omega: J w = lambda w, |w| = omega, lambda omega = A. At a given speed omega:
/// without the last term. Unknowns: w (3), u (3 K), lambda, and at a given momentum omega. (RotatingBodyBeam has n = w
/// / omega instead: its complex solutions are far out where omega is small.) Total degree: 1,458 with one mode a
/// direction, 27 times as much with another, and twice as much at a given momentum.
///
/// second_axis: 1. With 0 the second component of the axis is 0 instead: a body with mu_1 = mu_2, equal moments about
/// the first two axes and its centre of mass on the third turns any axis into that plane, where its circles of
/// equilibria become points. (A circle has four there: n, -n, and their turns by pi. Where the axis is the third one,
/// only solutions with J n = lambda n are equilibria: the second component of that equation has been left out, and
/// follows from the others elsewhere.)
template <int K, BeamControl Control>
struct BodyBeamEitherStrain : RotatingBodyBeamBase<K, BeamStrain::either> {
    using Base = RotatingBodyBeamBase<K, BeamStrain::either>;        ///< names the parameters
    static constexpr bool at_speed = Control == BeamControl::speed;  ///< the speed is given, not the momentum
    static constexpr int n_angles = 0;                               ///< no angles
    static constexpr int n_coordinates =
        at_speed ? 4 + 3 * K : 5 + 3 * K;         ///< w, u, lambda; omega too at a given momentum
    static constexpr int first_mode = 3;          ///< place of u among the coordinates
    static constexpr int multiplier = 3 + 3 * K;  ///< place of lambda
    static constexpr int omega = multiplier + 1;  ///< place of omega, at a given momentum

    /// The function whose critical points are the equilibria.
    constexpr auto potential(const auto&, const auto& x, const auto& p) const {
        using S = std::remove_cvref_t<decltype(x[0] * p[0])>;
        const S share(p[Base::second_axis]);
        const Array<S, 3> w{S(x[0]), share * x[1], S(x[2])};
        Array<S, 3 * K> u;
        for (int i = 0; i < u.size(); ++i) u[i] = S(x[first_mode + i]);
        const S energy = Base::strain_energy(u, p) + 0.5 * (1.0 - share) * x[1] * x[1];
        S square{};
        for (int i = 0; i < 3; ++i) square += w[i] * w[i];
        const S form = detail::quadratic_form(Base::inertia(u, p), w);
        if constexpr (at_speed)
            return energy - 0.5 * (form - (square - p[Base::speed] * p[Base::speed]) * x[multiplier]);
        else
            return energy - 0.5 * (form - (square - x[omega] * x[omega]) * x[multiplier]) +
                   p[Base::momentum] * x[omega];
    }

    /// A member with nothing special about its stiffnesses, moments, speed and momentum, at which the enumeration is
    /// well conditioned, with the length 1 and else the body of p. (The speed is between the first and the second
    /// frequencies of the beam alone: next to one of them roots are far out.) On the
    /// way from here to a beam of the same body all systems are members, by a line in the space of coefficients, since
    /// only those enter them linearly, or along an arc of the parameters: its relative equilibria are ends of paths
    /// from this one's. To another body there is the arc alone: on a line lie systems that are no beams.
    static Array<double, Base::n_parameters> generic(const Array<double, Base::n_parameters>& p, Generator& generator) {
        auto y = p;
        const double values[] = {1.2, 1.3, 0.8, 0.05, 0.06, 0.3, 1.5, 1.5};
        const int places[] = {Base::inertia_1, Base::inertia_2,  Base::inertia_3, Base::bending_1,
                              Base::bending_2, Base::stretching, Base::speed,     Base::momentum};
        for (int k = 0; k < 8; ++k) y[places[k]] = values[k] * uniform(generator, 0.9, 1.1);
        return y;
    }

    /// A body in other units of length and time, and the factors that lead back.
    struct Units {
        Array<double, Base::n_parameters> scaled;  ///< the parameters in these units
        double modes;                              ///< modes at p over those in these units
        double speed;                              ///< the same of speeds
        double moments;                            ///< the same of moments of inertia

        double momentum() const { return moments * speed; }  ///< the same of angular momenta
    };
    /// Units of a positive length and time, given in those of p.
    static Units units(const Array<double, Base::n_parameters>& p, double length, double time) {
        const double l = length, l3 = l * l * l, time2 = time * time;
        auto y = p;
        y[Base::length] /= l;
        y[Base::body_mass] /= l;
        for (int k = 0; k < 3; ++k) {
            y[Base::inertia_1 + k] /= l3;
            y[Base::centre_1 + k] /= l;
        }
        y[Base::bending_1] *= time2 / (l * l3);
        y[Base::bending_2] *= time2 / (l * l3);
        y[Base::stretching] *= time2 / (l * l);
        y[Base::speed] *= time;
        y[Base::momentum] *= time / l3;
        return {y, l * std::sqrt(l), 1 / time, l3};
    }
    /// The units that suit p, whose length and bending stiffnesses are positive: in them the length is 1 and the
    /// stiffnesses are near those of the generic member.
    static Units units(const Array<double, Base::n_parameters>& p) {
        const double l = p[Base::length];
        return units(p, l, std::sqrt(0.055 * l * l * l * l / std::sqrt(p[Base::bending_1] * p[Base::bending_2])));
    }
};

}  // namespace equilibria::mechanisms
