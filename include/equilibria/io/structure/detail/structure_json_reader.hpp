/// \file
/// The reader of a structure's text: the object at its root, and the lists in it one after the other.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include <equilibria/core/error.hpp>
#include <equilibria/fem/structure_model.hpp>
#include <equilibria/io/strict_json.hpp>
#include <equilibria/io/structure/detail/structure_json_beams.hpp>
#include <equilibria/io/structure/detail/structure_json_draft.hpp>
#include <equilibria/io/structure/detail/structure_json_elements.hpp>
#include <equilibria/io/structure/detail/structure_json_joints.hpp>
#include <equilibria/io/structure/detail/structure_json_loads.hpp>
#include <equilibria/io/structure/detail/structure_json_start.hpp>
#include <equilibria/io/structure/structure_input.hpp>

namespace equilibria::fem::detail {

using equilibria::detail::JsonError;
using equilibria::detail::JsonPlace;
using equilibria::detail::JsonText;

/// Reads one text, once.
class StructureReader {
public:
    StructureReader(const JsonText& text, const ParseLimits& limits)
        : text_(text), root_(text.root, ""), limits_(limits), draft_(limits.elements) {}

    StructureInput read() {
        root_.keys("a structure", {"nodes", "elements", "parameter"},
                   {"name", "sections", "supports", "joints", "loads", "measure"});
        if (const auto name = root_.find("name")) y_.name = name->string();
        read_nodes();
        read_elements();
        for_each("joints", [&](const JsonPlace& j) { add_joint(draft_, j); });
        for (const auto& [name, node] : draft_.nodes())
            if (!draft_.touched(node)) root_.at("nodes").at(name).refuse("is used by no element and no joint");
        for_each("supports", [&](const JsonPlace& s) { add_support(s); });
        const auto loaded = read_loads();
        read_parameter();
        const auto measure = root_.find("measure");
        const int last = static_cast<int>(draft_.nodes().size()) - 1;
        y_.measured = measure ? draft_.node(*measure) : loaded.value_or(last);
        std::move(draft_).move_to(y_);
        y_.elements = owners_.names();
        check_start(y_, owners_, limits_.constraints);
        return std::move(y_);
    }

private:
    /// Calls read(entry) for each entry of a list of the root's.
    void for_each(const std::string& key, const auto& read) {
        const auto list = root_.find(key);
        if (!list) return;
        for (std::size_t k = 0; k < list->size(); ++k) {
            const JsonPlace entry = (*list)[k];
            try {
                read(entry);
            } catch (const JsonError&) {
                throw;
            } catch (const InvalidArgument& e) {
                entry.refuse(std::string("cannot be added: ") + e.what());
            }
            owners_.add(draft_.model(), entry);
        }
    }

    void read_nodes() {
        const JsonPlace nodes = root_.at("nodes");
        if (nodes.object().empty()) nodes.refuse("must not be empty");
        for (const std::string& name : text_.order.at("nodes")) draft_.add_node(name, nodes.at(name));
    }
    void read_elements() {
        SectionTable sections = read_sections(root_.find("sections"));
        if (root_.at("elements").size() == 0) root_.at("elements").refuse("must not be empty");
        ElementReader elements(draft_, std::move(sections));
        for_each("elements", [&](const JsonPlace& e) { elements.add(e); });
    }
    void add_support(const JsonPlace& s) {
        s.keys("a support", {"node", "fix"});
        const int k = draft_.node(s.at("node"));
        const JsonPlace words = s.at("fix");
        if (words.size() == 0) words.refuse("must not be empty");
        for (std::size_t i = 0; i < words.size(); ++i) {
            const std::size_t word =
                words[i].choice({"ux", "uy", "uz", "rx", "ry", "rz", "position", "rotation", "all"});
            for (std::size_t c = 0; c < 6; ++c)
                if (word == c || word == 8 || (word == 6 && c < 3) || (word == 7 && c >= 3))
                    draft_.model().fix(k, {Component(c)});
        }
    }
    /// The first node with a load, if there is one.
    std::optional<int> read_loads() {
        std::optional<int> first;
        LoadReader loads(draft_);
        for_each("loads", [&](const JsonPlace& l) {
            const auto node = loads.add(l);
            if (!first) first = node;
        });
        return first;
    }
    void read_parameter() {
        const JsonPlace p = root_.at("parameter");
        p.keys("the parameter", {"low", "high"},
               {"name", "direction", "first_step", "largest_step", "parameter_weight"});
        if (const auto name = p.find("name")) y_.parameter = name->string();
        y_.low = p.at("low").number();
        y_.high = p.at("high").number();
        if (!(y_.low < y_.high)) p.at("low").refuse("must be below high, " + to_text(y_.high));
        if (const auto direction = p.find("direction")) {
            const std::string word = direction->string();
            if (word != "up" && word != "down" && word != "both") direction->refuse("must be up, down or both");
            y_.up = word != "down";
            y_.down = word != "up";
        } else {
            y_.up = y_.high > 0;
            y_.down = y_.low < 0;
        }
        if (const auto weight = p.find("parameter_weight")) y_.parameter_weight = weight->positive();
        if (const auto step = p.find("first_step")) y_.first_step = step->positive();
        if (const auto step = p.find("largest_step")) y_.largest_step = step->positive();
        if (y_.first_step && y_.largest_step && *y_.first_step > *y_.largest_step)
            p.at("first_step").refuse("must not be above largest_step, " + to_text(*y_.largest_step));
    }

    const JsonText& text_;
    JsonPlace root_;
    ParseLimits limits_;
    StructureDraft draft_;
    EntryOwners owners_;
    StructureInput y_;
};

}  // namespace equilibria::fem::detail
