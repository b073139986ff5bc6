// Structures with known critical points: the numbered cases of docs/finite-rotations.md. The tests of fem/ use them
// too.
#pragma once

#include <equilibria/continuation/branch.hpp>
#include <equilibria/fem/structure.hpp>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace support {

using equilibria::fem::Structure;
using equilibria::fem::StructureState;

/// Data of a case that may be changed; what is not given is the case's own.
struct CaseData {
    std::optional<double> ei2, ei3, gj, ea, ga, angle, tension, rise;
    std::string load_direction = "+x";  ///< of the right-angle frame: +x, -x, +y or -y
    std::string load;                   ///< of the ring: hydrostatic, fixed or central; of the dome: ring or apex
    std::string ends = "cantilever";    ///< of the column: cantilever, hinged, clamped or clamped-hinged
    int links = 3;                      ///< of the chain
    int elements = 32;                  ///< of the structure, shared among its members by length
    int nodes = 4;                      ///< of each element: 2, 3 or 4
    unsigned threads = 1;               ///< of assembly
};

/// A place on a branch that is asked for: where `value` is 0.
struct CasePoint {
    std::string name;
    std::function<double(const StructureState&, double)> value;
};

/// A structure, where to follow it, and what is read off it.
struct BucklingCase {
    Structure structure;
    int tip = 0;            ///< the node that is watched
    std::string parameter;  ///< with its unit
    /// The parameter in that unit.
    std::function<double(const StructureState&, double)> value = [](const StructureState&, double p) { return p; };
    std::vector<CasePoint> points{};
    equilibria::ContinuationOptions options{};
    bool both_ways = false;  ///< to negative parameters as well
    double amplitude = 0.02;
};

/// 1: Euler's column, L = EI = 1.
BucklingCase euler_column(const CaseData& data);
/// 2: a cantilever rolled up by an end moment, n full circles at M L / (2 pi EI) = n.
BucklingCase roll_up(const CaseData& data);
/// 3: lateral buckling of a cantilever under a tip load.
BucklingCase lateral_cantilever(const CaseData& data);
/// 4: lateral buckling of a strip in forks under end moments about z. Each fork turns about z, and lets the strip's end
/// turn about the fork's y.
BucklingCase lateral_strip(const CaseData& data);
/// 5: Argyris' right-angle cantilever frame.
BucklingCase right_angle_frame(const CaseData& data);
/// 6: the hinged right-angle frame under equal and opposite end moments.
BucklingCase hinged_frame(const CaseData& data);
/// 7: the deep arch, clamped and hinged, under a crown load.
BucklingCase deep_arch(const CaseData& data);
/// 8: the hinged arch under a crown load, R = EI = 1.
BucklingCase hinged_arch(const CaseData& data);
/// 10: Lee's frame: its whole snap-back path.
BucklingCase lee_frame(const CaseData& data);
/// 11: Williams' toggle.
BucklingCase williams_toggle(const CaseData& data);
/// 12: the von Mises truss, half span 1, EA = 1, Green's strain.
BucklingCase von_mises_truss(const CaseData& data);
/// 13: the star dome of 24 bars.
BucklingCase star_dome(const CaseData& data);
/// 14: a ring under pressure, a quarter of it between axes of symmetry, R = EI = 1.
BucklingCase pressed_ring(const CaseData& data);
/// 15: a rod between clamped ends, one of which turns and slides: M L / EI2, with a constant tension.
BucklingCase twisted_rod(const CaseData& data);
/// 18: the 45 degree bend.
BucklingCase bend(const CaseData& data);
/// 19: a chain of rigid links of length 1 with torsion springs c = 1, under a dead axial load.
BucklingCase rigid_link_chain(const CaseData& data);
/// 20: the shallow arch of two modes.
BucklingCase shallow_arch(const CaseData& data);

/// A case's number, name and maker, and which data it takes.
struct CaseEntry {
    int number;
    const char* name;
    BucklingCase (*make)(const CaseData&);
    std::vector<std::string> options;
};
const std::vector<CaseEntry>& buckling_cases();

}  // namespace support
