// A JSON text together with where each of its values was written, so that an error found long after parsing
// can still name the line. Stricter than the JSON grammar (no duplicate keys, bounded size and nesting) and
// wider in one point: // and /* */ comments are allowed.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace ctpbench {

// Lines and columns count from 1, columns in characters (not bytes). Line 0: not from a file; `file` then
// names the command-line option that the value came from.
struct JsonPlace {
    std::string file;
    std::size_t line = 0;
    std::size_t column = 0;
};

// The place of a byte of `text`.
JsonPlace place_in_text(std::string_view text, std::size_t offset, const std::string& file);

// `table3.json:6:9: error: message`
std::string error_line(const JsonPlace& place, std::string_view message);

// The JSON pointer (RFC 6901) of a member or element of the value at `parent`.
std::string json_pointer(std::string_view parent, std::string_view key);
std::string json_pointer(std::string_view parent, std::size_t index);

class JsonDocument {
public:
    static constexpr std::size_t max_bytes = std::size_t{1} << 20;  // such files are written by hand
    static constexpr std::size_t max_depth = 64;
    // Bytes of a JSON pointer: each value keeps its own, and there may be half a million of them.
    static constexpr std::size_t max_pointer = 512;

    // Told of one file: to find the place of each takes a pass over the text.
    static constexpr std::size_t max_errors = 100;

    // Both throw Error(usage) naming the place; `file` is only a name to show.
    static JsonDocument load(const std::filesystem::path& path);
    static JsonDocument parse(std::string_view text, const std::string& file);

    const nlohmann::json& value() const { return value_; }
    const std::string& file() const { return file_; }

    // Where the value at a pointer starts; of a value that is not written, its nearest ancestor's place.
    JsonPlace place(std::string_view pointer) const;
    // Where the key of a member starts.
    JsonPlace key_place(std::string_view pointer) const;

    // Applies one `--set` edit, written `/json/pointer=value`. The value is taken as JSON, or as a string if
    // it is not JSON. What it points into must exist; the last step may add a member, `-` appends to a list.
    // Errors name `option`, if another one than `--set` asked for it.
    void set(std::string_view edit, std::string option = {});

private:
    friend class JsonDocumentBuilder;
    // Where a value came from: byte offsets into the text, or the option that set it.
    struct Origin {
        std::size_t key = 0, value = 0;
        std::string option;
    };
    JsonPlace place_of(const Origin& origin, std::size_t offset) const;
    const Origin& nearest_origin(std::string_view pointer) const;
    void forget_below(const std::string& pointer);

    nlohmann::json value_;
    std::string file_;
    std::string text_;
    std::map<std::string, Origin, std::less<>> origins_;  // by JSON pointer
};

}  // namespace ctpbench
