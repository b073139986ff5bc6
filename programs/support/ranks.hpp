// The processes that a program runs on: those of mpirun where it was built with MPI (EQUILIBRIA_MPI), else one.
#pragma once

#include <equilibria/run/ranks.hpp>
#ifdef EQUILIBRIA_MPI
#include <equilibria/enumerate/mpi.hpp>
#endif

#include "fail.hpp"

namespace support {

/// To be called first. Rank 0 alone says what is wrong with a command line: all have the same one.
inline equilibria::Ranks ranks([[maybe_unused]] int* argc, [[maybe_unused]] char*** argv) {
#ifdef EQUILIBRIA_MPI
    static const equilibria::MpiSession mpi(argc, argv);  // ends when the program exits, wherever it does
    speaks = mpi.ranks().first();
    return mpi.ranks();
#else
    return {};
#endif
}

}  // namespace support
