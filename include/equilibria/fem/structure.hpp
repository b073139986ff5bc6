/// \file
/// A model as a continuation problem: g(q, p) = 0 with q the frames of its nodes and the multipliers of its
/// constraints,
///
///     g = [ V_q + B^T (k lambda + rho Phi) - p f ]       K = [ A    k B^T ]      A = V_qq + rho B^T B
///         [ k Phi                                ]           [ k B  0     ]          + sum (k lambda_i + rho Phi_i)
///         Phi_i,qq
///
/// (Cardona and Huespe 1999, (12)-(15)). Unknowns are increments of the present configuration, x + dx and R exp(dPsi):
/// the reference moves with every iterate (16), tangents and null vectors move along by T (Section 5). So rotations are
/// not limited, and K is symmetric and exact.
///
/// Lengths of increments are root mean squares over the nodes: of displacements over `length`, and of rotations in
/// radians; multipliers hardly count.
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

#include <Eigen/SparseCore>

#include <equilibria/continuation/factorization/symmetric_factors.hpp>
#include <equilibria/core/compiled.hpp>
#include <equilibria/fem/assembly.hpp>
#include <equilibria/fem/structure_model.hpp>
#include <equilibria/fem/symmetry.hpp>
#include <equilibria/run/mutex.hpp>

namespace equilibria::fem {

/// The frames of all nodes, and the multipliers.
struct StructureState {
    std::vector<Frame<double>> frames;  ///< of each node
    Eigen::VectorXd multipliers;        ///< lambda, of each element in turn
};

/// On a node, in fixed axes.
struct NodalForce {
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< by the support on the structure
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< likewise
};

/// How a model is made a problem.
struct StructureOptions {
    double length = 0;            ///< of weights; 0: the diagonal of the box around all nodes
    ConstraintScale scale{0, 0};  ///< of the augmented Lagrangian; 0: the largest stiffness of the other elements
    Executor executor{};          ///< of assembly: serial, or threads(n); does not change the result
    MakeSymmetricFactors factors = nullptr;  ///< of a conservative structure's tangent; null: SparseLDLT
    bool symmetric_images = false;           ///< `images` gives those by the structure's symmetries
    bool first_stage = false;                ///< p brings on what is constant; what is proportional is 0
};

/// Conservative: all elements and loads have an energy, and K is symmetric; else K is taken for unsymmetric.
template <bool Conservative>
class BasicStructure {
public:
    using Configuration = StructureState;            ///< frames and multipliers
    static constexpr bool symmetric = Conservative;  ///< whether K is taken for symmetric

    /// Throws InvalidArgument where nothing can move, where a node may turn about two axes alone, where a load acts on
    /// a component that no element uses, and, for a conservative structure, where an element has no energy or a moment
    /// acts on a node that turns about several axes.
    explicit BasicStructure(Model model, const StructureOptions& options = {});

    const Model& model() const { return *model_; }                ///< as it was given
    const StructureOptions& options() const { return options_; }  ///< with what was chosen where they had a 0
    int size() const { return size_; }                            ///< number of unknowns, multipliers among them
    /// Of the last unknowns.
    int multipliers() const { return multipliers_; }
    /// Of a sparse symmetric K; null: SparseLDLT.
    MakeSymmetricFactors symmetric_factors() const { return options_.factors; }
    /// The number of a component of a node among the unknowns; -1 where it is fixed or no element uses it.
    int unknown(int node, Component c) const { return unknowns_[static_cast<std::size_t>(node)][c]; }
    /// Of the augmented Lagrangian; chosen where the options left a 0.
    const ConstraintScale& scale() const { return options_.scale; }
    double length() const { return options_.length; }  ///< of the weights, chosen where the options left it 0

    /// Without load, as the model was put together.
    Configuration initial() const;

    /// A function of a continuation problem, see problem.hpp and above.
    /// \{
    Eigen::VectorXd residual(const Configuration& q, double p) const;
    Eigen::SparseMatrix<double> tangent(const Configuration& q, double p) const;
    Eigen::VectorXd parameter_derivative(const Configuration& q, double p) const;
    /// \}
    /// 0 where K does not change with p; central differences otherwise.
    Eigen::VectorXd parameter_derivative_along(const Configuration& q, double p, const Eigen::VectorXd& v) const;

    /// A function of a continuation problem, see problem.hpp and above.
    /// \{
    Configuration retract(const Configuration& q, const Eigen::VectorXd& increment) const;
    /// Increments of the frame R exp(Psi) are T(Psi) times those of Psi.
    Eigen::VectorXd transport(const Configuration&, const Eigen::VectorXd& increment, const Eigen::VectorXd& v) const;
    Eigen::VectorXd difference(const Configuration& q, const Configuration& near) const;
    Eigen::VectorXd weights(const Configuration&) const { return weights_; }
    /// \}

    /// Forces and moments on each node that no load and no element balances: those of supports where components are
    /// fixed, and rounding elsewhere. A moment of nodes that share a rotation stands at the one that has it.
    std::vector<NodalForce> support_forces(const Configuration& q, double p) const;
    /// What the elements of a group carry, see element.hpp: call(number of the element, forces).
    void for_each_force(const ElementGroup& group, const Configuration& q, double p, const auto& call) const {
        for (const GroupAssembly& assembly : assemblies_)
            if (&assembly.group() == &group)
                for (std::size_t e = 0; e < group.size(); ++e)
                    call(e, group.forces(e, q.frames.data(), query(assembly, e, q, p, Need::residual)));
    }

    /// Those of symmetries_of the nodes, apart from the identity, that map residuals in generic states onto each other
    /// to 1e-10: elements, supports and loads, at every p. Found at the first call.
    const std::vector<Symmetry>& symmetries() const;
    /// What the symmetry makes of q.
    Configuration image(const Symmetry& symmetry, const Configuration& q) const;
    /// By symmetry k.
    Configuration image(const Configuration& q, std::size_t k) const { return image(symmetries()[k], q); }
    /// By each symmetry; none where they are not asked for (StructureOptions::symmetric_images).
    std::vector<Configuration> images(const Configuration& q) const;

private:
    struct Symmetries {
        equilibria::detail::OnceFlag once;
        std::vector<Symmetry> found;
    };
    static std::size_t node_of(const NodalLoad& load) { return static_cast<std::size_t>(load.node); }
    /// What p makes of loads, and of the elements of a group.
    double factor(LoadKind kind, double p) const { return grows(kind) ? p : options_.first_stage ? 0 : 1; }
    /// Whether p is in its residual.
    bool changes(const ElementGroup& group) const { return group.depends_on_parameter() && grows(group.kind()); }
    /// Whether p is its factor.
    bool grows(LoadKind kind) const { return (kind == LoadKind::constant) == options_.first_stage; }

    /// What is asked of element e at q.
    ElementQuery query(const GroupAssembly& assembly, std::size_t e, const Configuration& q, double p,
                       Need need) const {
        const ElementGroup& group = assembly.group();
        const int m = group.multipliers();
        const double* lambda =
            m == 0 ? nullptr
                   : q.multipliers.data() + assembly.unknowns(e)[group.unknowns() - m] - (size_ - multipliers_);
        return {lambda, factor(group.kind(), p), options_.scale, need};
    }

    /// Three components of a node in a vector of unknowns, 0 where there is none.
    Eigen::Vector3d part(const Eigen::VectorXd& v, int node, Component first) const;
    void set_part(Eigen::VectorXd& v, int node, Component first, const Eigen::Vector3d& value) const;

    /// Adds what becomes of the multipliers; false where elements or residuals are not mapped onto each other.
    bool complete(Symmetry& symmetry) const;
    Configuration generic_state(int number) const;
    Eigen::VectorXd image_of_residual(const Symmetry& symmetry, const Eigen::VectorXd& g) const;

    void number();
    void make_pattern();
    void set_loads();
    void choose_scales();

    template <class Add>
    void assemble(const Configuration& q, double p, Need need, const Add& add) const;
    template <class Add>
    void assemble_group(const GroupAssembly& assembly, const Configuration& q, double p, Need need,
                        const Add& add) const;

    std::shared_ptr<const Model> model_;  // copies share it
    StructureOptions options_;
    int size_ = 0, multipliers_ = 0;
    std::vector<std::array<int, 6>> unknowns_;
    std::vector<std::array<bool, 6>> used_;
    std::vector<GroupAssembly> assemblies_;
    std::vector<NodalLoad> moments_;
    Eigen::SparseMatrix<double> pattern_;
    Eigen::VectorXd proportional_load_, constant_load_, weights_;
    std::shared_ptr<Symmetries> symmetries_ = std::make_shared<Symmetries>();  // copies share it
};

/// Elements and loads with an energy.
using Structure = BasicStructure<true>;
/// Follower loads, and moments on nodes that turn about several axes.
using NonconservativeStructure = BasicStructure<false>;

}  // namespace equilibria::fem

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/fem/detail/structure_definitions.hpp>
#include <equilibria/fem/detail/structure_symmetries_definitions.hpp>
#endif
