/// \file
/// Endpoints that several ranks compute together.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <equilibria/core/lanes.hpp>
#include <equilibria/homotopy/endpoint.hpp>
#include <equilibria/run/ranks.hpp>
#include <equilibria/run/run_options.hpp>
#include <equilibria/storage/checkpoint_fields.hpp>
#include <equilibria/storage/endpoint_bytes.hpp>

namespace equilibria::detail {

/// How many paths a block has where blocks are kept or shared: few enough that little is lost with one, and that no
/// rank waits long for another's last; whatever the ranks and threads.
inline std::size_t shared_block(std::size_t paths) {
    return std::clamp<std::size_t>(paths / 64, 8 * native_lanes, std::clamp<std::size_t>(paths / 512, 512, 1024));
}

/// Throws RankError, at each rank, where not all do the run that the fields describe.
inline void require_same_run(const Ranks& ranks, const CheckpointFields& fields) {
    const std::vector<std::string> texts = ranks.differing(text_of(fields));
    for (std::size_t k = 1; k < texts.size(); ++k)
        if (texts[k] != texts[0])
            throw RankError("rank " + std::to_string(k) + " does another run than rank 0: " +
                            differences(fields_of(texts[k]), fields_of(texts[0]), "rank 0's"));
}

/// work(first, last) fills ends[first .. last), for blocks of all of them, at some rank; all ranks have all afterwards.
template <class Work>
void compute_endpoints(const RunOptions& run, const RuntimeSizes& sizes, std::span<Endpoint> ends, std::size_t block,
                       Work&& work) {
    const BlockCodec codec(sizes);
    const auto part = [&](std::size_t which) {
        return ends.subspan(which * block, std::min(block, ends.size() - which * block));
    };
    run.ranks.for_blocks_at_all(
        (ends.size() + block - 1) / block, run.executor,
        [&](std::size_t which) { work(which * block, std::min(ends.size(), (which + 1) * block)); },
        [&](std::size_t which, Ranks::Bytes& to) { codec.append(to, part(which), 0); },
        [&](std::size_t which, Ranks::BytesView bytes) { codec.decode(bytes.subspan(BlockCodec::head), part(which)); });
}

}  // namespace equilibria::detail
