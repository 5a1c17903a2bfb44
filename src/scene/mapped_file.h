// A file's bytes, read only, without a copy: meshes reach a gigabyte.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string_view>

namespace ctpbench {

class MappedFile {
public:
    // Throws std::system_error if the path is no regular file or cannot be read.
    explicit MappedFile(const std::filesystem::path& path);
    ~MappedFile();
    MappedFile(const MappedFile&) = delete;
    MappedFile& operator=(const MappedFile&) = delete;

    std::string_view bytes() const { return {data_, size_}; }

private:
    const char* data_ = nullptr;
    std::size_t size_ = 0;
};

}  // namespace ctpbench
