/// \file
/// See enumerate/prove.hpp.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <utility>
#include <vector>

#include <equilibria/certify/enclosure.hpp>
#include <equilibria/certify/krawczyk.hpp>
#include <equilibria/certify/newton.hpp>
#include <equilibria/certify/proved_index.hpp>
#include <equilibria/core/multiprecision.hpp>
#include <equilibria/enumerate/detail/mirror_images.hpp>
#include <equilibria/enumerate/prove.hpp>
#include <equilibria/evaluation/point_of.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/mutex.hpp>
#include <equilibria/run/ranks.hpp>
#include <equilibria/storage/endpoint_bytes.hpp>

namespace equilibria {

namespace detail {

class Prover {
public:
    using Pack = Lanes<native_lanes>;
    static constexpr int most_digits = 68;
    using Most = Multiprecision<most_digits>;

    Prover(const RootsToProve& set, const RunOptions& run, const ProveOptions& options)
        : set_(set), sizes_(set.equations.sizes), run_(run), options_(options), system_(set.equations),
          form_(sizes_.unknowns) {}

    ProofOfRoots run() {
        const Stopwatch begin;
        const std::size_t size = set_.roots.size();
        proof_.certificates.resize(size);
        intervals_.resize(size);
        for (std::size_t k = 0; k < size; ++k) proof_.certificates[k].path = set_.roots[k].path;
        // where F is odd the image of a root is a root, as its own proof shows, turned round
        if (set_.equations.odd())
            mirror_.emplace(size, [this](std::size_t k) {
                return set_.roots[k].singular ? MirrorImages::Unknowns() : set_.roots[k].q;
            });
        std::vector<std::size_t> real, other;
        for (std::size_t k = 0; k < size; ++k) {
            if (set_.roots[k].singular || is_image(k)) continue;
            (largest_imaginary(set_.roots[k].q) < 1e-8 ? real : other).push_back(k);
        }
        in_packs(real, true);
        for (const std::size_t k : real)
            if (!proof_.certificates[k].exists) other.push_back(k);
        in_packs(other, false);
        std::vector<std::size_t> hard;
        for (std::size_t k = 0; k < size; ++k)
            if (!set_.roots[k].singular && !is_image(k) && !settled(k)) hard.push_back(k);
        if (!others_may_exist(hard)) std::erase_if(hard, [this](std::size_t k) { return !exists(k); });
        with_more_digits(hard);
        certify_images();
        tell_apart();
        std::ranges::sort(proof_.moved, {}, &MovedRoot::root);
        count();
        conclude_proof(proof_, size, set_.bound, [this] { return best_bound(); });
        proof_.seconds = begin.seconds();
        return std::move(proof_);
    }

private:
    static double largest_imaginary(std::span<const std::complex<double>> q) {
        double y = 0;
        for (const auto& z : q) y = std::max(y, std::abs(z.imag()));
        return y;
    }
    bool has_index() const { return set_.equations.symmetric; }
    bool is_image(std::size_t k) const { return mirror_ && mirror_->is_image[k]; }
    bool has_image(std::size_t k) const { return mirror_ && mirror_->image[k] != MirrorImages::none; }
    bool exists(std::size_t k) const { return proof_.certificates[k].exists; }
    /// Nothing is left that more digits could decide.
    bool settled(std::size_t k) const {
        const Certificate& c = proof_.certificates[k];
        if (!c.exists || c.reality == Reality::undecided) return false;
        return !has_index() || c.reality == Reality::non_real || c.index_proved;
    }

    /// What lane `l` of a proof says of root k; excluded: its enclosure holds no real point.
    template <class R>
    void record(std::size_t k, const KrawczykResult<R>& proof, int l, bool real, bool excluded, int digits) {
        Certificate& c = proof_.certificates[k];
        c.exists = true;
        c.digits = digits;
        c.radius = 0;
        for (const R& radius : proof.radius) c.radius = std::max(c.radius, static_cast<double>(lane(radius, l)));
        if (real) {
            c.reality = Reality::real;
            const auto index = has_index() ? proved_index(proof, l) : std::nullopt;
            if (index) {
                c.index_proved = true;
                c.index = *index;
            }
        } else {
            c.reality = excluded ? Reality::non_real : Reality::undecided;
        }
    }

    /// Calls prove(first, last) for blocks of the members, at some rank; all know what it found. Enclosures that
    /// another rank kept are computed again where they are wanted, which is for few roots.
    template <class Prove>
    void over_ranks(const std::vector<std::size_t>& members, std::size_t block, const Prove& prove) {
        const auto each = [&](std::size_t which, auto&& archive) {
            for (std::size_t at = which * block; at < std::min(members.size(), (which + 1) * block); ++at) {
                const std::size_t k = members[at];
                transfer(archive, proof_.certificates[k], intervals_[k]);
                if (has_image(k)) transfer(archive, intervals_[mirror_->image[k]]);
            }
        };
        run_.ranks.for_blocks_at_all(
            (members.size() + block - 1) / block, run_.executor,
            [&](std::size_t which) { prove(which * block, std::min(members.size(), (which + 1) * block)); },
            [&](std::size_t which, Bytes& to) { each(which, Writer(to)); },
            [&](std::size_t which, Ranks::BytesView bytes) { each(which, Reader(bytes)); });
    }
    static void transfer(auto& archive, EnclosureInterval& interval) { archive(interval.low), archive(interval.high); }
    static void transfer(auto& archive, Certificate& c, EnclosureInterval& interval) {
        auto& [path, exists, distinct, reality, index_proved, index, digits, radius] = c;
        for (bool* flag : {&exists, &index_proved}) {
            auto byte = static_cast<std::uint8_t>(*flag);
            archive(byte);
            *flag = byte != 0;
        }
        archive(reality, Reality::non_real);
        archive(index), archive(digits), archive(radius);
        transfer(archive, interval);
    }

    /// The test in doubles, a root a lane. keep: the enclosures as well, not only their intervals.
    void in_packs(const std::vector<std::size_t>& members, bool real, bool keep = false) {
        over_ranks(members, 64 * native_lanes, [&](std::size_t first, std::size_t last) {
            KrawczykTest<Pack> test(system_);
            auto q = point_of_zeros<RuntimeUnknowns, Pack>(sizes_);
            for (std::size_t at = first; at < last; at += native_lanes) {
                for (int l = 0; l < native_lanes; ++l)
                    set_point(set_.roots[members[std::min(at + static_cast<std::size_t>(l), last - 1)]].q, real, q, l);
                const auto& proof = test(q, real);
                const auto excluded = excludes_real_points(proof);
                std::array<EnclosureInterval, native_lanes> intervals, images;
                form_.intervals(proof, false, intervals.data());
                if (mirror_) form_.intervals(proof, true, images.data());
                for (int l = 0; l < native_lanes && at + static_cast<std::size_t>(l) < last; ++l) {
                    if (!mask_lane(proof.proved, l)) continue;
                    const std::size_t k = members[at + static_cast<std::size_t>(l)];
                    record(k, proof, l, real, mask_lane(excluded, l), 15);
                    intervals_[k] = intervals[static_cast<std::size_t>(l)];
                    if (has_image(k)) intervals_[mirror_->image[k]] = images[static_cast<std::size_t>(l)];
                    if (keep) keep_enclosure(k, Enclosure<double>::of(proof, l));
                }
            }
        });
    }
    void set_point(std::span<const std::complex<double>> root, bool real, RuntimePoint<Pack>& q, int l) const {
        for (int i = 0; i < sizes_.angles; ++i) {
            const auto& angle = root[static_cast<std::size_t>(i)];
            Complex<double> c(std::cos(angle.real())), s(std::sin(angle.real()));
            if (!real) set_circle_point(angle.real(), angle.imag(), c, s);
            set_lane(q.c[i].re, l, c.re), set_lane(q.c[i].im, l, c.im);
            set_lane(q.s[i].re, l, s.re), set_lane(q.s[i].im, l, s.im);
        }
        for (int j = 0; j < sizes_.coordinates; ++j)
            set_lane(q.x[j], l, root[static_cast<std::size_t>(sizes_.angles + j)]);
    }
    /// Whether an enclosure holds another root than the one of before: with more digits Newton's method may lead from a
    /// singular point to another regular root, and what was compared is the first.
    bool is_elsewhere(std::size_t k, const Enclosure<double>& enclosure) {
        const detail::Lock lock(guard_);
        const auto before = enclosures_.find(k);
        return before != enclosures_.end() && disjoint(before->second, enclosure);
    }
    void keep_enclosure(std::size_t k, Enclosure<double> enclosure) {
        const detail::Lock lock(guard_);
        enclosures_.insert_or_assign(k, std::move(enclosure));
    }

    std::optional<ProvedBound> best_bound() {
        if (!best_) best_.emplace(set_.smallest_bound());
        return *best_;
    }
    /// Whether roots may exist beside those proved. Where as many are proved as the best bound allows, what is left
    /// over cannot be one, and more digits would not prove it. hard: the members that more digits are wanted for.
    bool others_may_exist(const std::vector<std::size_t>& hard) {
        if (!set_.bound || std::ranges::all_of(hard, [this](std::size_t k) { return exists(k); })) return true;
        std::uint64_t proved = 0;
        for (std::size_t k = 0; k < set_.roots.size(); ++k)
            proved += is_image(k) ? 0U : static_cast<unsigned>(exists(k)) * (has_image(k) ? 2U : 1U);
        const auto reached = [&](const std::optional<ProvedBound>& bound) {
            return bound && proved == bound->value && meeting(intervals_).empty();
        };
        // the best bound takes its time: it is asked for where it will be needed in any case
        return !reached(set_.bound) && (proved + 2 * hard.size() >= set_.bound->value || !reached(best_bound()));
    }
    void with_more_digits(const std::vector<std::size_t>& members) {
        if (members.empty() || options_.most_digits < 34) return;
        const BallSystem<Multiprecision<34>> twice(set_.equations);
        const BallSystem<Most> most(set_.equations);
        over_ranks(members, 1, [&](std::size_t first, std::size_t last) {
            for (std::size_t at = first; at < last; ++at) {
                const std::size_t k = members[at];
                with_digits<34>(twice, k);
                if (!settled(k) && options_.most_digits >= most_digits) with_digits<most_digits>(most, k);
            }
        });
        proof_.more_digits += members.size();
    }
    template <int Digits>
    void with_digits(const BallSystem<Multiprecision<Digits>>& system, std::size_t k) {
        using S = Multiprecision<Digits>;
        auto q = complex_unknowns<S>(set_.roots[k].q);
        const S last = newton(system, {q.begin(), q.end()}, 100);
        if (!(last < S(1e-3))) return;
        S size(0);
        for (const auto& z : q) size = std::max(size, z.im < 0 ? S(-z.im) : z.im);
        const auto point = point_of<RuntimeUnknowns, S>(q, sizes_);
        KrawczykTest<S> test(system);
        // a root nearer to the real points than Newton's method can tell is tried as a real one first
        if (size <= sqrt(rounding_unit<S>)) record_alone(k, test(point, true), true, Digits);
        if (!settled(k) && proof_.certificates[k].reality != Reality::real)
            record_alone(k, test(point, false), false, Digits);
        if (proof_.certificates[k].digits == Digits) move_to(k, q);
    }
    /// The root is known better than it was given: the certificate's radius is one around what was given.
    template <class S>
    void move_to(std::size_t k, const SizedArray<Complex<S>, at_run_time>& q) {
        Certificate& c = proof_.certificates[k];
        MovedRoot root{k, {}, c.radius};
        double moved = 0, rounding = 0;
        for (int u = 0; u < sizes_.unknowns; ++u) {
            const std::complex<double> given = set_.roots[k].q[static_cast<std::size_t>(u)];
            std::complex<double> at(static_cast<double>(q[u].re),
                                    c.reality == Reality::real ? 0.0 : static_cast<double>(q[u].im));
            rounding = std::max({rounding, std::abs(at.real()), std::abs(at.imag())});
            moved = std::max(moved, std::abs(at - given));
            root.q.push_back(at);
        }
        root.radius = rounded_up(root.radius + 2 * rounding_unit<double> * rounding);
        c.radius = rounded_up(root.radius + rounded_up(moved));
        const detail::Lock lock(guard_);
        proof_.moved.push_back(std::move(root));
    }
    template <class S>
    void record_alone(std::size_t k, const KrawczykResult<S>& proof, bool real, int digits) {
        if (!proof.proved) return;
        const auto enclosure = Enclosure<S>::of(proof, 0);
        auto rounded = enclosure.template to<double>();
        if (is_elsewhere(k, rounded)) return;
        record(k, proof, 0, real, excludes_real_points(proof), digits);
        intervals_[k] = form_(rounded);
        if (has_image(k)) {
            auto image = rounded;
            for (auto& at : image.unknowns) at.sine = -at.sine;
            intervals_[mirror_->image[k]] = form_(image);
        }
        keep_enclosure(k, std::move(rounded));
        if constexpr (std::is_same_v<S, Most>) {
            const detail::Lock lock(guard_);
            sharp_.insert_or_assign(k, enclosure);
        }
    }

    /// What is proved of a root holds of its image.
    void certify_images() {
        if (!mirror_) return;
        for (std::size_t k = 0; k < set_.roots.size(); ++k) {
            if (!has_image(k)) continue;
            const std::size_t image = mirror_->image[k];
            Certificate& c = proof_.certificates[image];
            const auto path = c.path;
            c = proof_.certificates[k];
            c.path = path;
            // the image of the double next to pi is not that double, but as far from it as 2 pi from twice that
            const auto turned = [](const auto& z) { return z.real() == std::numbers::pi; };
            if (c.exists && std::any_of(set_.roots[k].q.begin(), set_.roots[k].q.end(), turned))
                c.radius = rounded_up(c.radius + 2 * rounding_unit<double>);
        }
    }

    /// Marks the roots that differ from all before them.
    void tell_apart() {
        for (Certificate& c : proof_.certificates) c.distinct = c.exists;
        const std::vector<std::size_t> members = meeting(intervals_);
        if (members.empty()) return;
        prove_again(members);
        std::vector<Enclosure<double>> enclosures;
        for (const std::size_t k : members) enclosures.push_back(enclosures_.at(k));
        const std::vector<std::size_t> first = groups_of_enclosures(enclosures);
        std::map<std::size_t, std::vector<std::size_t>> groups;  // of two or more, by their first
        for (std::size_t m = 0; m < first.size(); ++m) {
            if (first[m] == m) continue;
            auto& group = groups[members[first[m]]];
            if (group.empty()) group.push_back(members[first[m]]);
            group.push_back(members[m]);
        }
        std::vector<std::size_t> close;
        for (const auto& [_, group] : groups) close.insert(close.end(), group.begin(), group.end());
        if (options_.most_digits >= most_digits && !close.empty()) {
            const BallSystem<Most> most(set_.equations);
            for (const std::size_t k : close)
                if (!sharp_.contains(k)) with_digits<most_digits>(most, k);
        }
        for (const auto& [_, group] : groups)
            for (std::size_t a = 0; a < group.size(); ++a) {
                bool apart = true;
                for (std::size_t b = 0; b < a && apart; ++b) apart = differ(group[a], group[b]);
                proof_.certificates[group[a]].distinct = apart;
            }
    }
    /// Those that may be the same, for their enclosures.
    void prove_again(const std::vector<std::size_t>& members) {
        std::vector<std::size_t> real, other;
        std::optional<BallSystem<Multiprecision<34>>> twice;
        std::optional<BallSystem<Most>> most;
        for (const std::size_t k : members) {
            if (enclosures_.contains(k)) continue;
            const Certificate& c = proof_.certificates[k];
            if (c.digits == 15) {
                (c.reality == Reality::real ? real : other).push_back(k);
            } else if (c.digits == 34) {  // images
                if (!twice) twice.emplace(set_.equations);
                with_digits<34>(*twice, k);
            } else {
                if (!most) most.emplace(set_.equations);
                with_digits<most_digits>(*most, k);
            }
        }
        in_packs(real, true, true);
        in_packs(other, false, true);
    }
    bool differ(std::size_t a, std::size_t b) const {
        const auto i = sharp_.find(a), j = sharp_.find(b);
        return i != sharp_.end() && j != sharp_.end() ? disjoint(i->second, j->second)
                                                      : disjoint(enclosures_.at(a), enclosures_.at(b));
    }

    void count() {
        if (has_index()) proof_.by_index.assign(static_cast<std::size_t>(sizes_.unknowns) + 1, 0);
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
        std::unordered_map<std::uint64_t, const RootsToProve::Classified*> equilibrium(2 * set_.equilibria.size());
        for (const auto& e : set_.equilibria) equilibrium.emplace(e.path, &e);
        for (const Certificate& c : proof_.certificates) {
            const auto at = equilibrium.find(c.path);
            const bool real = at != equilibrium.end();
            proof_.contradictions +=
                (c.reality == Reality::real && !real) || (c.reality == Reality::non_real && real) ||
                (c.index_proved && real && !at->second->degenerate && at->second->index != c.index);
        }
    }

    const RootsToProve& set_;
    RuntimeSizes sizes_;
    RunOptions run_;
    ProveOptions options_;
    BallSystem<double> system_;
    EnclosureForm form_;
    std::optional<MirrorImages> mirror_;
    ProofOfRoots proof_;
    std::optional<std::optional<ProvedBound>> best_;  // once it was asked for
    std::vector<EnclosureInterval> intervals_;
    std::map<std::size_t, Enclosure<double>> enclosures_;  // of those that may be others, or took more digits
    std::map<std::size_t, Enclosure<Most>> sharp_;         // those that took the most digits
    detail::Mutex guard_;
};

EQUILIBRIA_INLINE ProofOfRoots prove_roots(const RootsToProve& set, const RunOptions& run,
                                           const ProveOptions& options) {
    return Prover(set, run, options).run();
}

}  // namespace detail

}  // namespace equilibria
