/// \file
/// A structure as it is put together: nodes, elements, supports, loads. fem::Structure makes a problem of it.
///
///     fem::Model model;
///     const int a = model.add_node({0, 0, 0}), b = model.add_node({1, 0, 0});
///     model.add(fem::Truss<3>(1000, model.at(a), model.at(b)), {a, b});
///     model.fix(a, fem::spatial);
///     model.load(b, {0, 0, -1});                    // p times this force
///
/// Nodes are numbered from 0. Every function throws InvalidArgument where a node does not exist or a number is not
/// finite.
#pragma once

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <typeindex>
#include <utility>
#include <vector>

#include <equilibria/core/error.hpp>
#include <equilibria/core/streamed_text.hpp>
#include <equilibria/fem/element.hpp>

namespace equilibria::fem {

/// A dead force (spatial) and moment (spatial) on a node.
struct NodalLoad {
    int node = 0;                                      ///< number of the node
    Eigen::Vector3d force = Eigen::Vector3d::Zero();   ///< in fixed axes
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();  ///< in fixed axes
    LoadKind kind = LoadKind::proportional;            ///< whether p multiplies it
};

/// Nodes, elements, supports and loads, see the file.
class Model {
public:
    Model() = default;
    /// Moved, or copied with its elements.
    /// \{
    Model(Model&&) = default;
    Model& operator=(Model&&) = default;
    Model(const Model& other)
        : x_(other.x_), fixed_(other.fixed_), rotates_with_(other.rotates_with_), loads_(other.loads_),
          group_of_(other.group_of_) {
        for (const auto& group : other.groups_) groups_.push_back(group->clone());
    }
    Model& operator=(const Model& other) { return *this = Model(other); }
    /// \}

    /// A new node at x; its number.
    int add_node(const Eigen::Vector3d& x) {
        require(x.allFinite(), "x of node " + std::to_string(nodes()), streamed(x.transpose()), "must be finite");
        x_.push_back(x);
        fixed_.push_back({});
        rotates_with_.push_back(nodes() - 1);
        return nodes() - 1;
    }
    int nodes() const { return static_cast<int>(x_.size()); }  ///< how many there are
    /// Where a node is without load.
    const Eigen::Vector3d& at(int node) const { return x_[checked(node, "node")]; }

    /// Adds an element between different nodes; its number among those of its type and kind. A constant one acts as at
    /// p = 1, whatever p is: a follower load, a pressure, a prescribed motion.
    template <Element E>
    std::size_t add(E element, const std::array<int, static_cast<std::size_t>(E::n_nodes)>& nodes,
                    LoadKind kind = LoadKind::proportional) {
        if (!depends_on_parameter<E>) kind = LoadKind::proportional;
        for (std::size_t k = 0; k < nodes.size(); ++k) {
            checked(nodes[k], "nodes[" + std::to_string(k) + "]");
            for (std::size_t j = 0; j < k; ++j)
                require(nodes[j] != nodes[k], "nodes[" + std::to_string(k) + "]", nodes[k],
                        "must differ from the element's other nodes");
        }
        const auto [found, is_new] = group_of_.try_emplace({typeid(E), kind}, groups_.size());
        if (is_new) groups_.push_back(std::make_unique<ElementGroupOf<E>>(kind));
        auto& own = static_cast<ElementGroupOf<E>&>(*groups_[found->second]);
        own.add(std::move(element), nodes);
        return own.size() - 1;
    }

    /// Fixes components of a node where they are: positions, and right increments of its rotation.
    /// \{
    void fix(int node, std::span<const Component> components) {
        for (const Component c : components) fixed_[checked(node, "node")][c] = true;
    }
    void fix(int node, std::initializer_list<Component> components) {
        fix(node, std::span(components.begin(), components.size()));
    }
    /// \}
    /// Whether a component is fixed.
    bool fixed(int node, Component c) const { return fixed_[checked(node, "node")][c]; }

    /// The node turns as another one does, as points of one rigid body do: Boolean assignment of rotations (18). So do
    /// all nodes that turn with either of them.
    void share_rotation(int node, int with) {
        checked(node, "node");
        checked(with, "with");
        const int root = rotates_with(with);
        require(root != node, "with", with, "must not itself turn with node " + std::to_string(node));
        rotates_with_[static_cast<std::size_t>(rotates_with(node))] = root;
    }
    /// The node whose rotation this one has: itself, if it has its own.
    int rotates_with(int node) const {
        int root = rotates_with_[checked(node, "node")];
        while (rotates_with_[static_cast<std::size_t>(root)] != root)
            root = rotates_with_[static_cast<std::size_t>(root)];
        return root;
    }

    /// A dead force and moment, both in fixed axes. A dead moment has an energy only where its node turns about one
    /// axis alone, see Structure.
    void load(int node, const Eigen::Vector3d& force, const Eigen::Vector3d& moment = Eigen::Vector3d::Zero(),
              LoadKind kind = LoadKind::proportional) {
        checked(node, "node");
        require(force.allFinite(), "force", streamed(force.transpose()), "must be finite");
        require(moment.allFinite(), "moment", streamed(moment.transpose()), "must be finite");
        loads_.push_back({node, force, moment, kind});
    }

    const std::vector<NodalLoad>& loads() const { return loads_; }  ///< in the order in which they were given
    /// Elements by their types, in the order in which the types were first added.
    const std::vector<std::unique_ptr<ElementGroup>>& groups() const { return groups_; }
    /// Which components of each node elements use; a rotation that several nodes share counts for the one that has it.
    std::vector<std::array<bool, 6>> used() const {
        std::vector<std::array<bool, 6>> y(x_.size());
        for (const auto& group : groups_)
            for (std::size_t e = 0; e < group->size(); ++e)
                for (int k = 0; k < group->n_nodes(); ++k)
                    for (int c = 0; c < group->n_components(); ++c) mark(y, group->nodes(e)[k], group->components()[c]);
        return y;
    }
    /// Which components are fixed, counted likewise: a rotation is where it is fixed at one of the nodes that share it.
    std::vector<std::array<bool, 6>> held() const {
        std::vector<std::array<bool, 6>> y(x_.size());
        for (int k = 0; k < nodes(); ++k)
            for (const Component c : spatial)
                if (fixed_[static_cast<std::size_t>(k)][c]) mark(y, k, c);
        return y;
    }
    /// Whether something is constant: a first stage brings it on, see fem::loaded_state.
    bool has_constant_loads() const {
        const auto constant = [](LoadKind kind) { return kind == LoadKind::constant; };
        return std::ranges::any_of(loads_, constant, &NodalLoad::kind) ||
               std::ranges::any_of(groups_, [&](const auto& group) { return constant(group->kind()); });
    }
    /// The elements of one type and kind; nothing if there is none.
    template <Element E>
    const ElementGroupOf<E>* group(LoadKind kind = LoadKind::proportional) const {
        const auto found = group_of_.find({typeid(E), kind});
        return found == group_of_.end() ? nullptr : static_cast<const ElementGroupOf<E>*>(groups_[found->second].get());
    }

private:
    void mark(std::vector<std::array<bool, 6>>& of, int node, Component c) const {
        of[static_cast<std::size_t>(c < rx ? node : rotates_with(node))][c] = true;
    }
    std::size_t checked(int node, std::string_view argument) const {
        require(node >= 0 && node < nodes(), argument, node,
                nodes() > 0 ? "must be a node, from 0 to " + std::to_string(nodes() - 1) : "there are no nodes yet");
        return static_cast<std::size_t>(node);
    }

    std::vector<Eigen::Vector3d> x_;
    std::vector<std::array<bool, 6>> fixed_;
    std::vector<int> rotates_with_;
    std::vector<NodalLoad> loads_;
    std::map<std::pair<std::type_index, LoadKind>, std::size_t> group_of_;
    std::vector<std::unique_ptr<ElementGroup>> groups_;
};

}  // namespace equilibria::fem
