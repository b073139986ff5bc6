/// \file
/// A file that one process reads and writes and no other one, as bytes; every error names it. POSIX, locked with flock;
/// refused where there are no locks, as under WASI.
#pragma once

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <equilibria/storage/bytes.hpp>
#include <equilibria/storage/checkpoint_error.hpp>

namespace equilibria::detail {

class LockedFile {
public:
    explicit LockedFile(std::string path) : path_(std::move(path)) {
        if (path_.empty()) refuse("must be the name of a file");
    }
    LockedFile(const LockedFile&) = delete;
    ~LockedFile() { close(); }

    const std::string& path() const { return path_; }

    /// Opens and locks the file; false where there is none. Throws CheckpointError as all functions here.
    bool open() {
        do file_ = ::open(path_.c_str(), O_RDWR | O_CLOEXEC | O_NONBLOCK);
        while (file_ < 0 && errno == EINTR);
        if (file_ < 0 && errno == ENOENT) return false;
        if (file_ < 0) refuse("cannot be opened", errno);
        struct stat status{};
        if (::fstat(file_, &status) != 0 || !S_ISREG(status.st_mode)) refuse("is not a regular file");
        lock();
        return true;
    }

    /// Writes the bytes beside the file and gives them its name when they are complete, so that nobody ever meets half
    /// of them; the file is locked. False where somebody else was quicker.
    bool create(std::span<const std::uint8_t> bytes) {
        const std::string beside = path_ + ".new" + std::to_string(::getpid());
        do file_ = ::open(beside.c_str(), O_RDWR | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
        while (file_ < 0 && errno == EINTR);
        if (file_ < 0) refuse("cannot be created", errno);
        struct Remove {
            const std::string& name;
            ~Remove() { ::unlink(name.c_str()); }
        } remove{beside};
        lock();
        write(0, bytes);
        sync();
        if (::link(beside.c_str(), path_.c_str()) != 0) {
            if (errno == EEXIST) return close(), false;
            const bool no_links = errno == EPERM || errno == EOPNOTSUPP || errno == ENOSYS;  // of the file system
            if (!no_links || ::rename(beside.c_str(), path_.c_str()) != 0) refuse("cannot be created", errno);
        }
        const std::size_t slash = path_.rfind('/');
        const std::string folder = slash == std::string::npos ? "." : path_.substr(0, slash + 1);
        const int directory = ::open(folder.c_str(), O_RDONLY | O_CLOEXEC);
        if (directory >= 0) ::fsync(directory), ::close(directory);
        return true;
    }

    std::uint64_t size() const {
        struct stat status{};
        if (::fstat(file_, &status) != 0) refuse("cannot be read", errno);
        return static_cast<std::uint64_t>(status.st_size);
    }

    /// Fills `bytes` from the offset on.
    void read(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
        while (!bytes.empty()) {
            const ssize_t got = ::pread(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
            if (got < 0 && errno == EINTR) continue;
            if (got < 0) refuse("cannot be read", errno);
            if (got == 0) refuse("is truncated: it ends at byte " + std::to_string(offset));
            offset += static_cast<std::uint64_t>(got);
            bytes = bytes.subspan(static_cast<std::size_t>(got));
        }
    }

    void write(std::uint64_t offset, std::span<const std::uint8_t> bytes) const {
        while (!bytes.empty()) {
            const ssize_t put = ::pwrite(file_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
            if (put < 0 && errno == EINTR) continue;
            if (put <= 0) refuse(unwritten, errno);
            offset += static_cast<std::uint64_t>(put);
            bytes = bytes.subspan(static_cast<std::size_t>(put));
        }
    }
    void truncate(std::uint64_t size) const {
        if (::ftruncate(file_, static_cast<off_t>(size)) != 0) refuse(unwritten, errno);
    }
    /// Returns when everything is on the disk.
    void sync() const {
        int result;
        do result = ::fdatasync(file_);
        while (result != 0 && errno == EINTR);
        if (result != 0) refuse(unwritten, errno);
    }

    [[noreturn]] void refuse(std::string_view wrong) const { throw CheckpointError(path_, wrong); }
    [[noreturn]] void refuse(std::string_view wrong, int reason) const {
        refuse(std::string(wrong) + " (" + std::strerror(reason) + ")");
    }

private:
    static constexpr std::string_view unwritten = "cannot be written, what is in it is kept";

    void close() {
        if (file_ >= 0) ::close(file_);
        file_ = -1;
    }
    void lock() const {
#ifdef __wasi__
        refuse("cannot be locked: this system has no locks");
#else
        if (::flock(file_, LOCK_EX | LOCK_NB) == 0) return;
        if (errno == EWOULDBLOCK) refuse("is in use by another run");
        refuse("cannot be locked", errno);
#endif
    }

    std::string path_;
    int file_ = -1;
};

}  // namespace equilibria::detail
