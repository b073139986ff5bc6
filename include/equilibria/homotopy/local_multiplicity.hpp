/// \file
/// The multiplicity of an isolated root, by the dimension of its local dual space.
///
/// Macaulay's matrix holds the coefficients of the Taylor series to the order d and of their products with monomials.
/// Its nullity is the number of differential conditions of order d at most that the ideal fulfils. It grows with d up
/// to the multiplicity of an isolated root, and for ever at a root that is not isolated. Source: B. H. Dayton, Z. Zeng,
/// Computing the multiplicity structure in solving polynomial systems, Proceedings of ISSAC 2005, 116-123.
///
/// Ranks are decided with 64 digits: the root has to be known to about 30 of them. The mean of the roots that this
/// finds next to the point is then computed to 150 digits, by the traces of their multiplication matrices, and the
/// ranks are decided again there: simple roots near to each other are no multiple root. Where terms below 1e-80
/// might keep roots apart these are 400 digits, and where they are below 1e-280, no multiplicity is confirmed.
#pragma once

#include <cstddef>
#include <vector>

#include <equilibria/core/compiled.hpp>
#include <equilibria/homotopy/laurent_column.hpp>
#include <equilibria/homotopy/path_limit.hpp>
#include <equilibria/model/sizes.hpp>

namespace equilibria {

/// What the local dual space says of a point.
struct LocalMultiplicity {
    static constexpr int digits = 150;      ///< with which a multiplicity is confirmed, at least
    static constexpr double zero = 1e-100;  ///< what counts as 0 then, against the terms of an equation
    int multiplicity = 0;                   ///< its dimension; 0: not decided
    int order = 0;                          ///< the order of the series at which the dimension was last seen to grow
    bool grows = false;          ///< the dimension was above `most`, or grew at every order that was looked at
    double smallest_kept = 1;    ///< the smallest pivot that counted, against the terms of an equation
    double largest_dropped = 0;  ///< the largest that did not, or the largest value of an equation at the point
    bool confirmed = false;      ///< the multiplicity is the same with all digits at the mean of the roots
};

/// Multiplicity of the target system (`to` of the columns) at the mean of the points number `level` of these singular
/// limits, which are the ends of as many paths at one root: branches around it, whose mean is nearer to it than they
/// are. most: above this dimension it is not looked at any further.
LocalMultiplicity local_multiplicity(const RuntimeSizes& sizes, const std::vector<LaurentColumn>& columns,
                                     const std::vector<const PathLimit*>& limits, std::size_t level, int most);

}  // namespace equilibria

#ifndef EQUILIBRIA_COMPILED
#include <equilibria/homotopy/detail/local_multiplicity_definitions.hpp>
#endif
