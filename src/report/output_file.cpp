#include "report/output_file.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "base/error.h"

namespace ctpbench {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannot_write(const fs::path& path, const std::string& why) {
    throw Error(ExitCode::output, path.string() + ": error: cannot be written: " + why +
                                      "; free some space or name another folder with --out");
}

// Of a call that leaves errno.
[[noreturn]] void cannot_write(const fs::path& path) { cannot_write(path, std::strerror(errno)); }

bool write_all(int file, std::string_view text) {
    while (!text.empty()) {
        const ssize_t n = ::write(file, text.data(), text.size());
        if (n < 0 && errno == EINTR) continue;
        if (n < 0) return false;
        text.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

// Pipes and devices have nothing to sync.
bool synced(int file) { return ::fsync(file) == 0 || errno == EINVAL || errno == EROFS; }

// A new name in a folder survives a loss of power once the folder does. Not every file system can.
void sync_folder_of(const fs::path& path) {
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    const int opened = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (opened < 0) return;
    ::fsync(opened);
    ::close(opened);
}

}  // namespace

GrowingFile::GrowingFile(fs::path path, std::uint64_t keep) : path_(std::move(path)), size_(keep) {
    file_ = ::open(path_.c_str(), O_WRONLY | O_CREAT | O_CLOEXEC, 0666);
    if (file_ < 0) cannot_write(path_);
    if (::flock(file_, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK) {
        ::close(file_);
        throw Error(ExitCode::output,
                    path_.string() +
                        ": error: another process writes to it; wait until that has ended, or "
                        "name another folder with --out");
    }
    if (::ftruncate(file_, static_cast<off_t>(keep)) != 0 ||
        ::lseek(file_, static_cast<off_t>(keep), SEEK_SET) < 0) {
        const int error = errno;
        ::close(file_);
        cannot_write(path_, std::strerror(error));
    }
    sync_folder_of(path_);
}

GrowingFile::~GrowingFile() { ::close(file_); }

void GrowingFile::append(std::string_view text) {
    if (write_all(file_, text)) {
        size_ += text.size();
        return;
    }
    const int error = errno;
    if (::ftruncate(file_, static_cast<off_t>(size_)) == 0)
        ::lseek(file_, static_cast<off_t>(size_), SEEK_SET);
    cannot_write(path_, std::strerror(error));
}

void GrowingFile::sync() {
    if (!synced(file_)) cannot_write(path_);
}

void write_file(const fs::path& path, const std::string& content) {
    const fs::path partial = path.string() + ".partial";
    const int file = ::open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (file < 0) cannot_write(path);
    const bool whole = write_all(file, content) && synced(file);
    const int error = errno;
    ::close(file);
    std::error_code failed;
    if (!whole) {
        fs::remove(partial, failed);  // it only takes the space that there is too little of
        cannot_write(path, std::strerror(error));
    }
    fs::rename(partial, path, failed);
    if (failed) cannot_write(path, failed.message());
    sync_folder_of(path);
}

void sync_file(const fs::path& path) {
    const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const bool whole = file >= 0 && synced(file);
    const int error = errno;
    if (file >= 0) ::close(file);
    if (!whole) cannot_write(path, std::strerror(error));
}

void require_output_folder(const fs::path& path) {
    std::error_code failed;
    fs::create_directories(path, failed);
    if (failed) cannot_write(path, failed.message());
    write_file(path / ".writable", "");
    fs::remove(path / ".writable", failed);
}

}  // namespace ctpbench
