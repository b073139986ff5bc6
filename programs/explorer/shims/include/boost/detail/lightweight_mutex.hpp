// In place of Boost's, which asks for std::mutex whether there are threads or not: guards nothing.
#pragma once

namespace boost::detail {

struct lightweight_mutex {
    struct scoped_lock {
        explicit scoped_lock(lightweight_mutex&) {}
    };
};

}  // namespace boost::detail
