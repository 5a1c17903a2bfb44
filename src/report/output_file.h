// Files of results. What is written of them is whole or not there: a full disk, a signal or a loss of power
// costs what was being written, and nothing before it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace ctpbench {

// A file that grows. All of it throws Error(output), naming the file, when it cannot be written.
class GrowingFile {
public:
    // Keeps the first `keep` bytes of what is there, and makes the file if it is not. No other process can
    // have it open as one of these at the same time.
    explicit GrowingFile(std::filesystem::path path, std::uint64_t keep = 0);
    ~GrowingFile();
    GrowingFile(const GrowingFile&) = delete;
    GrowingFile& operator=(const GrowingFile&) = delete;

    // All of the text, or nothing of it.
    void append(std::string_view text);
    // Returns when what was appended would survive a loss of power.
    void sync();
    std::uint64_t size() const { return size_; }
    const std::filesystem::path& path() const { return path_; }

private:
    std::filesystem::path path_;
    int file_ = -1;
    std::uint64_t size_ = 0;
};

// Writes a whole file, atomically by rename, and waits until it would survive a loss of power.
void write_file(const std::filesystem::path& path, const std::string& content);

// Likewise of a file that someone else has written.
void sync_file(const std::filesystem::path& path);

// Creates the folder, with those above it, and sees whether it can be written to.
void require_output_folder(const std::filesystem::path& path);

}  // namespace ctpbench
