#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <Eigen/Core>

#include <equilibria/continuation/branch.hpp>
#include <equilibria/continuation/diagrams/branch_graph.hpp>
#include <equilibria/fem/loaded_state.hpp>
#include <equilibria/fem/structure.hpp>
#include <equilibria/io/structure/structure_results.hpp>

#include "arrays.hpp"
#include "bindings.hpp"
#include "branches.hpp"
#include "reading.hpp"

namespace py = pybind11;

namespace equilibria::python {

namespace {

using fem::StructureState;

/// Node after node, x y z each.
py::array_t<double> vectors(const std::vector<StructureState>& states, std::size_t nodes, const auto& of) {
    py::array_t<double> y({states.size(), nodes, std::size_t{3}});
    double* to = y.mutable_data();
    for (const StructureState& q : states)
        for (const auto& frame : q.frames) {
            const Eigen::Vector3d v = of(frame);
            to = std::copy(v.begin(), v.end(), to);
        }
    return y;
}
py::array_t<double> positions(const std::vector<StructureState>& states, std::size_t nodes) {
    return vectors(states, nodes, [](const auto& frame) { return frame.x; });
}
py::array_t<double> rotations(const std::vector<StructureState>& states, std::size_t nodes) {
    return vectors(states, nodes, [](const auto& frame) { return shortest_rotation_vector(frame.q); });
}
py::array_t<double> multipliers(const std::vector<StructureState>& states, std::size_t count) {
    return rows<double>(states, count, [](const StructureState& q) -> const auto& { return q.multipliers; });
}

/// A structure that was read, as a problem, with the state under what is constant.
class BoundStructure {
    auto with(const auto& call) const {
        if (const auto* s = std::get_if<fem::Structure>(&structure_)) return call(*s);
        return call(std::get<fem::NonconservativeStructure>(structure_));
    }

public:
    BoundStructure(fem::StructureInput input, bool images) : input_(std::move(input)) {
        const fem::StructureOptions options{.symmetric_images = images};
        if (input_.conservative)
            structure_.emplace<fem::Structure>(input_.model, options);
        else
            structure_.emplace<fem::NonconservativeStructure>(input_.model, options);
        loaded_ = with([&](const auto& s) { return loaded_state(s, fem::continuation_options(input_)); });
    }

    const fem::StructureInput& input() const { return input_; }
    py::dict loaded() const {
        py::list passed;
        for (const auto& [kind, share] : loaded_.passed) passed.append(py::make_tuple(to_string(kind), share));
        return dict("share", loaded_.share, "passed", passed, "unexplained", loaded_.unexplained, "summary",
                    loaded_.summary());
    }
    py::array_t<double> drawn() const {
        const auto start = with([](const auto& s) { return s.initial(); });
        return positions({start}, start.frames.size()).attr("__getitem__")(0);
    }
    std::vector<std::vector<int>> lines() const { return element_lines(input_.model); }
    int size() const {
        return with([](const auto& s) { return s.size() - s.multipliers(); });
    }

    py::dict follow(int direction, const ContinuationOptions& options) const {
        start_or_throw();
        return with([&](const auto& s) {
            const auto branch = [&] {
                const py::gil_scoped_release release;
                return continue_branch(s, loaded_.state, 0, direction, options);
            }();
            return branch_of(s, branch);
        });
    }
    py::dict diagram(const DiagramOptions& options) const {
        start_or_throw();
        return with([&](const auto& s) {
            const auto graph = [&] {
                const py::gil_scoped_release release;
                return bifurcation_diagram(s, loaded_.state, 0, options);
            }();
            return graph_of(
                graph, [&](const auto& branch) { return branch_of(s, branch); },
                [&](const auto& point) { return point_of_structure(s, point); });
        });
    }
    /// structure_results of a state, as text in JSON.
    std::string results(const Numbers& position, const Numbers& rotation, const Numbers& own, double p) const {
        return with([&](const auto& s) {
            StructureState q = s.initial();
            const auto n = static_cast<py::ssize_t>(q.frames.size());
            require(position.ndim() == 2 && position.shape(0) == n && position.shape(1) == 3, "position",
                    position.size(), "must be of the shape (nodes, 3)");
            require(rotation.ndim() == 2 && rotation.shape(0) == n && rotation.shape(1) == 3, "rotation",
                    rotation.size(), "must be of the shape (nodes, 3)");
            require(own.ndim() == 1 && own.size() == q.multipliers.size(), "multipliers", own.size(),
                    "must be as many as the structure's: " + std::to_string(q.multipliers.size()));
            for (std::size_t k = 0; k < q.frames.size(); ++k) {
                q.frames[k].x = Eigen::Map<const Eigen::Vector3d>(position.data() + 3 * k);
                q.frames[k].q = quaternion(Eigen::Vector3d(Eigen::Map<const Eigen::Vector3d>(rotation.data() + 3 * k)));
            }
            q.multipliers = Eigen::Map<const Eigen::VectorXd>(own.data(), own.size());
            return fem::structure_results(s, input_, q, p).dump();
        });
    }

private:
    void start_or_throw() const {
        require(loaded_.reached(), "constant loads", loaded_.share,
                "must be carried before " + input_.parameter + " begins: " + loaded_.summary());
    }
    py::dict arrays_of(const std::vector<StructureState>& states) const {
        const std::size_t nodes = static_cast<std::size_t>(input_.model.nodes()),
                          own = states.empty() ? 0 : static_cast<std::size_t>(states[0].multipliers.size());
        return dict("position", positions(states, nodes), "rotation", rotations(states, nodes), "multipliers",
                    multipliers(states, own));
    }
    /// A direction of unknowns by node: three displacements and three rotations each.
    template <class S>
    static py::array_t<double> by_node(const S& s, const Eigen::VectorXd& v) {
        const auto nodes = static_cast<std::size_t>(s.model().nodes());
        py::array_t<double> y({nodes, std::size_t{6}});
        double* to = y.mutable_data();
        for (int k = 0; k < s.model().nodes(); ++k)
            for (const fem::Component c : fem::spatial) {
                const int i = v.size() > 0 ? s.unknown(k, c) : -1;
                *to++ = i >= 0 ? v(i) : 0;
            }
        return y;
    }
    template <class S, class Point>
    py::dict point_of_structure(const S& s, const Point& point) const {
        py::dict y = evidence_of(point);
        const py::dict at = arrays_of({point.q});
        for (const char* key : {"position", "rotation", "multipliers"}) y[key] = at[key].attr("__getitem__")(0);
        y["mode"] = by_node(s, point.null_vector);
        py::list modes;
        for (Eigen::Index c = 0; c < point.null_vectors.cols(); ++c)
            modes.append(by_node(s, Eigen::VectorXd(point.null_vectors.col(c))));
        y["modes"] = modes;
        return y;
    }
    template <class S, class B>
    py::dict branch_of(const S& s, const B& branch) const {
        std::vector<StructureState> states;
        for (const auto& point : branch.points) states.push_back(point.q);
        py::dict y = columns_of(branch);
        const py::dict at = arrays_of(states);
        for (const auto& [key, value] : at) y[key] = value;
        py::list events;
        for (const auto& event : branch.events) {
            py::dict one = point_of_structure(s, event.point);
            one["step"] = event.step;
            events.append(std::move(one));
        }
        y["events"] = std::move(events);
        return y;
    }

    fem::StructureInput input_;
    std::variant<std::monostate, fem::Structure, fem::NonconservativeStructure> structure_;
    fem::LoadedState loaded_;
};

}  // namespace

void add_structures(py::module_& m) {
    py::class_<BoundStructure>(m, "BoundStructure", "A structure that was read, for equilibria.Structure")
        .def(py::init(
                 [](const std::string& text, bool images) { return BoundStructure(structure_of_text(text), images); }),
             py::arg("text"), py::arg("images"))
        .def_property_readonly("name", [](const BoundStructure& s) { return s.input().name; })
        .def_property_readonly("nodes", [](const BoundStructure& s) { return s.input().nodes; })
        .def_property_readonly("notes", [](const BoundStructure& s) { return s.input().notes; })
        .def_property_readonly("parameter", [](const BoundStructure& s) { return s.input().parameter; })
        .def_property_readonly("conservative", [](const BoundStructure& s) { return s.input().conservative; })
        .def_property_readonly("measured", [](const BoundStructure& s) { return s.input().measured; })
        .def_property_readonly("window",
                               [](const BoundStructure& s) { return py::make_tuple(s.input().low, s.input().high); })
        .def_property_readonly("directions",
                               [](const BoundStructure& s) { return py::make_tuple(s.input().up, s.input().down); })
        .def_property_readonly("steps",
                               [](const BoundStructure& s) {
                                   const auto o = fem::continuation_options(s.input());
                                   return py::make_tuple(o.branch.first_step, o.branch.largest_step,
                                                         o.branch.parameter_weight);
                               })
        .def_property_readonly("loaded", &BoundStructure::loaded)
        .def_property_readonly("drawn", &BoundStructure::drawn)
        .def_property_readonly("lines", &BoundStructure::lines)
        .def_property_readonly("size", &BoundStructure::size)
        .def("results", &BoundStructure::results, py::arg("position"), py::arg("rotation"), py::arg("multipliers"),
             py::arg("p"))
        .def(
            "follow",
            [](const BoundStructure& s, int direction, double low, double high, int most_steps, double first_step,
               double largest_step, double parameter_weight) {
                return s.follow(
                    direction, continuation_options(low, high, most_steps, first_step, largest_step, parameter_weight));
            },
            py::arg("direction"), py::arg("low"), py::arg("high"), py::arg("most_steps"), py::arg("first_step"),
            py::arg("largest_step"), py::arg("parameter_weight"))
        .def(
            "diagram",
            [](const BoundStructure& s, double low, double high, int most_steps, double first_step, double largest_step,
               double parameter_weight, int most_branches, int slices, int checks, double amplitude) {
                DiagramOptions options;
                options.continuation =
                    continuation_options(low, high, most_steps, first_step, largest_step, parameter_weight);
                options.most_branches = most_branches;
                options.slices = slices;
                options.checks = checks;
                options.checks = checks;
                options.amplitude = amplitude;
                return s.diagram(options);
            },
            py::arg("low"), py::arg("high"), py::arg("most_steps"), py::arg("first_step"), py::arg("largest_step"),
            py::arg("parameter_weight"), py::arg("most_branches"), py::arg("slices"), py::arg("checks"),
            py::arg("amplitude"));
}

}  // namespace equilibria::python
