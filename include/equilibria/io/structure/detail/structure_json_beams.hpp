/// \file
/// Beams of a structure's text, straight and circular ones, and their sections.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/arc.hpp>
#include <equilibria/fem/mesh.hpp>
#include <equilibria/fem/section.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/detail/structure_json_draft.hpp>

namespace equilibria::fem::detail {

/// Sections by their names.
struct SectionTable {
    std::map<std::string, Section> spatial;
    std::map<std::string, PlanarSection> planar;
    std::map<std::string, double> mass;  ///< per length, where it is given
};

inline double read_stiffness(const JsonPlace& value) {
    if (value.json() == "rigid") return rigid;
    if (!value.json().is_number() || !(value.number() > 0)) value.refuse("must be a positive number or \"rigid\"");
    return value.number();
}

/// polar_radius: unless it is given, the shear centre's distance from the centroid, the least that it can be.
inline ShearCentre read_shear_centre(const JsonPlace& section) {
    ShearCentre y;
    const auto pair = [&](const char* key, std::array<double, 2>& numbers) {
        const auto given = section.find(key);
        if (!given) return;
        if (!given->json().is_array() || given->size() != 2) given->refuse("must be two numbers, along axes 2 and 3");
        for (std::size_t k = 0; k < 2; ++k) numbers[k] = (*given)[k].number();
    };
    pair("shear_centre", y.place);
    pair("wagner", y.wagner);
    const double distance = std::hypot(y.place[0], y.place[1]);
    y.polar_radius = distance;
    if (const auto given = section.find("polar_radius")) {
        y.polar_radius = given->number();
        if (!(y.polar_radius >= distance))
            given->refuse("must be at least the shear centre's distance from the centroid, " + to_text(distance));
    }
    return y;
}

inline SectionTable read_sections(const std::optional<JsonPlace>& sections) {
    SectionTable y;
    if (!sections) return y;
    for (const auto& [name, value] : sections->object().items()) {
        const JsonPlace s = sections->at(name);
        if (const auto mass = s.find("mass")) y.mass[name] = mass->positive();
        const auto stiffness = [&](const char* key) { return read_stiffness(s.at(key)); };
        if (s.find("ga") || s.find("ei")) {
            s.keys("a planar section", {"ea", "ga", "ei"}, {"mass"});
            y.planar[name] = {stiffness("ea"), stiffness("ga"), s.at("ei").positive()};
        } else {
            s.keys("a section", {"ea", "ga2", "ga3", "gj", "ei2", "ei3"},
                   {"mass", "shear_centre", "polar_radius", "wagner"});
            const Section section{stiffness("ea"),  stiffness("ga2"), stiffness("ga3"),    stiffness("gj"),
                                  stiffness("ei2"), stiffness("ei3"), read_shear_centre(s)};
            if (std::isinf(std::min({section.gj, section.ei2, section.ei3})))
                s.refuse("must not have gj, ei2 and ei3 all rigid");
            y.spatial[name] = section;
        }
    }
    return y;
}

/// Adds beams to a draft.
class BeamReader {
public:
    BeamReader(StructureDraft& draft, SectionTable sections) : draft_(draft), sections_(std::move(sections)) {}

    void add(const JsonPlace& e, bool curved) {
        const std::string& section = e.at("section").string();
        const bool planar = sections_.planar.contains(section);
        if (!planar && !sections_.spatial.contains(section)) e.at("section").refuse("must be the name of a section");
        if (planar && e.find("second")) e.at("second").refuse("is no key of a beam with a planar section");
        if (curved)
            e.keys("an arc", {"type", "nodes", "section", "through"}, {"second", "elements", "order", "name"});
        else
            e.keys("a beam", {"type", "nodes", "section"}, {"second", "elements", "order", "name"});
        Line line;
        line.ends = draft_.two_nodes(e);
        draft_.check_length(e, line.ends);
        if (planar) draft_.check_planar(e, line.ends);
        if (const auto given = e.find("elements")) line.elements = given->integer(1, draft_.most_elements());
        draft_.count(e, static_cast<std::size_t>(line.elements));
        if (const auto given = e.find("order"))
            line.nodes_each = 2 + static_cast<int>(given->choice({"linear", "quadratic", "cubic"}));
        if (curved) line.arc = read_arc(e, line, planar);
        DraftLine drawn{{}, line.nodes_each, planar, 0};
        if (const auto mass = sections_.mass.find(section); mass != sections_.mass.end()) drawn.mass = mass->second;
        drawn.nodes = planar ? add_planar(line, sections_.planar.at(section))
                             : add_spatial(line, sections_.spatial.at(section), read_second(e, line));
        draft_.add_line(e, std::move(drawn));
    }

private:
    /// Elements between two nodes, on an arc or else straight.
    struct Line {
        std::array<int, 2> ends{};
        int elements = 8;
        int nodes_each = 3;
        std::optional<Arc> arc;
    };

    Arc read_arc(const JsonPlace& e, const Line& line, bool planar) const {
        const Eigen::Vector3d &a = draft_.at(line.ends[0]), &b = draft_.at(line.ends[1]);
        const JsonPlace through = e.at("through");
        const auto arc = Arc::through(a, through.vector(), b);
        if (!arc)
            through.refuse("must not be on a line with the nodes, at " + draft_.point(a) + " and " + draft_.point(b));
        if (planar && through.vector()(2) != 0) through.refuse("must be in the plane z = 0, as the section is planar");
        const int steps = line.elements * (line.nodes_each - 1);
        const double right_angle = std::numbers::pi / 2 * (1 + 1e-9);
        if (arc->angle > right_angle * steps)
            e.refuse("must have more elements, so that neighbouring nodes turn by at most a right angle, not " +
                     to_text(arc->angle / steps) + " radians");
        return *arc;
    }
    /// Where axis 2 of the cross-section points to.
    Eigen::Vector3d read_second(const JsonPlace& e, const Line& line) {
        const Eigen::Vector3d axis = (draft_.at(line.ends[1]) - draft_.at(line.ends[0])).normalized();
        const Eigen::Vector3d z = Eigen::Vector3d::UnitZ();
        const auto& arc = line.arc;
        const auto given = e.find("second");
        if (!given && arc) {
            draft_.note("axis 2 of the section of " + e.name() + " is the normal of the arc's plane, " +
                        StructureDraft::point(arc->normal) +
                        ", about which it turns to the left, as it has no \"second\"");
            return arc->normal;
        }
        if (!given) return axis.cross(z).norm() > 1e-3 ? z : Eigen::Vector3d::UnitY();
        const Eigen::Vector3d second = given->direction();
        if (!arc && axis.cross(second).norm() < 1e-6) given->refuse("must not be along the beam");
        if (arc && arc->clearance(second) < 0.1)
            given->refuse("must be 0.1 radians off all tangents of the arc: the nearest is off by " +
                          to_text(arc->clearance(second)));
        return second;
    }

    std::vector<int> add_planar(const Line& line, const PlanarSection& section) {
        const auto& arc = line.arc;
        double first = 0, turn = 0;
        if (arc) {
            first = std::atan2(arc->tangent(1), arc->tangent(0));
            turn = arc->normal(2) > 0 ? arc->angle : -arc->angle;
        }
        const auto frame = [&](double t) { return PlanarSectionFrame{arc->at(t), first + turn * t}; };
        return with_beam_nodes(line.nodes_each, [&](auto n) {
            return arc ? add_planar_beam<n>(draft_.model(), section, frame, line.elements, line.ends[0], line.ends[1])
                       : add_straight_planar_beam<n>(draft_.model(), section, line.ends[0], line.ends[1],
                                                     line.elements);
        });
    }
    std::vector<int> add_spatial(const Line& line, const Section& section, const Eigen::Vector3d& second) {
        const auto& arc = line.arc;
        const auto frame = [&](double t) { return section_frame(arc->at(t), arc->direction(t), second); };
        return with_beam_nodes(line.nodes_each, [&](auto n) {
            return arc ? add_beam<n>(draft_.model(), section, frame, line.elements, line.ends[0], line.ends[1])
                       : add_straight_beam<n>(draft_.model(), section, line.ends[0], line.ends[1], second,
                                              line.elements);
        });
    }
    StructureDraft& draft_;
    SectionTable sections_;
};

}  // namespace equilibria::fem::detail
