/// \file
/// See enumerate/sweep.hpp.
#pragma once

#include <algorithm>
#include <numeric>
#include <ostream>
#include <string>

#include <equilibria/core/random.hpp>
#include <equilibria/enumerate/sweep.hpp>
#include <equilibria/paths/generic_instance.hpp>
#include <equilibria/paths/over_ranks.hpp>
#include <equilibria/run/elapsed.hpp>
#include <equilibria/run/mutex.hpp>
#include <equilibria/storage/checkpoint.hpp>

namespace equilibria {

EQUILIBRIA_INLINE std::ostream& operator<<(std::ostream& out, const SweepCounts& counts) {
    out << counts.done << " of " << counts.points << " points, " << counts.mixed_volume
        << " paths each: " << counts.failed << " paths failed, " << counts.singular_points
        << " points with multiple roots, " << counts.alarms << " with an alarm, " << counts.again << " done again; ";
    if (counts.vanishing > 0) out << "at " << counts.vanishing << " an equation vanishes; ";
    out << "equilibria:";
    for (const auto& [real, points] : counts.by_real)
        out << (real == counts.by_real.begin()->first ? " " : ", ") << real << " at " << points;
    return out;
}

namespace detail {

/// The points of a sweep as records of one size.
class SweptPointCodec {
public:
    explicit SweptPointCodec(int unknowns) : unknowns_(unknowns) {}
    std::uint64_t size() const { return 4 + 4 * 10 + 4 * (static_cast<std::uint64_t>(unknowns_) + 1); }

    void encode(const SweptPoint& point, Bytes& to) const {
        Writer write(to);
        transfer(write, point);
        for (int k = 0; k <= unknowns_; ++k)
            write(k < static_cast<int>(point.by_index.size())
                      ? static_cast<std::uint32_t>(point.by_index[static_cast<std::size_t>(k)])
                      : std::uint32_t{0});
    }
    SweptPoint decode(std::span<const std::uint8_t> from) const {
        SweptPoint y;
        Reader read(from);
        transfer(read, y);
        for (int k = 0; k <= unknowns_; ++k) {
            std::uint32_t count = 0;
            read(count);
            y.by_index.push_back(count);
        }
        return y;
    }

private:
    /// The structured binding names all fields, so that one more cannot be forgotten here.
    static void transfer(auto& archive, auto& point) {
        auto& [number, parameters, vanishing, paths, finite, at_infinity, singular, failed, distinct, real, degenerate,
               by_index, clean, alarm, instances, proved, proved_real] = point;
        for (auto* flag : {&vanishing, &clean, &alarm}) {
            auto byte = static_cast<std::uint8_t>(*flag);
            archive(byte);
            if constexpr (!std::is_const_v<std::remove_reference_t<decltype(point)>>) *flag = byte != 0;
        }
        archive(instances);
        for (auto* count :
             {&paths, &finite, &at_infinity, &singular, &failed, &distinct, &real, &degenerate, &proved, &proved_real})
            archive(*count);
    }
    int unknowns_;
};

class Sweeper {
public:
    Sweeper(const SweptModel& model, const ParameterPoints& points, const RunOptions& run, const SweepOptions& options)
        : model_(model), points_(points), run_(run), options_(options), codec_(model.properties.sizes.unknowns) {
        instances_[0] = instance(0);
    }

    SweepCounts operator()(const SweptPointTaker& take) {
        const Stopwatch clock;
        y_.points = points_.size;
        y_.mixed_volume = instances_[0] ? instances_[0]->mixed_volume() : 0;
        waiting_.resize(blocks());
        begin();
        // what is in the file already
        run_.ranks.at_first([&] { emit(take); });
        run_.ranks.for_blocks({.size = blocks(),
                               .done = [this](std::size_t which) { return kept(which); },
                               .work = [this](std::size_t which) { return work(which); },
                               .take =
                                   [&](std::size_t which, Ranks::BytesView bytes) {
                                       keep(which, bytes);
                                       emit(take);
                                       if (run_.progress) run_.progress(done_ += length(which), points_.size);
                                   },
                               .cancelled = [this] { return run_.cancelled(); }},
                              run_.executor);
        share_counts();
        y_.seconds = clock.seconds();
        return y_;
    }

private:
    static constexpr std::size_t block = 64;
    static constexpr int most_instances = 3;

    /// Rank 0 has counted.
    void share_counts() {
        const auto numbers = [this] {
            return std::array{&y_.done,    &y_.paths, &y_.failed,    &y_.singular_points, &y_.alarms,
                              &y_.unclean, &y_.again, &y_.vanishing, &y_.proved};
        };
        run_.ranks.share(
            1, [](std::size_t) { return true; },
            [&](std::size_t, Ranks::Bytes& to) {
                Writer write(to);
                for (const auto* number : numbers()) write(*number);
                for (const auto& [real, points] : y_.by_real) write(real), write(points);
            },
            [&](std::size_t, Ranks::BytesView bytes) {
                Reader read(bytes);
                for (auto* number : numbers()) read(*number);
                for (std::size_t left = bytes.size() - 8 * numbers().size(); left > 0; left -= 16) {
                    std::uint64_t real = 0, points = 0;
                    read(real), read(points);
                    y_.by_real[real] = points;
                }
            });
    }

    std::size_t blocks() const { return static_cast<std::size_t>((points_.size + block - 1) / block); }
    std::size_t length(std::size_t which) const {
        return static_cast<std::size_t>(std::min<std::uint64_t>(block, points_.size - which * block));
    }

    /// The parameters that a generic instance is like: between points, so that no term is missing that any of them has.
    RuntimeArray<double> typical(Generator& generator) const {
        constexpr std::uint64_t several = 8;
        const std::uint64_t used = std::min(several, points_.size);
        std::vector<double> weights;
        for (std::uint64_t k = 0; k < used; ++k) weights.push_back(uniform(generator, 0.5, 1.5));
        const double sum = std::accumulate(weights.begin(), weights.end(), 0.0);
        RuntimeArray<double> y = points_.at(0);
        for (double& x : y) x = 0;
        for (std::uint64_t k = 0; k < used; ++k) {
            const auto p = points_.at(used > 1 ? k * (points_.size - 1) / (used - 1) : 0);
            for (int i = 0; i < y.size(); ++i) y[i] += weights[static_cast<std::size_t>(k)] / sum * p[i];
        }
        return y;
    }
    ModelMember typical_member(std::uint64_t seed) const {
        if (points_.size == 0) return {};
        Generator generator(seed);
        return model_.member(typical(generator));
    }
    /// None where an equation vanishes at all points.
    std::unique_ptr<const GenericInstance> instance(int number) const {
        const std::uint64_t seed = seed_of_attempt(run_.seed, static_cast<std::uint64_t>(number));
        const ModelMember member = typical_member(seed);
        if (!member.system) return nullptr;
        return std::make_unique<const GenericInstance>(
            *member.system, RunOptions{.seed = seed, .executor = number == 0 ? run_.executor : Executor()},
            options_.tracker);
    }

    SweptPoint solve(std::uint64_t number) {
        SweptPoint y;
        const RuntimeArray<double> p = points_.at(number);
        const ModelMember member = model_.member(p);
        y.by_index.assign(static_cast<std::size_t>(model_.properties.sizes.unknowns) + 1, 0);
        if (!member.system || !instances_[0]) {
            y.vanishing_equation = true;
            return y;
        }
        std::optional<RootSet<RuntimeUnknowns>> best;
        for (int k = 0; k < most_instances; ++k) {
            detail::call_once(begun_[static_cast<std::size_t>(k)], [&] {
                if (k > 0) instances_[static_cast<std::size_t>(k)] = instance(k);
            });
            auto set = from_instance(*instances_[static_cast<std::size_t>(k)], member, p);
            const bool settled = set.paths.failed == 0 && set.paths.finite == regular(set) && !set.alarms.raised();
            if (!best || settled || set.paths.failed < best->paths.failed) best = std::move(set);
            y.instances = static_cast<std::uint8_t>(k + 1);
            if (settled) break;
        }
        describe(*best, y);
        if (options_.prove) prove(*best, p, y);
        return y;
    }
    static std::uint64_t regular(const RootSet<RuntimeUnknowns>& set) {
        return static_cast<std::uint64_t>(std::count_if(
            set.roots.begin(), set.roots.end(), [](const auto& root) { return root.status == PathStatus::finite; }));
    }
    RootSet<RuntimeUnknowns> from_instance(const GenericInstance& from, const ModelMember& member,
                                           const RuntimeArray<double>& p) const {
        const RunOptions run{.seed = run_.seed};
        const PolynomialHomotopy homotopy = from.homotopy(*member.system, member.own);
        const GenericInstance::Start start(from);
        auto set =
            root_set_of(track_paths(homotopy, {.start = StartPoints(start)}, run, options_.tracker, options_.resort), p,
                        model_.properties, homotopy, *member.equations, run);
        from.add_unsolved_to(set.paths);
        return set;
    }
    static void describe(const RootSet<RuntimeUnknowns>& set, SweptPoint& y) {
        const auto count = [](std::uint64_t k) { return static_cast<std::uint32_t>(k); };
        y.paths = count(set.paths.total);
        y.finite = count(set.paths.finite);
        y.at_infinity = count(set.paths.at_infinity);
        y.singular = count(set.paths.singular);
        y.failed = count(set.paths.failed);
        y.distinct = count(set.distinct());
        y.real = count(set.real());
        y.degenerate = count(set.degenerate());
        y.by_index = set.by_index();
        y.clean = set.clean();
        y.alarm = set.alarms.raised();
    }
    void prove(const RootSet<RuntimeUnknowns>& set, const RuntimeArray<double>& p, SweptPoint& y) const {
        const auto proof = prove_set(set, model_.exact(p), [] { return std::optional<ProvedBound>(); }, {}, {});
        y.proved = static_cast<std::uint32_t>(proof.distinct);
        y.proved_real = static_cast<std::uint32_t>(model_.properties.has_potential ? proof.index : proof.real);
    }

    Ranks::Bytes work(std::size_t which) {
        Ranks::Bytes y;
        for (std::size_t k = 0; k < length(which); ++k) codec_.encode(solve(which * block + k), y);
        return y;
    }

    /// Makes sure that all ranks do this sweep; rank 0 has the file.
    void begin() {
        if (!run_.is_told_apart()) return;
        Fingerprint numbers;
        if (const ModelMember member = typical_member(run_.seed); member.system) {
            for (const auto word : support_words(model_.properties.sizes.unknowns, member.system->terms()))
                numbers(word);
            for (const auto& term : member.system->terms()) numbers(term.coefficient);
        }
        for (std::uint64_t k = 0; k < points_.size; ++k)
            for (const double value : points_.at(k)) numbers(value);
        CheckpointFields fields = model_.fields;
        fields.push_back({"proofs", options_.prove ? "yes" : "no"});
        const auto header = checkpoint_header(
            fields, {run_.seed, "a sweep of parameters", numbers, points_.size, block, options_.resort != nullptr},
            options_.tracker);
        require_same_run(run_.ranks, header);
        if (!run_.checkpoint.empty()) run_.ranks.at_first([&] { open_file(header); });
    }
    void open_file(const CheckpointFields& header) {
        offsets_.resize(blocks());
        file_ = std::make_unique<CheckpointFile>(
            run_.checkpoint, header, [this](std::uint64_t offset, std::span<const std::uint8_t> bytes) -> std::string {
                if (bytes.size() < 8) return "is too short";
                const std::uint64_t which = get_number(bytes.data());
                if (which >= blocks()) return "is of a block that the run does not have";
                if (offsets_[which] != 0) return "repeats a block";
                if (bytes.size() != 8 + length(which) * codec_.size()) return "has a wrong size";
                offsets_[which] = offset;
                done_ += length(which);
                return "";
            });
    }
    bool kept(std::size_t which) const { return file_ ? offsets_[which] != 0 : !waiting_[which].empty(); }
    void keep(std::size_t which, Ranks::BytesView bytes) {
        if (!file_) {
            waiting_[which].assign(bytes.begin(), bytes.end());
            return;
        }
        Bytes record(8);
        put_number(record.data(), which);
        record.insert(record.end(), bytes.begin(), bytes.end());
        offsets_[which] = file_->append(record);
    }
    /// Hands on what is there without a gap.
    void emit(const SweptPointTaker& take) {
        for (; next_ < blocks() && kept(next_); ++next_) {
            Bytes bytes = std::move(waiting_[next_]);
            if (file_) {
                bytes.resize(length(next_) * codec_.size());
                file_->file().read(offsets_[next_] + 8, bytes);
            }
            for (std::size_t k = 0; k < length(next_); ++k) {
                SweptPoint point =
                    codec_.decode(std::span<const std::uint8_t>(bytes).subspan(k * codec_.size(), codec_.size()));
                point.number = next_ * block + k;
                point.parameters = points_.at(point.number);
                count(point);
                take(point);
            }
            waiting_[next_] = {};
        }
    }
    void count(const SweptPoint& point) {
        ++y_.done;
        y_.paths += point.paths;
        y_.failed += point.failed;
        y_.singular_points += point.singular > 0;
        y_.alarms += point.alarm;
        y_.unclean += !point.clean && !point.vanishing_equation;
        y_.again += point.instances > 1;
        y_.proved += options_.prove && point.proved == point.distinct && !point.vanishing_equation;
        if (point.vanishing_equation)
            ++y_.vanishing;
        else
            ++y_.by_real[point.real];
    }

    const SweptModel& model_;
    const ParameterPoints& points_;
    RunOptions run_;
    SweepOptions options_;
    SweptPointCodec codec_;
    std::array<detail::OnceFlag, most_instances> begun_;
    std::array<std::unique_ptr<const GenericInstance>, most_instances> instances_;
    std::vector<Ranks::Bytes> waiting_;
    std::vector<std::uint64_t> offsets_;  // of each block in the file, 0 where it is not there
    std::unique_ptr<CheckpointFile> file_;
    std::size_t next_ = 0;  // the first block that was not handed on
    std::uint64_t done_ = 0;
    SweepCounts y_;
};

EQUILIBRIA_INLINE SweepCounts sweep_points(const SweptModel& model, const ParameterPoints& points,
                                           const SweptPointTaker& take, const RunOptions& run,
                                           const SweepOptions& options) {
    options.tracker.validate();
    require(static_cast<bool>(points.at) || points.size == 0, "points.at", "nothing", "must give the points");
    return Sweeper(model, points, run, options)(take);
}

}  // namespace detail

}  // namespace equilibria
