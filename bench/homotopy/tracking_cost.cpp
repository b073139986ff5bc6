// Where the time of tracking goes: the benchmark chain from its reflected start, its steps counted and timed, by parts.
//
//   tracking_cost [--links FROM:TO] [--sample PATHS] [--json]   counts, times, shares
//   tracking_cost --links N --sample PATHS --once               tracks them once in packs of doubles, for other tools
//   tracking_cost --links N --sample PATHS --once-single        the same in packs of floats
//
// Counts come from scalars that count (watched.hpp); times from packs that do nothing else, the best of several runs;
// shares of parts from packs that say which part is at work, to a clock that looks every 100 us.
#include <signal.h>
#include <time.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

#include <equilibria/homotopy/lane_tracker.hpp>
#include <equilibria/homotopy/model_homotopy.hpp>
#include <equilibria/mechanisms/rotating_chain.hpp>
#include <equilibria/start/total_degree.hpp>

#include "../chain_parameters.hpp"
#include "watched.hpp"

using namespace equilibria;

namespace {

using Plain = TrackedBy<watched::CountedTracking, PolynomialHomotopy>;
constexpr int single_lanes = 2 * native_lanes;
using Pack = Lanes<native_lanes>;
using SinglePack = FloatLanes<single_lanes>;

/// The paths of a chain, all of them or as many as asked for, evenly.
class Paths {
public:
    Paths(int n, std::uint64_t most)
        : formulation_(mechanisms::RuntimeRotatingChain{n}),
          target_(formulation_, mechanisms::RuntimeRotatingChain{n}, chain_parameters(n)),
          start_(TotalDegreeKind::reflected, formulation_.sizes(), formulation_.degrees(), target_.scale, generator_),
          homotopy_(model_homotopy(mechanisms::RuntimeRotatingChain{n}, target_, start_)), single_(homotopy_.scaled()),
          all_(start_.numbering().tracked()), numbers_(std::min(all_, most)) {
        for (std::uint64_t k = 0; k < numbers_.size(); ++k) numbers_[k] = k * (all_ / numbers_.size());
    }

    std::uint64_t all() const { return all_; }
    std::uint64_t size() const { return numbers_.size(); }

    /// Tracks the first `number` of them. In single precision by the homotopy that is scaled for it.
    template <class R, class H>
    std::vector<Endpoint> track(std::size_t number) const {
        const H homotopy(is_single<R> ? single_ : homotopy_);
        std::vector<Endpoint> ends(std::min(number, numbers_.size()));
        track_lanes<R, false>(
            homotopy, TrackerOptions{}, std::span(numbers_).first(ends.size()),
            [this](std::uint64_t k) {
                const watched::In part(watched::starts);
                return start_.point(k);
            },
            std::span(ends));
        return ends;
    }

private:
    Generator generator_{1};
    RuntimeFormulation formulation_;
    RuntimeModelSystem target_;
    TotalDegreeStart start_;
    PolynomialHomotopy homotopy_, single_;
    std::uint64_t all_;
    std::vector<std::uint64_t> numbers_;
};

std::uint64_t steps_of(const std::vector<Endpoint>& ends) {
    return std::accumulate(ends.begin(), ends.end(), std::uint64_t(0),
                           [](std::uint64_t sum, const Endpoint& end) { return sum + std::uint64_t(end.steps); });
}
/// Of this processor's time, so that other programs do not count.
class Clock {
public:
    double seconds() const { return now() - begin_; }

private:
    static double now() {
        timespec t{};
        clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
        return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    }
    double begin_ = now();
};
double ratio(auto a, auto b) { return static_cast<double>(a) / static_cast<double>(b); }

/// How many steps, and which of them were refused; scalar, so that no lane is idle.
struct Steps {
    double a_path = 0, refused = 0, at_end = 0;  ///< the last two as shares: of steps, of paths
};
template <class R>
Steps count_steps(const Paths& paths) {
    watched::judged = watched::refused = 0;
    const auto ends = paths.track<R, Plain>(paths.size());
    const auto arrived = std::count_if(ends.begin(), ends.end(), [](auto& end) { return end.arrival == Arrival::end; });
    return {ratio(steps_of(ends), ends.size()), ratio(watched::refused, watched::judged), ratio(arrived, ends.size())};
}

struct Counts {
    std::array<watched::Operations, watched::n_parts> operations;
    std::array<double, watched::n_parts> calls;
    std::uint64_t steps;

    double of(std::uint64_t watched::Operations::* what) const {
        std::uint64_t sum = 0;
        for (const auto& part : operations) sum += part.*what;
        return ratio(sum, steps);
    }
    double flops(std::size_t part) const { return ratio(operations[part].flops(), steps); }
    double flops() const {
        double sum = 0;
        for (std::size_t k = 0; k < watched::n_parts; ++k) sum += flops(k);
        return sum;
    }
};
/// A step costs the same operations whatever the path: few paths are enough.
Counts count_operations(const Paths& paths) {
    watched::operations = {};
    watched::calls = {};
    watched::judged = 0;
    paths.track<watched::Watched<double>, watched::WatchedHomotopy>(256);
    Counts y{watched::operations, {}, watched::judged};
    for (std::size_t k = 0; k < watched::n_parts; ++k) y.calls[k] = ratio(watched::calls[k], y.steps);
    return y;
}

/// What a pack's step takes.
struct Timing {
    int width;
    double step;  ///< seconds
    double full;  ///< share of the lanes' steps that are of paths
};
template <class R>
Timing time_steps(const Paths& paths, double seconds = 0.4) {
    Timing y{LaneTraits<R>::width, 1e30, 0};
    double spent = 0;
    for (int run = 0; run < 5 || (spent < seconds && run < 10000); ++run) {
        watched::judged = 0;
        const Clock clock;
        const auto ends = paths.track<R, Plain>(paths.size());
        const double now = clock.seconds();
        spent += now;
        y.step = std::min(y.step, now / static_cast<double>(watched::judged));
        y.full = ratio(steps_of(ends), watched::judged * LaneTraits<R>::width);
    }
    return y;
}

/// Shares of the time, of each part.
using Shares = std::array<double, watched::n_parts>;
std::array<volatile std::uint64_t, watched::n_parts> seen;

template <class V>
Shares share_time(const Paths& paths, double seconds = 1) {
    struct sigaction action{}, before{};
    action.sa_handler = [](int) {
        auto& here = seen[static_cast<std::size_t>(watched::at_work)];
        here = here + 1;
    };
    action.sa_flags = SA_RESTART;
    sigaction(SIGALRM, &action, &before);
    for (auto& part : seen) part = 0;
    timer_t timer{};
    timer_create(CLOCK_MONOTONIC, nullptr, &timer);
    const itimerspec every{{0, 100'000}, {0, 100'000}};
    timer_settime(timer, 0, &every, nullptr);
    for (const Clock clock; clock.seconds() < seconds;)
        paths.track<watched::Watched<V, false>, watched::WatchedHomotopy>(paths.size());
    timer_delete(timer);
    sigaction(SIGALRM, &before, nullptr);
    Shares y{};
    const std::uint64_t all = std::accumulate(seen.begin(), seen.end(), std::uint64_t(0));
    for (std::size_t k = 0; k < y.size(); ++k) y[k] = ratio(seen[k], all);
    return y;
}

/// Flops a second of one core: independent fused multiplications and additions of packs, in registers alone.
template <class V>
double peak() {
    constexpr int turns = 1 << 20, chains = 16;
    double best = 0;
    for (int run = 0; run < 20; ++run) {
        V a[chains] = {}, factor = V{} + 1, by = V{};
        const Clock clock;
        [&]<std::size_t... k>(std::index_sequence<k...>) {
            (..., [&] { asm volatile("" : "+v"(a[k])); }());  // different ones, for all that g++ knows
            for (int turn = 0; turn < turns; ++turn) {
                asm volatile("" : "+v"(factor), "+v"(by));
                ((a[k] = a[k] * factor + by), ...);
            }
            (..., [&] { asm volatile("" : "+v"(a[k])); }());
        }(std::make_index_sequence<chains>());
        const double flops = 2.0 * turns * chains * sizeof(V) / sizeof(typename watched::ScalarOf<V>::type);
        best = std::max(best, flops / clock.seconds());
    }
    return best;
}

struct Report {
    int links;
    std::uint64_t all, sample;
    Steps steps, single_steps;
    Counts counts;
    std::vector<Timing> timings;  ///< of doubles; that of Pack first
    std::vector<Timing> single_timings;
    Shares shares, single_shares;
};

Report report(int n, std::uint64_t most) {
    const Paths paths(n, most);
    return {.links = n,
            .all = paths.all(),
            .sample = paths.size(),
            .steps = count_steps<double>(paths),
            .single_steps = count_steps<watched::Watched<float, false>>(paths),
            .counts = count_operations(paths),
            .timings = {time_steps<Pack>(paths), time_steps<Lanes<native_lanes / 2>>(paths)},
            .single_timings = {time_steps<SinglePack>(paths), time_steps<FloatLanes<single_lanes / 2>>(paths)},
            .shares = share_time<Pack>(paths),
            .single_shares = share_time<SinglePack::Values>(paths)};
}

struct Peaks {
    double of_double = peak<Pack>(), of_float = peak<SinglePack::Values>();
};

void print_table(const std::vector<Report>& reports, const Peaks& peaks) {
    using watched::Operations;
    const auto rows = [&](const char* title, auto&& row) {
        std::printf("\n%s\n", title);
        for (const Report& r : reports) std::printf("%5d", r.links), row(r), std::printf("\n");
    };
    std::printf("peak of one core: %.1f Gflop/s in packs of %d doubles, %.1f in packs of %d floats\n",
                peaks.of_double / 1e9, native_lanes, peaks.of_float / 1e9, single_lanes);
    rows("links  tracked   sample  steps/path  refused  to t=1 | single: steps/path  refused  to t=1", [](auto& r) {
        std::printf(" %9llu %8llu %11.2f %7.2f%% %6.1f%% | %18.2f %7.2f%% %6.1f%%",
                    static_cast<unsigned long long>(r.all), static_cast<unsigned long long>(r.sample), r.steps.a_path,
                    100 * r.steps.refused, 100 * r.steps.at_end, r.single_steps.a_path, 100 * r.single_steps.refused,
                    100 * r.single_steps.at_end);
    });
    rows(
        "links  a step: Jacobians  factors  solves  values  additions  multiplications  divisions  roots     flops"
        "  kflops/path",
        [](auto& r) {
            const Counts& c = r.counts;
            std::printf("            %9.2f %8.2f %7.2f %7.2f %10.0f %16.0f %10.1f %6.2f %9.0f %12.0f",
                        c.calls[watched::jacobians], c.calls[watched::factors], c.calls[watched::solves],
                        c.calls[watched::values], c.of(&Operations::additions), c.of(&Operations::multiplications),
                        c.of(&Operations::divisions), c.of(&Operations::roots), c.flops(),
                        c.flops() * r.steps.a_path / 1e3);
        });
    const auto times = [&](const char* title, auto timings, double most) {
        std::printf("\n%s: us a step of a pack, Gflop/s of all lanes, share of the peak, lanes filled;", title);
        rows("links   us/step   Gflop/s   peak  filled  | us of half the lanes", [&](auto& r) {
            const auto& t = r.*timings;
            const double rate = r.counts.flops() * t[0].width / t[0].step;
            std::printf(" %9.3f %9.1f %5.1f%% %6.1f%%  |", 1e6 * t[0].step, rate / 1e9, 100 * rate / most,
                        100 * t[0].full);
            for (std::size_t k = 1; k < t.size(); ++k) std::printf(" %9.3f", 1e6 * t[k].step);
        });
    };
    times("double", &Report::timings, peaks.of_double);
    times("single", &Report::single_timings, peaks.of_float);
    const auto parts = [&](const char* title, auto&& number) {
        std::printf("\n%s\nlinks", title);
        for (const auto& name : watched::part_names) std::printf(" %10s", name.data());
        std::printf("\n");
        for (const Report& r : reports) {
            std::printf("%5d", r.links);
            for (std::size_t k = 0; k < watched::n_parts; ++k) std::printf(" %10.1f", number(r, k));
            std::printf("\n");
        }
    };
    parts("flops a step", [](auto& r, std::size_t k) { return r.counts.flops(k); });
    parts("percent of the time, double", [](auto& r, std::size_t k) { return 100 * r.shares[k]; });
    parts("percent of the time, single", [](auto& r, std::size_t k) { return 100 * r.single_shares[k]; });
    parts("percent of the peak, double", [&](auto& r, std::size_t k) {
        return 100 * r.counts.flops(k) * native_lanes / (r.shares[k] * r.timings[0].step * peaks.of_double);
    });
    parts("percent of the peak, single", [&](auto& r, std::size_t k) {
        return 100 * r.counts.flops(k) * single_lanes /
               (r.single_shares[k] * r.single_timings[0].step * peaks.of_float);
    });
}

void print_json(const std::vector<Report>& reports, const Peaks& peaks) {
    using watched::Operations;
    std::printf(
        "{\"peak_flops\": %.4g, \"single_peak_flops\": %.4g, \"lanes\": %d, \"single_lanes\": %d,\n"
        " \"chains\": [",
        peaks.of_double, peaks.of_float, native_lanes, single_lanes);
    const char* between = "";
    for (const Report& r : reports) {
        std::printf("%s\n  {\"links\": %d, \"tracked\": %llu, \"sample\": %llu,\n", between, r.links,
                    static_cast<unsigned long long>(r.all), static_cast<unsigned long long>(r.sample));
        between = ",";
        const auto steps = [](const char* name, const Steps& s) {
            std::printf("   \"%s\": {\"per_path\": %.6g, \"refused\": %.6g, \"at_end\": %.6g},\n", name, s.a_path,
                        s.refused, s.at_end);
        };
        steps("steps", r.steps);
        steps("single_steps", r.single_steps);
        const auto times = [](const char* name, const std::vector<Timing>& timings) {
            std::printf("   \"%s\": [", name);
            for (std::size_t k = 0; k < timings.size(); ++k)
                std::printf("%s{\"lanes\": %d, \"seconds_per_step\": %.6g, \"filled\": %.6g}", k ? ", " : "",
                            timings[k].width, timings[k].step, timings[k].full);
            std::printf("],\n");
        };
        times("timings", r.timings);
        times("single_timings", r.single_timings);
        std::printf(
            "   \"per_step\": {\"additions\": %.6g, \"multiplications\": %.6g, \"divisions\": %.6g, "
            "\"roots\": %.6g, \"comparisons\": %.6g},\n   \"parts\": {",
            r.counts.of(&Operations::additions), r.counts.of(&Operations::multiplications),
            r.counts.of(&Operations::divisions), r.counts.of(&Operations::roots),
            r.counts.of(&Operations::comparisons));
        for (std::size_t k = 0; k < watched::n_parts; ++k)
            std::printf("%s\n    \"%s\": {\"calls\": %.6g, \"flops\": %.6g, \"time\": %.4g, \"single_time\": %.4g}",
                        k ? "," : "", watched::part_names[k].data(), r.counts.calls[k], r.counts.flops(k), r.shares[k],
                        r.single_shares[k]);
        std::printf("}}");
    }
    std::printf("]}\n");
}

}  // namespace

int main(int argc, char** argv) {
    int from = 2, to = 10;
    std::uint64_t most = 4096;
    bool json = false, once = false, once_single = false;
    const auto number = [](std::string_view text, auto& y) {
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), y);
        return error == std::errc() && end == text.data() + text.size();
    };
    for (int k = 1; k < argc; ++k) {
        const std::string_view option = argv[k];
        bool known = true;
        if (option == "--json") {
            json = true;
        } else if (option == "--once" || option == "--once-single") {
            (option == "--once" ? once : once_single) = true;
        } else if (option == "--sample" && k + 1 < argc) {
            known = number(argv[++k], most) && most > 0;
        } else if (option == "--links" && k + 1 < argc) {
            const std::string_view range = argv[++k];
            const std::size_t colon = range.find(':');
            known = number(range.substr(0, colon), from);
            to = from;
            if (colon != range.npos) known = known && number(range.substr(colon + 1), to);
            known = known && from >= 2 && to >= from && to <= 12;
        } else {
            known = false;
        }
        if (!known) {
            std::fprintf(stderr,
                         "usage: tracking_cost [--links FROM:TO] [--sample PATHS] [--json | --once | --once-single]\n");
            return 2;
        }
    }
    if (once || once_single) {
        const Paths paths(from, most);
        const auto ends = once ? paths.track<Pack, Plain>(paths.size()) : paths.track<SinglePack, Plain>(paths.size());
        std::printf("%llu steps of packs, %llu of paths\n", static_cast<unsigned long long>(watched::judged),
                    static_cast<unsigned long long>(steps_of(ends)));
        return 0;
    }
    const Peaks peaks;
    std::vector<Report> reports;
    for (int n = from; n <= to; ++n) reports.push_back(report(n, most));
    json ? print_json(reports, peaks) : print_table(reports, peaks);
}
