/// \file
/// See dynamics/dense_output_integrator.hpp.
#pragma once

#include <functional>
#include <memory>

#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_dense_output_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation/generation_runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/generation/make_dense_output.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>

#include <equilibria/dynamics/dense_output_integrator.hpp>

namespace equilibria {

struct DenseOutputIntegrator::Pair {
    using DormandPrince = boost::numeric::odeint::runge_kutta_dopri5<State>;

    explicit Pair(const MotionOptions& options)
        : stepper(boost::numeric::odeint::make_dense_output(options.absolute_tolerance, options.relative_tolerance,
                                                            options.largest_step, DormandPrince())) {}
    boost::numeric::odeint::result_of::make_dense_output<DormandPrince>::type stepper;
};

EQUILIBRIA_INLINE DenseOutputIntegrator::DenseOutputIntegrator(const MotionOptions& options) {
    options.validate();
    pair_ = std::make_unique<Pair>(options);
}
EQUILIBRIA_INLINE DenseOutputIntegrator::DenseOutputIntegrator(const DenseOutputIntegrator& other)
    : pair_(std::make_unique<Pair>(*other.pair_)) {}
EQUILIBRIA_INLINE DenseOutputIntegrator::DenseOutputIntegrator(DenseOutputIntegrator&&) noexcept = default;
EQUILIBRIA_INLINE DenseOutputIntegrator& DenseOutputIntegrator::operator=(const DenseOutputIntegrator& other) {
    return *this = DenseOutputIntegrator(other);
}
EQUILIBRIA_INLINE DenseOutputIntegrator& DenseOutputIntegrator::operator=(DenseOutputIntegrator&&) noexcept = default;
EQUILIBRIA_INLINE DenseOutputIntegrator::~DenseOutputIntegrator() = default;

EQUILIBRIA_INLINE void DenseOutputIntegrator::initialize(const State& y, double t, double step) {
    pair_->stepper.initialize(y, t, step);
}

EQUILIBRIA_INLINE bool DenseOutputIntegrator::step(const Rates& rates) {
    try {
        pair_->stepper.do_step(std::cref(rates));
    } catch (const boost::numeric::odeint::odeint_error&) {
        return false;
    }
    return true;
}

EQUILIBRIA_INLINE double DenseOutputIntegrator::time() const { return pair_->stepper.current_time(); }
EQUILIBRIA_INLINE const DenseOutputIntegrator::State& DenseOutputIntegrator::state() const {
    return pair_->stepper.current_state();
}
EQUILIBRIA_INLINE double DenseOutputIntegrator::time_step() const { return pair_->stepper.current_time_step(); }
EQUILIBRIA_INLINE void DenseOutputIntegrator::interpolate(double t, State& y) const { pair_->stepper.calc_state(t, y); }

}  // namespace equilibria
