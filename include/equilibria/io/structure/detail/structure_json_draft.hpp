/// \file
/// The model of a structure's text while it is read: nodes by their names, and the checks that elements, joints and
/// loads share.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/structure_model.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/structure_input.hpp>

namespace equilibria::fem::detail {

using equilibria::detail::JsonPlace;

/// An element of the text as loads along it see it.
struct DraftLine {
    std::vector<int> nodes;    ///< in order
    int nodes_each = 2;        ///< how many an element of the model has
    bool planar_beam = false;  ///< a pressure can act on it
    double mass = 0;           ///< per length
};

class StructureDraft {
public:
    explicit StructureDraft(int most_elements) : most_elements_(most_elements) {}

    Model& model() { return model_; }
    const Model& model() const { return model_; }
    int most_elements() const { return most_elements_; }
    /// So many more elements of the model.
    void count(const JsonPlace& entry, std::size_t more) {
        const std::size_t most = static_cast<std::size_t>(most_elements_);
        if (more > most - elements_)
            entry.refuse("must not take the model above " + std::to_string(most) + " elements (ParseLimits)");
        elements_ += more;
    }

    /// A beam, an arc or a truss, by its name if it has one.
    void add_line(const JsonPlace& entry, DraftLine line) {
        if (const auto name = entry.find("name"))
            if (!names_.emplace(name->string(), lines_.size()).second)
                name->refuse("must be the name of one element alone");
        lines_.push_back(std::move(line));
    }
    /// All of them, in the order of the text.
    const std::vector<DraftLine>& lines() const { return lines_; }
    const DraftLine& line(const JsonPlace& name) const {
        const auto found = names_.find(name.string());
        if (found == names_.end()) name.refuse("must be the name of a beam, an arc or a truss");
        return lines_[found->second];
    }
    /// Something that the text leaves to the reader, in a sentence.
    void note(std::string sentence) { notes_.push_back(std::move(sentence)); }

    void add_node(const std::string& name, const JsonPlace& x) {
        const int k = nodes_[name] = model_.add_node(x.vector());
        size_ = std::max(size_, at(k).norm());
        touched_.push_back(false);
    }
    /// Their numbers.
    const std::map<std::string, int>& nodes() const { return nodes_; }
    int node(const JsonPlace& name) const {
        const auto found = nodes_.find(name.string());
        if (found == nodes_.end()) name.refuse("must be the name of a node");
        return found->second;
    }
    /// A node of an element's or a joint's.
    int own_node(const JsonPlace& name) {
        const int k = node(name);
        touched_[static_cast<std::size_t>(k)] = true;
        return k;
    }
    /// Whether it is one.
    bool touched(int node) const { return touched_[static_cast<std::size_t>(node)]; }
    std::array<int, 2> two_nodes(const JsonPlace& entry) {
        const JsonPlace names = entry.at("nodes");
        if (names.size() != 2) names.refuse("must be a list of 2 nodes");
        const std::array<int, 2> y{own_node(names[0]), own_node(names[1])};
        if (y[0] == y[1]) names.refuse("must be different nodes");
        return y;
    }

    const Eigen::Vector3d& at(int node) const { return model_.at(node); }
    /// As text.
    static std::string point(const Eigen::Vector3d& x) {
        return "(" + to_text(x(0)) + ", " + to_text(x(1)) + ", " + to_text(x(2)) + ")";
    }
    void check_length(const JsonPlace& entry, const std::array<int, 2>& nodes) const {
        const double length = (at(nodes[1]) - at(nodes[0])).norm();
        if (!(length > 0)) entry.at("nodes").refuse("must not both be at " + point(at(nodes[0])));
        if (!std::isfinite(length)) entry.at("nodes").refuse("must be at a finite distance");
    }
    void check_planar(const JsonPlace& entry, std::span<const int> nodes) const {
        for (std::size_t k = 0; k < nodes.size(); ++k)
            if (at(nodes[k])(2) != 0)
                entry.at("nodes")[k].refuse("must be in the plane z = 0, as all that is planar, not at " +
                                            point(at(nodes[k])));
    }
    /// From the second to the first of two nodes at one place: rounding alone.
    Eigen::Vector3d gap(const JsonPlace& entry, const std::array<int, 2>& nodes) const {
        const Eigen::Vector3d &a = at(nodes[0]), &b = at(nodes[1]);
        if (!((a - b).norm() <= 1e-9 * size_))
            entry.at("nodes").refuse("must be at one place, but are at " + point(a) + " and " + point(b));
        return a - b;
    }

    /// "kind" of an entry: "proportional" (default) or "constant".
    static LoadKind kind(const JsonPlace& entry, LoadKind otherwise = LoadKind::proportional) {
        const auto given = entry.find("kind");
        if (!given) return otherwise;
        return given->choice({"proportional", "constant"}) == 1 ? LoadKind::constant : LoadKind::proportional;
    }

    /// Hands over nodes, model and notes.
    void move_to(StructureInput& y) && {
        y.nodes = std::move(nodes_);
        y.model = std::move(model_);
        y.notes = std::move(notes_);
    }

private:
    Model model_;
    std::map<std::string, int> nodes_;
    std::vector<bool> touched_;
    std::vector<DraftLine> lines_;
    std::map<std::string, std::size_t> names_;  // of lines
    std::vector<std::string> notes_;
    int most_elements_;
    std::size_t elements_ = 0;
    double size_ = 0;  // the largest distance of a node from the origin
};

}  // namespace equilibria::fem::detail
