/// \file
/// See locus/plane/trace_locus.hpp.
#pragma once

#include <equilibria/core/error.hpp>
#include <equilibria/locus/plane/locus_tracer.hpp>
#include <equilibria/locus/plane/trace_locus.hpp>

namespace equilibria {

EQUILIBRIA_INLINE Locus<RuntimeUnknowns> trace_locus(const SearchedModel& model, const RuntimeArray<double>& p,
                                                     std::span<const int> active, const Window& window,
                                                     const RunOptions& run, const LocusOptions& options) {
    require_finite(p, "parameters");
    window.validate();
    options.validate();
    run.require_alone("a locus");
    require(active.size() == 2, "active parameters", active.size(), "must be two");
    return detail::LocusTracer(model, active, p, window, run, options).run();
}

}  // namespace equilibria
