/// \file
/// Proofs about a set of roots: that each exists, is distinct from the others, is real or not, and has its index; and,
/// where a proved bound is reached, that none is missing. Nothing of the tracker is believed: roots are candidates.
///
/// Each root is tested in doubles, then, where that is not enough, with 34 and 68 digits. A real candidate is tested
/// around a real point, so that the root is its own conjugate; any other must have an enclosure without real points.
/// Singular roots cannot be proved this way: they stay undecided, and a set that holds one is never complete.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include <equilibria/certify/certificate.hpp>
#include <equilibria/certify/enclosure.hpp>
#include <equilibria/certify/newton.hpp>
#include <equilibria/certify/proved_bound.hpp>
#include <equilibria/certify/proved_index.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/classify.hpp>
#include <equilibria/enumerate/root_set.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/run_options.hpp>

namespace equilibria {

struct ProveOptions {
    int most_digits = 68;  ///< the most decimal digits that a proof may take: 15 (doubles), 34 or 68

    void validate() const {
        require(most_digits == 15 || most_digits == 34 || most_digits == 68, "most_digits", most_digits,
                "must be 15, 34 or 68");
    }
};

/// What is proved of a set of roots. Every number counts proofs.
template <Model M>
struct Proof {
    std::vector<Certificate> certificates;  ///< of set.roots, in their order
    std::uint64_t distinct = 0;             ///< roots proved to exist and to differ from each other
    std::uint64_t real = 0, non_real = 0;   ///< among those
    std::uint64_t undecided = 0;         ///< roots of the set of which neither is proved; real + non_real + undecided
                                         ///< + duplicates is the number of roots in the set
    std::uint64_t duplicates = 0;        ///< proved roots that could not be told from an earlier one
    std::uint64_t index = 0;             ///< real roots with a proved index
    std::uint64_t contradictions = 0;    ///< roots of which something else is proved than the enumeration says
    std::uint64_t more_digits = 0;       ///< roots that doubles were not enough for
    std::vector<std::int64_t> by_index;  ///< real roots by their proved index
    std::optional<ProvedBound> bound;    ///< of the number of isolated complex roots
    bool complete = false;               ///< no root is missing: `distinct` is the bound
    std::string reason;                  ///< why, or why not, in words
    double seconds = 0;

    friend std::ostream& operator<<(std::ostream& out, const Proof& p) {
        return out << p.distinct << " distinct roots proved, " << p.real << " real, " << p.non_real << " non-real, "
                   << p.undecided << " undecided, " << p.index << " with their index; "
                   << (p.complete ? "complete: " : "not proved complete: ") << p.reason;
    }
};

namespace detail {

template <Model M>
class Prover {
public:
    using Pack = Lanes<native_lanes>;
    static constexpr int n = n_unknowns<M>;
    static constexpr int most_digits = 68;
    using Most = Multiprecision<most_digits>;

    Prover(const RootSet<M>& set, const RunOptions& run, const ProveOptions& options)
        : set_(set), run_(run), options_(options), exact_(ExactSystem<M>::at(set.parameters)), system_(exact_) {}

    Proof<M> run() {
        const detail::Stopwatch begin;
        const std::size_t size = set_.roots.size();
        proof_.certificates.resize(size);
        enclosures_.resize(size);
        for (std::size_t k = 0; k < size; ++k) proof_.certificates[k].path = set_.roots[k].path;
        std::vector<std::size_t> real, other;
        for (std::size_t k = 0; k < size; ++k) {
            if (set_.roots[k].status == PathStatus::singular) continue;
            (largest_imaginary(set_.roots[k]) < 1e-8 ? real : other).push_back(k);
        }
        in_packs(real, true);
        for (const std::size_t k : real)
            if (!proof_.certificates[k].exists) other.push_back(k);
        in_packs(other, false);
        std::vector<std::size_t> hard;
        for (std::size_t k = 0; k < size; ++k)
            if (set_.roots[k].status != PathStatus::singular && !settled(k)) hard.push_back(k);
        with_more_digits(hard);
        tell_apart();
        count();
        conclude();
        proof_.seconds = begin.seconds();
        return std::move(proof_);
    }

private:
    /// Nothing is left that more digits could decide.
    bool settled(std::size_t k) const {
        const Certificate& c = proof_.certificates[k];
        if (!c.exists || c.reality == Reality::undecided) return false;
        return !PotentialModel<M> || c.reality == Reality::non_real || c.index_proved;
    }

    template <class R>
    void record(std::size_t k, const KrawczykResult<M, R>& proof, int lane_of, bool real, int digits) {
        using S = typename LaneTraits<R>::Scalar;
        if (!mask_lane(proof.proved, lane_of)) return;
        Certificate& c = proof_.certificates[k];
        const auto enclosure = Enclosure<M, S>::of(proof, lane_of);
        c.exists = true;
        c.digits = digits;
        c.radius = 0;
        for (int u = 0; u < n; ++u) c.radius = std::max(c.radius, static_cast<double>(lane(proof.radius[u], lane_of)));
        if (real) {
            c.reality = Reality::real;
            if constexpr (PotentialModel<M>)
                if (const auto index = proved_index<M, R>(proof, lane_of)) {
                    c.index_proved = true;
                    c.index = *index;
                }
        } else {
            c.reality = enclosure.excludes_real_points() ? Reality::non_real : Reality::undecided;
        }
        enclosures_[k] = enclosure.template to<double>();
        if constexpr (std::is_same_v<S, Most>) {
            const std::lock_guard lock(guard_);
            sharp_.insert_or_assign(k, enclosure);
        }
    }

    /// The test in doubles, a root a lane.
    void in_packs(const std::vector<std::size_t>& members, bool real) {
        run_.executor.for_blocks(members.size(), 64 * native_lanes, [&](std::size_t first, std::size_t last) {
            for (std::size_t at = first; at < last; at += native_lanes) {
                Point<M, Pack> q;
                for (int l = 0; l < native_lanes; ++l) {
                    const auto& root = set_.roots[members[std::min(at + static_cast<std::size_t>(l), last - 1)]].q;
                    for (int i = 0; i < n_angles<M>; ++i) {
                        set_lane(q.c[i], l, real ? std::cos(root[i].real()) : std::cos(root[i]));
                        set_lane(q.s[i], l, real ? std::sin(root[i].real()) : std::sin(root[i]));
                    }
                    for (int j = 0; j < n_coordinates<M>; ++j) set_lane(q.x[j], l, root[n_angles<M> + j]);
                }
                const auto proof = krawczyk<M, Pack>(system_, q, real);
                for (int l = 0; l < native_lanes && at + static_cast<std::size_t>(l) < last; ++l)
                    record(members[at + static_cast<std::size_t>(l)], proof, l, real, 15);
            }
        });
    }

    void with_more_digits(const std::vector<std::size_t>& members) {
        if (members.empty() || options_.most_digits < 34) return;
        const BallSystem<M, Multiprecision<34>> twice(exact_);
        const BallSystem<M, Most> most(exact_);
        run_.executor.for_blocks(members.size(), 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t at = first; at < last; ++at) {
                const std::size_t k = members[at];
                with_digits<34>(twice, k);
                if (!settled(k) && options_.most_digits >= most_digits) with_digits<most_digits>(most, k);
            }
        });
        proof_.more_digits += members.size();
    }
    template <int Digits>
    void with_digits(const BallSystem<M, Multiprecision<Digits>>& system, std::size_t k) {
        using S = Multiprecision<Digits>;
        ComplexUnknowns<M, S> q = unknowns_of<M, S>(set_.roots[k].q);
        const S last = newton(system, q, 100);
        if (!(last < S(1e-3))) return;
        S size(0);
        for (const auto& z : q) size = std::max(size, z.im < 0 ? S(-z.im) : z.im);
        const Point<M, S> point = point_of<M, S>(q);
        // a root nearer to the real points than Newton's method can tell is tried as a real one first
        if (size <= sqrt(rounding_unit<S>)) record(k, krawczyk<M, S>(system, point, true), 0, true, Digits);
        if (!settled(k) && proof_.certificates[k].reality != Reality::real)
            record(k, krawczyk<M, S>(system, point, false), 0, false, Digits);
    }

    /// Marks the roots that differ from all before them.
    void tell_apart() {
        std::vector<std::size_t> member;
        std::vector<Enclosure<M, double>> boxes;
        for (std::size_t k = 0; k < enclosures_.size(); ++k)
            if (proof_.certificates[k].exists) {
                member.push_back(k);
                boxes.push_back(enclosures_[k]);
            }
        std::vector<std::vector<std::size_t>> groups(member.size());
        const auto first = groups_of_enclosures<M>(boxes);
        for (std::size_t k = 0; k < member.size(); ++k) groups[first[k]].push_back(member[k]);
        std::vector<std::size_t> close;
        for (const auto& group : groups)
            if (group.size() > 1) close.insert(close.end(), group.begin(), group.end());
        if (options_.most_digits >= most_digits && !close.empty()) {
            const BallSystem<M, Most> most(exact_);
            for (const std::size_t k : close)
                if (!sharp_.contains(k)) with_digits<most_digits>(most, k);
        }
        for (const auto& group : groups)
            for (std::size_t a = 0; a < group.size(); ++a) {
                bool apart = true;
                for (std::size_t b = 0; b < a && apart; ++b) apart = differ(group[a], group[b]);
                proof_.certificates[group[a]].distinct = apart;
            }
    }
    bool differ(std::size_t a, std::size_t b) const {
        const auto i = sharp_.find(a), j = sharp_.find(b);
        return i != sharp_.end() && j != sharp_.end() ? disjoint(i->second, j->second)
                                                      : disjoint(enclosures_[a], enclosures_[b]);
    }

    void count() {
        if constexpr (PotentialModel<M>) proof_.by_index.assign(static_cast<std::size_t>(n) + 1, 0);
        for (const Certificate& c : proof_.certificates) {
            if (!c.exists) {
                ++proof_.undecided;
                continue;
            }
            if (!c.distinct) {
                ++proof_.duplicates;
                continue;
            }
            ++proof_.distinct;
            proof_.real += c.reality == Reality::real;
            proof_.non_real += c.reality == Reality::non_real;
            proof_.undecided += c.reality == Reality::undecided;
            proof_.index += c.index_proved;
            if (c.index_proved) ++proof_.by_index[static_cast<std::size_t>(c.index)];
        }
        // the classification's own view
        std::map<std::uint64_t, const Equilibrium<M>*> equilibrium;
        for (const auto& e : set_.equilibria) equilibrium.emplace(e.path, &e);
        for (const Certificate& c : proof_.certificates) {
            const auto at = equilibrium.find(c.path);
            const bool real = at != equilibrium.end();
            proof_.contradictions +=
                (c.reality == Reality::real && !real) || (c.reality == Reality::non_real && real) ||
                (c.index_proved && real && !at->second->degenerate() && at->second->index != c.index);
        }
    }

    void conclude() {
        const auto count = [](std::uint64_t k) { return std::to_string(k); };
        proof_.bound = total_degree_bound<M>(exact_);
        if (!proof_.bound) {
            proof_.reason = "an equation vanishes at these parameters, or the bound is too large to count";
            return;
        }
        if (proof_.distinct < proof_.bound->value) proof_.bound = smallest_proved_bound<M>(exact_);
        const std::string bound = "the " + proof_.bound->name + " " + count(proof_.bound->value);
        proof_.complete = proof_.distinct == proof_.bound->value;
        if (proof_.complete)
            proof_.reason = count(proof_.distinct) + " roots are proved to be distinct, as many as " + bound +
                            " allows: by " + proof_.bound->theorem + " theorem there is no other";
        else if (proof_.distinct == set_.roots.size())
            proof_.reason = "all " + count(proof_.distinct) + " roots found are proved, but the best bound known, " +
                            bound + ", allows more";
        else
            proof_.reason = count(proof_.distinct) + " of " + count(set_.roots.size()) +
                            " roots are proved to be distinct, and " + bound + " allows more";
    }

    const RootSet<M>& set_;
    RunOptions run_;
    ProveOptions options_;
    ExactSystem<M> exact_;
    BallSystem<M, double> system_;
    Proof<M> proof_;
    std::vector<Enclosure<M, double>> enclosures_;
    std::map<std::size_t, Enclosure<M, Most>> sharp_;  // those that took the most digits
    std::mutex guard_;
};

}  // namespace detail

/// Proves what can be proved of the roots of an enumeration. Throws InvalidArgument for options out of range, and for a
/// run with a checkpoint or a cancel.
template <Model M>
Proof<M> prove(const RootSet<M>& set, const RunOptions& run = {}, const ProveOptions& options = {}) {
    options.validate();
    run.require_whole("a proof");
    return detail::Prover<M>(set, run, options).run();
}

}  // namespace equilibria
