/// \file
/// See run/ranks.hpp.
#pragma once

#include <algorithm>
#include <exception>

#include <boost/endian/conversion.hpp>

#include <equilibria/run/mutex.hpp>
#include <equilibria/run/ranks.hpp>

namespace equilibria {

EQUILIBRIA_INLINE void Ranks::for_blocks(const Loop& loop, const Executor& executor) const {
    if (several()) return backend_->for_blocks(loop, executor);
    std::vector<std::size_t> open;
    for (std::size_t k = 0; k < loop.size; ++k)
        if (!loop.done || !loop.done(k)) open.push_back(k);
    detail::Mutex guard;
    executor.for_blocks(open.size(), 1, [&](std::size_t at, std::size_t) {
        if (loop.cancelled && loop.cancelled()) return;
        const Bytes bytes = loop.work(open[at]);
        const detail::Lock lock(guard);
        loop.take(open[at], bytes);
    });
}

EQUILIBRIA_INLINE void Ranks::for_blocks_at_all(std::size_t size, const Executor& executor,
                                                const std::function<void(std::size_t)>& work,
                                                const std::function<void(std::size_t, Bytes&)>& give,
                                                const std::function<void(std::size_t, BytesView)>& take) const {
    if (!several()) {
        executor.for_blocks(size, 1, [&](std::size_t block, std::size_t) { work(block); });
        return;
    }
    for_blocks({.size = size,
                .done = {},
                .work =
                    [&](std::size_t block) {
                        work(block);
                        Bytes bytes;
                        give(block, bytes);
                        return bytes;
                    },
                .take = take,
                .cancelled = {}},
               executor);
    share(size, [](std::size_t) { return true; }, give, take);
}

EQUILIBRIA_INLINE void Ranks::share(std::size_t size, const std::function<bool(std::size_t)>& has,
                                    const std::function<void(std::size_t, Bytes&)>& give,
                                    const std::function<void(std::size_t, BytesView)>& take) const {
    if (!several()) return;
    constexpr std::size_t piece = std::size_t{1} << 20;  // which MPI sends soonest
    constexpr std::size_t head = 16;                     // of a block: its number, its length
    using namespace boost::endian;
    Bytes bytes;  // whose memory serves all pieces
    for (std::size_t block = 0; block < size;) {
        bytes.clear();
        if (first())
            for (; block < size && bytes.size() < piece; ++block) {
                if (!has(block)) continue;
                const std::size_t at = bytes.size();
                bytes.resize(at + head);
                give(block, bytes);
                store_little_u64(&bytes[at], block);
                store_little_u64(&bytes[at + 8], bytes.size() - at - head);
            }
        // how far rank 0 has come stands last
        bytes.resize(bytes.size() + 8);
        if (first()) store_little_u64(&bytes[bytes.size() - 8], block);
        backend_->broadcast(bytes);
        block = static_cast<std::size_t>(load_little_u64(&bytes[bytes.size() - 8]));
        if (first()) continue;
        const BytesView all(bytes.data(), bytes.size() - 8);
        for (std::size_t at = 0; at < all.size();) {
            const auto length = static_cast<std::size_t>(load_little_u64(&all[at + 8]));
            take(static_cast<std::size_t>(load_little_u64(&all[at])), all.subspan(at + head, length));
            at += head + length;
        }
    }
}

EQUILIBRIA_INLINE void Ranks::at_first(const std::function<void()>& act) const {
    if (!several()) return act();
    Bytes wrong;
    std::exception_ptr failure;
    if (first()) try {
            act();
        } catch (const std::exception& error) {
            failure = std::current_exception();
            const std::string text = std::string("rank 0: ") + error.what();
            wrong.assign(text.begin(), text.end());
        }
    backend_->broadcast(wrong);
    if (failure) std::rethrow_exception(failure);
    if (!wrong.empty()) throw RankError(std::string(wrong.begin(), wrong.end()));
}

EQUILIBRIA_INLINE std::uint64_t Ranks::of_first(std::uint64_t own) const {
    if (!several()) return own;
    Bytes bytes(8);
    boost::endian::store_little_u64(bytes.data(), own);
    backend_->broadcast(bytes);
    return boost::endian::load_little_u64(bytes.data());
}

EQUILIBRIA_INLINE void Ranks::add_up(std::span<std::uint64_t> numbers) const {
    if (!several()) return;
    Bytes own(8 * numbers.size());
    for (std::size_t k = 0; k < numbers.size(); ++k) boost::endian::store_little_u64(&own[8 * k], numbers[k]);
    std::fill(numbers.begin(), numbers.end(), 0);
    for (const Bytes& of : backend_->gather(own))
        for (std::size_t k = 0; k < numbers.size(); ++k) numbers[k] += boost::endian::load_little_u64(&of[8 * k]);
}

EQUILIBRIA_INLINE bool Ranks::any(bool own) const {
    if (!several()) return own;
    const auto all = backend_->gather({static_cast<std::uint8_t>(own)});
    return std::any_of(all.begin(), all.end(), [](const Bytes& of) { return of[0] != 0; });
}

EQUILIBRIA_INLINE std::vector<std::string> Ranks::differing(const std::string& own) const {
    if (!several()) return {};
    Bytes first_text(own.begin(), own.end());
    backend_->broadcast(first_text);
    const Bytes ours(own.begin(), own.end());
    if (!any(first_text != ours)) return {};
    std::vector<std::string> y;
    for (const Bytes& text : backend_->gather(ours)) y.emplace_back(text.begin(), text.end());
    return y;
}

}  // namespace equilibria
