/// \file
/// Everything but motion (dynamics/) and structures (fem/), whose headers take as long again; for programs and
/// experiments. A library's own headers include what they use.
#pragma once

/// \namespace equilibria
/// All that is public. What stands in a namespace `detail`, in this one or below, may change without notice.

/// \namespace equilibria::constant_math
/// Elementary functions in constant expressions.

/// \namespace equilibria::fem
/// Structures with large rotations: elements, joints, supports, loads and the problem that they make.

/// \namespace equilibria::mechanisms
/// Ready models, each what a user would have written.

#include <equilibria/algebra/bounds.hpp>
#include <equilibria/algebra/laurent.hpp>
#include <equilibria/algebra/polynomial_system.hpp>
#include <equilibria/certify/refine_root.hpp>
#include <equilibria/continuation/curves/imperfection.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/continuation/generic_problem.hpp>
#include <equilibria/enumerate/enumerate.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/enumerate/stream.hpp>
#include <equilibria/enumerate/torque_trace.hpp>
#include <equilibria/io/gnuplot.hpp>
#include <equilibria/io/polynomial_formats.hpp>
#include <equilibria/locus/line/diagram.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>
#include <equilibria/locus/proof/prove_locus.hpp>
#include <equilibria/locus/proof/prove_region.hpp>
#include <equilibria/locus/space/cusp_locus.hpp>
#include <equilibria/mechanisms/holonomic_mechanism.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/model/derivatives.hpp>
#include <equilibria/singularity/refine_singularity.hpp>
#include <equilibria/stability/inertia.hpp>
#include <equilibria/stability/lagrange_dirichlet.hpp>
#include <equilibria/stability/linearise.hpp>
#include <equilibria/stability/morse.hpp>
#include <equilibria/stability/pole_count.hpp>
#include <equilibria/version.hpp>
