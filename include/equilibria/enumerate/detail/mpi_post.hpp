/// \file
/// Messages between ranks over MPI, none of which anybody waits for inside MPI: that takes a core, and a rank that is
/// stopped in the middle of a large message would hold the one that receives it.
#pragma once

// without these g++ wants MPI's C++ library, which nobody has any more
#ifndef OMPI_SKIP_MPICXX
#define OMPI_SKIP_MPICXX 1
#endif
#ifndef MPICH_SKIP_MPICXX
#define MPICH_SKIP_MPICXX 1
#endif
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <list>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <boost/endian/conversion.hpp>

#include <equilibria/run/ranks.hpp>

namespace equilibria::detail {

/// What messages say, by their tag. To rank 0: threads that want blocks; a block's number, and next its bytes; that the
/// run is cancelled; what went wrong; that no more comes. From rank 0: blocks; that there are no more; what went wrong;
/// that all have said so, and the next loop may begin.
struct MpiTag {
    enum : int { want = 1, result, bytes, cancel, failure, done, blocks, end, leave };
};

inline void put_u64(Ranks::Bytes& to, std::uint64_t number) {
    to.resize(to.size() + 8);
    boost::endian::store_little_u64(&to[to.size() - 8], number);
}
inline std::uint64_t get_u64(const Ranks::Bytes& from, std::size_t at) {
    return boost::endian::load_little_u64(&from[at]);
}
inline Ranks::Bytes bytes_of(const std::string& of) { return {of.begin(), of.end()}; }
inline std::string text_of(const Ranks::Bytes& of) { return {of.begin(), of.end()}; }
inline std::string sentence(const std::exception_ptr& failure) {
    try {
        std::rethrow_exception(failure);
    } catch (const std::exception& error) {
        return error.what();
    } catch (...) {
        return "an unknown exception";
    }
}

struct MpiMessage {
    int from = 0, tag = 0;
    Ranks::Bytes bytes;
};
/// Messages on their way, from and to this rank. Nothing here waits.
class MpiPost {
public:
    explicit MpiPost(MPI_Comm comm) : comm_(comm) {}
    /// Waits until all has been sent.
    ~MpiPost() {
        while (!empty()) std::this_thread::sleep_for(std::chrono::microseconds(100));
    }
    void send(int to, int tag, Ranks::Bytes bytes) {
        sent_.push_back({std::move(bytes), MPI_REQUEST_NULL});
        auto& [kept, request] = sent_.back();
        MPI_Isend(kept.data(), static_cast<int>(kept.size()), MPI_BYTE, to, tag, comm_, &request);
    }
    /// The next message of any rank that is all there. A large one comes in parts, for which its sender has to be
    /// awake: nobody waits for it but those that the same rank has sent after it.
    bool receive(MpiMessage& message) {
        while (coming_.size() < most_coming && begin_receiving()) {
        }
        std::vector<int> late;
        for (auto at = coming_.begin(); at != coming_.end(); ++at) {
            int there = 0;
            if (std::find(late.begin(), late.end(), at->message.from) == late.end())
                MPI_Test(&at->request, &there, MPI_STATUS_IGNORE);
            if (there == 0) {
                late.push_back(at->message.from);
                continue;
            }
            std::swap(message, at->message);
            if (spare_.size() < most_spare) spare_.push_back(std::move(at->message.bytes));
            coming_.erase(at);
            return true;
        }
        return false;
    }
    /// Whether all has been sent.
    bool empty() {
        sent_.remove_if([](auto& of) {
            int gone = 0;
            MPI_Test(&of.request, &gone, MPI_STATUS_IGNORE);
            return gone != 0;
        });
        return sent_.empty();
    }

private:
    bool begin_receiving() {
        int there = 0;
        MPI_Message handle = MPI_MESSAGE_NULL;
        MPI_Status status;
        MPI_Improbe(MPI_ANY_SOURCE, MPI_ANY_TAG, comm_, &there, &handle, &status);
        if (there == 0) return false;
        int length = 0;
        MPI_Get_count(&status, MPI_BYTE, &length);
        coming_.push_back({{status.MPI_SOURCE, status.MPI_TAG, {}}, MPI_REQUEST_NULL});
        auto& [message, request] = coming_.back();
        if (!spare_.empty()) {
            message.bytes = std::move(spare_.back());
            spare_.pop_back();
        }
        message.bytes.resize(static_cast<std::size_t>(length));
        MPI_Imrecv(message.bytes.data(), length, MPI_BYTE, &handle, &request);
        return true;
    }

    static constexpr std::size_t most_coming = 512;  // some 200 MB; the others wait where they are
    static constexpr std::size_t most_spare = 4;

    struct Sent {
        Ranks::Bytes bytes;
        MPI_Request request;
    };
    struct Coming {
        MpiMessage message;
        MPI_Request request;
    };
    MPI_Comm comm_;
    std::list<Sent> sent_;
    std::list<Coming> coming_;
    std::vector<Ranks::Bytes> spare_;  // memory that has been touched serves again
};

}  // namespace equilibria::detail
