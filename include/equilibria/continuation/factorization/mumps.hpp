/// \file
/// Opt-in: MUMPS for the sparse symmetric tangents of large problems. Needs MUMPS 5 without MPI (Debian:
/// libmumps-seq-dev), linked with -ldmumps_seq.
///
///     const Structure shell(model, {.factors = mumps});
///
/// L D L^T with threshold pivoting by blocks of one and two: also of saddle points of any shape, with the exact
/// inertia, and so many null pivots as there are redundant constraints. With a fast BLAS five times as fast as
/// SparseLDLT on meshes of 1e5 unknowns; slower where factors have few entries, as of frames. Source: Amestoy, Duff,
/// L'Excellent, Koster, A fully asynchronous multifrontal solver using distributed dynamic scheduling, SIAM J. Matrix
/// Anal. Appl. 23 (2001).
///
/// Where it fails: MUMPS without MPI brings an mpi.h of its own and clashes with MPI in one program; it is not to be
/// called by two threads at once. A BLAS with threads of its own competes with those of assembly
/// (OPENBLAS_NUM_THREADS).
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include <dmumps_c.h>

#include <equilibria/continuation/factorization/symmetric_factors.hpp>

namespace equilibria {

/// L D L^T by MUMPS, with pivoting, of one matrix after another. Each object holds an instance of MUMPS.
class MumpsFactors final : public SymmetricFactors {
public:
    MumpsFactors() {
        data_.sym = 2;  // indefinite
        data_.par = 1;
        data_.comm_fortran = -987654;  // the world of one process
        run(initialize);
        std::fill_n(data_.icntl, 4, 0);  // no output
        control(13) = 1;                 // the root is factored by one process: all of its pivots are counted
        control(24) = 1;                 // null pivots are detected:
        data_.cntl[2] = 1e-12;           // those below so much of the matrix's norm
    }
    MumpsFactors(const MumpsFactors&) = delete;
    MumpsFactors& operator=(const MumpsFactors&) = delete;
    ~MumpsFactors() override { run(terminate); }

    /// Throws std::runtime_error where MUMPS ends with an error that is not about k: no memory.
    using SymmetricFactors::factor;
    bool factor(const Matrix& k, const RemovedUnknown& removed) override {
        if (!take(k, removed)) {
            run(analysis);
            check("analysis");
        }
        run(factorize);
        // pivots that were put off need more room than foreseen
        for (int attempt = 0; attempt < 8 && (info(1) == -8 || info(1) == -9); ++attempt) {
            control(14) = 2 * control(14) + 20;
            run(factorize);
        }
        constexpr int singular = -10;
        if (info(1) != singular) check("factorization");
        return info(1) >= 0 && zero() == 0;
    }
    Eigen::MatrixXd solve(const Eigen::MatrixXd& f) const override {
        Eigen::MatrixXd x = f;
        data_.rhs = x.data();
        data_.nrhs = static_cast<int>(x.cols());
        data_.lrhs = static_cast<int>(x.rows());
        run(substitute);
        check("solution");
        return x;
    }
    int negative() const override { return info(12); }
    bool pivots() const override { return true; }
    /// Null pivots, also where `factor` returned false for them: the nullity, as redundant constraints bring it.
    int zero() const { return info(28); }
    Eigen::Index fill() const override { return info(29) < 0 ? Eigen::Index{-1000000} * info(29) : info(29); }
    double work() const override { return data_.rinfog[0] / 2; }

private:
    enum Job { initialize = -1, terminate = -2, analysis = 1, factorize = 2, substitute = 3 };

    /// Numbers as in MUMPS' guide, from 1.
    int& control(int number) { return data_.icntl[number - 1]; }
    int info(int number) const { return data_.infog[number - 1]; }
    void run(Job job) const {
        data_.job = job;
        dmumps_c(&data_);
    }
    void check(const std::string& what) const {
        if (info(1) < 0)
            throw std::runtime_error("MUMPS: " + what + " ended with INFOG(1) = " + std::to_string(info(1)) +
                                     ", INFOG(2) = " + std::to_string(info(2)));
    }
    /// Puts k's lower triangle where MUMPS reads it; whether it has the pattern of the last matrix.
    bool take(const Matrix& k, const RemovedUnknown& removed) {
        std::size_t at = 0;
        bool same = data_.n == k.rows();
        for (int c = 0; c < k.outerSize(); ++c)
            for (Matrix::InnerIterator entry(k, c); entry; ++entry) {
                if (entry.row() < entry.col()) continue;
                const int row = static_cast<int>(entry.row()) + 1, column = c + 1;
                if (at == rows_.size()) {
                    rows_.push_back(0);
                    columns_.push_back(0);
                    values_.push_back(0);
                }
                same = same && rows_[at] == row && columns_[at] == column;
                rows_[at] = row;
                columns_[at] = column;
                const bool kept = entry.row() != removed.unknown && c != removed.unknown;
                values_[at++] = kept ? entry.value() : entry.row() == c ? removed.corner : 0;
            }
        same = same && at == rows_.size();
        rows_.resize(at);
        columns_.resize(at);
        values_.resize(at);
        data_.n = static_cast<int>(k.rows());
        data_.nnz = static_cast<MUMPS_INT8>(at);
        data_.irn = rows_.data();
        data_.jcn = columns_.data();
        data_.a = values_.data();
        return same;
    }

    mutable DMUMPS_STRUC_C data_{};
    std::vector<int> rows_, columns_;
    std::vector<double> values_;
};

/// What a problem names to have its tangents factored by MUMPS.
inline std::unique_ptr<SymmetricFactors> mumps(int /*multipliers*/) { return std::make_unique<MumpsFactors>(); }

}  // namespace equilibria
