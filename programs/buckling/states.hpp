// The states of a structure that are written with all that engineers read off them: critical points, asked-for places
// and the ends of branches.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/io/structure/structure_results.hpp>

#include "support/tracing.hpp"

template <class S>
class StateRows {
public:
    StateRows(const S& structure, const equilibria::fem::StructureInput& input)
        : structure_(&structure), input_(&input) {}

    /// Lets a tracing report to this, besides whom it reports to already.
    void watch(support::Tracing<S>& tracing) {
        tracing.observe = [this, before = std::move(tracing.observe)](std::size_t branch, const auto& q, double p,
                                                                      const std::string& at) {
            if (before) before(branch, q, p, at);
            if (last_ && last_->branch != branch) finish();
            if (!at.empty()) add(branch, at, q, p);
            last_ = {branch, p, q};
        };
        tracing.observe_critical = [this](std::size_t branch, const auto& point) {
            finish();
            add(branch, to_string(point.kind), point.q, point.p);
        };
    }
    /// "branch", "at" (a critical point's kind, the place that was asked for, or "end"), "parameter", and the keys of
    /// structure_results.
    std::vector<equilibria::Json> take() {
        finish();
        return std::move(rows_);
    }

private:
    struct Last {
        std::size_t branch;
        double p;
        equilibria::fem::StructureState q;
    };
    void finish() {
        if (last_) add(last_->branch, "end", last_->q, last_->p);
        last_.reset();
    }
    void add(std::size_t branch, const std::string& at, const equilibria::fem::StructureState& q, double p) {
        equilibria::Json row = structure_results(*structure_, *input_, q, p);
        row["branch"] = branch;
        row["at"] = at;
        row["parameter"] = equilibria::json_of(p);
        rows_.push_back(std::move(row));
    }

    const S* structure_;
    const equilibria::fem::StructureInput* input_;
    std::optional<Last> last_;
    std::vector<equilibria::Json> rows_;
};
