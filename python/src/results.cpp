#include "results.hpp"

#include <array>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <sstream>
#include <string>
#include <vector>

#include <pybind11/complex.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include "arrays.hpp"

namespace py = pybind11;

namespace equilibria::python {

namespace {

py::dict path_counts(const PathCounts& c) {
    py::dict y;
    y["total"] = c.total;
    y["finite"] = c.finite;
    y["at_infinity"] = c.at_infinity;
    y["singular"] = c.singular;
    y["failed"] = c.failed;
    y["cancelled"] = c.cancelled;
    y["tracked"] = c.tracked;
    y["retracked"] = c.retracked;
    y["more_digits"] = c.more_digits;
    y["steps"] = c.steps;
    return y;
}

template <class T>
std::string text_of(const T& printed) {
    std::ostringstream out;
    out << printed;
    return out.str();
}

py::list events_of(const std::vector<LineEvent<RuntimeUnknowns>>& events) {
    py::list all;
    for (const auto& e : events) {
        py::dict y;
        y["kind"] = to_string(e.kind);
        y["value"] = e.value;
        y["q"] = column<double>(e.q, [](double x) { return x; });
        y["null_vector"] = column<double>(e.v, [](double x) { return x; });
        y["residual"] = e.residual;
        y["correction"] = e.correction;
        y["third"] = e.reduced.third;
        y["fourth"] = e.reduced.fourth;
        y["slope"] = e.slope;
        y["index"] = e.index;
        y["change"] = array_of(e.change);
        y["at_infinity"] = py::make_tuple(e.at_infinity[0], e.at_infinity[1]);
        all.append(std::move(y));
    }
    return all;
}

}  // namespace

py::dict to_python(const RootSet<RuntimeUnknowns>& set) {
    const auto n = static_cast<std::size_t>(set.model.sizes.unknowns);
    py::dict y;
    y["roots"] = rows<std::complex<double>>(set.roots, n, [](const auto& r) -> const auto& { return r.q; });
    y["root_residual"] = column<double>(set.roots, [](const auto& r) { return r.residual; });
    y["root_condition"] = column<double>(set.roots, [](const auto& r) { return r.condition; });
    y["root_paths"] = column<std::int64_t>(set.roots, [](const auto& r) { return r.paths; });
    y["singular_root"] = column<bool>(set.roots, [](const auto& r) { return r.status == PathStatus::singular; });
    const auto& e = set.equilibria;
    y["angles"] = rows<double>(e, n, [](const auto& at) -> const auto& { return at.q; });
    y["energy"] = column<double>(e, [](const auto& at) { return at.energy; });
    y["index"] = column<std::int64_t>(e, [](const auto& at) { return at.index; });
    y["nullity"] = column<std::int64_t>(e, [](const auto& at) { return at.nullity; });
    y["margin"] = column<double>(e, [](const auto& at) { return at.margin; });
    y["residual"] = column<double>(e, [](const auto& at) { return at.residual; });
    y["condition"] = column<double>(e, [](const auto& at) { return at.condition; });
    y["multiplicity"] = column<std::int64_t>(e, [](const auto& at) { return at.multiplicity; });
    y["path"] = column<std::int64_t>(e, [](const auto& at) { return at.path; });
    py::list families;
    for (const auto& family : set.families) {
        py::dict one;
        one["dimension"] = family.dimension;
        one["real"] = family.real();
        one["paths"] = family.paths();
        one["real_point"] =
            family.real_point ? py::object(column<double>(*family.real_point, [](double x) { return x; })) : py::none();
        families.append(std::move(one));
    }
    y["families"] = std::move(families);
    py::list failures;
    for (const auto& failed : set.failures) {
        py::dict one;
        one["path"] = failed.path;
        one["reason"] = std::string(to_string(failed.reason));
        failures.append(std::move(one));
    }
    y["failures"] = std::move(failures);
    y["alarms"] = set.alarms.sentences();
    y["paths"] = path_counts(set.paths);
    y["by_index"] = array_of(set.by_index());
    y["clean"] = set.clean();
    y["morse_applies"] = set.morse_applies();
    y["morse"] = set.morse();
    y["seed"] = set.seed;
    y["seconds"] = set.seconds;
    y["completeness"] = std::string(to_string(set.completeness.completeness));
    y["missing_at_most"] =
        set.completeness.missing_at_most ? py::object(py::int_(*set.completeness.missing_at_most)) : py::none();
    y["verdict"] = in_words(set.completeness);
    y["start"] = set.start.name;
    y["why_start"] = set.start.why;
    y["summary"] = text_of(set);
    return y;
}

py::dict to_python(const ProofOfRoots& proof) {
    const auto& c = proof.certificates;
    py::dict y;
    y["exists"] = column<bool>(c, [](const auto& one) { return one.exists; });
    y["root_distinct"] = column<bool>(c, [](const auto& one) { return one.distinct; });
    py::list reality;
    for (const auto& one : c) reality.append(std::string(name(one.reality)));
    y["reality"] = std::move(reality);
    y["index_proved"] = column<bool>(c, [](const auto& one) { return one.index_proved; });
    y["root_index"] = column<std::int64_t>(c, [](const auto& one) { return one.index; });
    y["digits"] = column<std::int64_t>(c, [](const auto& one) { return one.digits; });
    y["radius"] = column<double>(c, [](const auto& one) { return one.radius; });
    y["distinct"] = proof.distinct;
    y["real"] = proof.real;
    y["non_real"] = proof.non_real;
    y["undecided"] = proof.undecided;
    y["duplicates"] = proof.duplicates;
    y["index"] = proof.index;
    y["contradictions"] = proof.contradictions;
    y["by_index"] = array_of(proof.by_index);
    y["bound"] = proof.bound ? py::object(py::int_(proof.bound->value)) : py::none();
    y["bound_name"] = proof.bound ? proof.bound->name : std::string();
    y["complete"] = proof.complete;
    y["reason"] = proof.reason;
    y["seconds"] = proof.seconds;
    y["summary"] = text_of(proof);
    return y;
}

py::dict to_python(const LineEvents<RuntimeUnknowns>& found) {
    py::dict y;
    y["events"] = events_of(found.events);
    py::list intervals;
    for (const EventGap& gap : found.intervals) {
        py::dict one;
        one["low"] = gap.low;
        one["high"] = gap.high;
        one["at"] = gap.at;
        one["also_at"] = gap.also_at;
        one["confirmed"] = gap.confirmed;
        one["count"] = gap.count;
        one["by_index"] = array_of(gap.by_index);
        one["clean"] = gap.clean;
        intervals.append(std::move(one));
    }
    y["intervals"] = std::move(intervals);
    y["paths"] = path_counts(found.paths);
    y["complex_solutions"] = found.complex_solutions;
    y["start"] = found.start;
    y["complete"] = found.complete();
    y["argument"] = found.argument();
    y["seconds"] = found.seconds;
    return y;
}

py::dict to_python(const BifurcationDiagram<RuntimeUnknowns>& diagram, int unknowns) {
    py::dict y;
    y["events"] = events_of(diagram.events);
    py::list pieces;
    for (const auto& piece : diagram.pieces) {
        py::dict one;
        one["index"] = piece.index;
        one["ends"] = py::make_tuple(to_string(piece.ends[0]), to_string(piece.ends[1]));
        one["parameter"] = column<double>(piece.points, [](const auto& at) { return at.parameter; });
        one["q"] = rows<double>(piece.points, static_cast<std::size_t>(unknowns),
                                [](const auto& at) -> const auto& { return at.q; });
        pieces.append(std::move(one));
    }
    y["pieces"] = std::move(pieces);
    y["failed_paths"] = diagram.failed_paths;
    y["complete"] = diagram.complete();
    y["argument"] = diagram.argument();
    return y;
}

py::dict to_python(const Locus<RuntimeUnknowns>& locus, int unknowns) {
    const auto n = static_cast<std::size_t>(unknowns);
    const auto planar = [](const auto& points) {
        return rows<double>(points, 2, [](const auto& at) { return std::array<double, 2>{at.x, at.y}; });
    };
    py::dict y;
    py::list curves;
    for (const auto& curve : locus.curves) {
        py::dict one;
        one["kind"] = to_string(curve.kind);
        one["points"] =
            rows<double>(curve.points, 2, [](const auto& at) { return std::array<double, 2>{at.x(), at.y()}; });
        one["q"] = rows<double>(curve.points, n, [](const auto& at) -> const auto& { return at.q; });
        one["ends"] = py::make_tuple(to_string(curve.ends[0]), to_string(curve.ends[1]));
        curves.append(std::move(one));
    }
    y["curves"] = std::move(curves);
    py::list points;
    for (const auto& at : locus.points) {
        py::dict one;
        one["kind"] = to_string(at.kind);
        one["point"] = py::array_t<double>(2, std::array<double, 2>{at.x(), at.y()}.data());
        one["q"] = column<double>(at.q, [](double x) { return x; });
        one["null_vector"] = column<double>(at.v, [](double x) { return x; });
        one["residual"] = at.residual;
        one["correction"] = at.correction;
        one["derivatives"] = py::array_t<double>(6, &at.derivatives[0]);
        points.append(std::move(one));
    }
    y["points"] = std::move(points);
    py::list regions;
    for (const LocusRegion& region : locus.regions) {
        py::dict one;
        one["point"] = py::array_t<double>(2, std::array<double, 2>{region.point.x, region.point.y}.data());
        one["count"] = region.count;
        one["by_index"] = array_of(region.by_index);
        one["area"] = region.area;
        one["clean"] = region.clean;
        one["confirmed"] = region.confirmed;
        py::list polygons;
        for (const auto& polygon : region.polygons) polygons.append(planar(polygon));
        one["polygons"] = std::move(polygons);
        regions.append(std::move(one));
    }
    y["regions"] = std::move(regions);
    py::list from_infinity;
    for (const InfinityCurve& curve : locus.from_infinity) from_infinity.append(planar(curve.points));
    y["from_infinity"] = std::move(from_infinity);
    y["borders"] = rows<std::int64_t>(locus.borders, 3, [](const RegionBorder& border) {
        return std::array<std::int64_t, 3>{border.below, border.above, static_cast<std::int64_t>(border.curve)};
    });
    y["complete"] = locus.evidence.complete();
    y["argument"] = locus.argument();
    y["failed_paths"] = locus.evidence.all_failed_paths();
    y["seconds"] = locus.evidence.seconds;
    return y;
}

}  // namespace equilibria::python
