/// \file
/// The kinds of degenerate equilibria that up to four parameters meet, one row a kind:
///
///     A_{k+1}, k parameters    g_1 = .. = g_k = 0: fold, cusp, swallowtail, butterfly
///     B_{k+1}, k parameters    g_1 = g_3 = .. = g_{2k-1} = 0 on a symmetric branch: pitchfork, tricritical,
///                              tetracritical
///     extremal points          of a curve of folds or pitchforks in two parameters, where one of these turns back
///     D_4, three parameters    corank 2: hyperbolic, elliptic umbilic
///     tangencies               a curve of cusps touches a plane z = const: lips, beak-to-beak
///
/// with F(q, p) = 0 each, and g_k the coefficients of the reduced gradient along the null vector (reduced_series.hpp).
/// A kind A or B is refined by its row alone (refine_singularity.hpp); the last two have a system of their own
/// (refine_umbilic.hpp, refine_cusp_tangency.hpp).
/// Sources: Arnold, Gusein-Zade and Varchenko, Singularities of Differentiable Maps I (A_k, D_k; B_k for the symmetric
/// ones); Arnold, Catastrophe Theory, chapter 9 (lips and beak-to-beak).
#pragma once

#include <iterator>

namespace equilibria {

/// The kinds, in the order of their table.
enum class SingularityKind {
    undecided,                ///< not converged, or a coefficient that decides is 0 to rounding: a higher kind
    fold,                     ///< A2
    cusp,                     ///< A3
    swallowtail,              ///< A4
    butterfly,                ///< A5
    hyperbolic_umbilic,       ///< D4+: corank 2, the cubic has one real root line
    elliptic_umbilic,         ///< D4-: corank 2, the cubic has three real root lines
    pitchfork,                ///< B2 of a symmetric branch: phi'' = 0
    tricritical_pitchfork,    ///< B3: phi'' = phi'''' = 0, where a pitchfork turns from super- to subcritical
    tetracritical_pitchfork,  ///< B4: phi'' = phi'''' = phi^(6) = 0, where two mirror-image curves of cusps meet
    extremal_fold,            ///< A2, where a parameter is extremal on the curve of folds
    extremal_pitchfork,       ///< B2, where a parameter is extremal on the curve of pitchforks
    lips,                     ///< A3, two cusps meet as a third parameter moves: the second-order form is definite
    beak_to_beak              ///< the same with an indefinite form: two fold curves meet and reconnect
};

/// A row of the table of kinds.
struct SingularityClass {
    SingularityKind kind;  ///< the kind that the row is of
    const char* name;      ///< in words, unique
    const char* symbol;    ///< Arnold's
    int parameters;        ///< in so many it is an isolated point: its codimension, or one more where it is a tangency
    int corank;            ///< null vectors of J
    bool symmetric;        ///< on a branch that the mirror image theta -> -theta leaves as it is
    int vanishing;  ///< coefficients of the reduced gradient that are 0: g_1, g_2, .., or g_1, g_3, .. if symmetric
    SingularityKind curve;  ///< the curve of a plane of parameters that it is a point of, and ends or turns there
    const char* condition;  ///< what vanishes, beside F

    /// g_order is the last coefficient that vanishes.
    constexpr int order() const { return symmetric ? 2 * vanishing - 1 : vanishing; }
    /// phi^(deciding) is the first derivative of the reduced potential that must not be 0.
    constexpr int deciding() const { return symmetric ? 2 * vanishing + 2 : vanishing + 2; }
    /// Whether refine_singularity finds it by its row.
    constexpr bool by_series() const { return vanishing > 0 && kind != SingularityKind::extremal_pitchfork; }
};

// clang-format off
/// The rows, one for each kind.
inline constexpr SingularityClass singularity_classes[] = {
    {SingularityKind::undecided, "undecided", "", 0, 0, false, 0, SingularityKind::undecided, ""},
    {SingularityKind::fold, "fold", "A2", 1, 1, false, 1, SingularityKind::fold, "phi''"},
    {SingularityKind::cusp, "cusp", "A3", 2, 1, false, 2, SingularityKind::fold, "phi'', phi'''"},
    {SingularityKind::swallowtail, "swallowtail", "A4", 3, 1, false, 3, SingularityKind::fold, "phi'' .. phi''''"},
    {SingularityKind::butterfly, "butterfly", "A5", 4, 1, false, 4, SingularityKind::fold, "phi'' .. phi^(5)"},
    {SingularityKind::hyperbolic_umbilic, "hyperbolic umbilic", "D4+", 3, 2, false, 0, SingularityKind::fold,
     "the reduced 2 x 2 Hessian"},
    {SingularityKind::elliptic_umbilic, "elliptic umbilic", "D4-", 3, 2, false, 0, SingularityKind::fold,
     "the reduced 2 x 2 Hessian"},
    {SingularityKind::pitchfork, "pitchfork", "B2", 1, 1, true, 1, SingularityKind::pitchfork, "phi''"},
    {SingularityKind::tricritical_pitchfork, "tricritical pitchfork", "B3", 2, 1, true, 2, SingularityKind::fold,
     "phi'', phi''''"},
    {SingularityKind::tetracritical_pitchfork, "tetracritical pitchfork", "B4", 3, 1, true, 3, SingularityKind::fold,
     "phi'', phi'''', phi^(6)"},
    {SingularityKind::extremal_fold, "extremal fold", "A2", 2, 1, false, 1, SingularityKind::fold,
     "phi'', v . dF/dp of the other parameter"},
    {SingularityKind::extremal_pitchfork, "extremal pitchfork", "B2", 2, 1, true, 1, SingularityKind::pitchfork,
     "phi'', its derivative by the other parameter"},
    {SingularityKind::lips, "lips", "A3", 3, 1, false, 0, SingularityKind::fold,
     "phi'', phi''', the slope of z on the surface of folds"},
    {SingularityKind::beak_to_beak, "beak-to-beak", "A3", 3, 1, false, 0, SingularityKind::fold,
     "phi'', phi''', the slope of z on the surface of folds"}};
// clang-format on

/// The row of a kind.
constexpr const SingularityClass& class_of(SingularityKind kind) {
    for (const SingularityClass& row : singularity_classes)
        if (row.kind == kind) return row;
    return singularity_classes[0];
}

/// The kind in words, from its row.
constexpr const char* to_string(SingularityKind kind) { return class_of(kind).name; }

/// The kind of the curve in a plane of parameters on which a singularity lies: fold or pitchfork. A tricritical
/// pitchfork lies on one of each, and ends that of folds.
constexpr SingularityKind curve_of(SingularityKind kind) { return class_of(kind).curve; }

}  // namespace equilibria
