/// \file
/// The functions of a model that moves (kinetics.hpp) as an object, its numbers of unknowns and of parameters known at
/// run time: formulations of motion at such sizes are written over it, and compiled once for all models.
#pragma once

#include <Eigen/Core>

#include <equilibria/core/sized_array.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// Energies, forces and mass of a model. q: angles in radians, then coordinates; v: their rates; p: all parameters; t:
/// the time. Vectors and square matrices are by unknowns.
class KineticFunctions {
public:
    virtual ~KineticFunctions() = default;

    const RuntimeSizes& sizes() const { return sizes_; }  ///< numbers of angles and coordinates
    int unknowns() const { return sizes_.unknowns; }      ///< number of entries of q and of v
    int parameters() const { return parameters_; }        ///< number of entries of p

    /// V.
    virtual double potential(const RuntimeArray<double>& q, const RuntimeArray<double>& p) const = 0;
    /// dV/dq.
    virtual Eigen::VectorXd gradient(const RuntimeArray<double>& q, const RuntimeArray<double>& p) const = 0;
    /// d^2 V / dq^2.
    virtual Eigen::MatrixXd hessian(const RuntimeArray<double>& q, const RuntimeArray<double>& p) const = 0;
    /// T.
    virtual double kinetic_energy(const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                  const RuntimeArray<double>& p) const = 0;
    /// dT/dv.
    virtual Eigen::VectorXd momenta(const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                    const RuntimeArray<double>& p) const = 0;
    /// dT/dq at constant v: 1/2 v^T (dM/dq_k) v.
    virtual Eigen::VectorXd kinetic_gradient(const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                             const RuntimeArray<double>& p) const = 0;
    /// v^T Gamma_k v, of Christoffel's symbols of the first kind: (dM/dt) v - dT/dq, what the motion asks of forces
    /// where no rate changes.
    virtual Eigen::VectorXd convective_forces(const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                              const RuntimeArray<double>& p) const = 0;
    /// d Phi / dv of Rayleigh's function; 0 of models without one.
    virtual Eigen::VectorXd dissipation_gradient(const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                                 const RuntimeArray<double>& p) const = 0;
    /// Q; 0 of models without such forces.
    virtual Eigen::VectorXd generalised_forces(double t, const RuntimeArray<double>& q, const RuntimeArray<double>& v,
                                               const RuntimeArray<double>& p) const = 0;
    /// d/dv (d Phi / dv - Q) and dQ/dq, at rest.
    virtual void linearize_forces(double t, const RuntimeArray<double>& q, const RuntimeArray<double>& p,
                                  Eigen::MatrixXd& damping, Eigen::MatrixXd& slope) const = 0;

    /// M = d^2 T / dv^2: column k is the momenta at v = e_k.
    Eigen::MatrixXd mass_matrix(const RuntimeArray<double>& q, const RuntimeArray<double>& p) const {
        Eigen::MatrixXd y(unknowns(), unknowns());
        RuntimeArray<double> unit(unknowns());
        for (int k = 0; k < unknowns(); ++k) {
            unit[k] = 1;
            y.col(k) = momenta(q, unit, p);
            unit[k] = 0;
        }
        return y;
    }

protected:
    /// What sizes() and parameters() return.
    KineticFunctions(const RuntimeSizes& sizes, int parameters) : sizes_(sizes), parameters_(parameters) {}

private:
    RuntimeSizes sizes_;
    int parameters_;
};

}  // namespace equilibria
