#include "base/json_document.h"

#include <algorithm>
#include <fstream>

#include "base/error.h"

namespace ctpbench {
namespace {

[[noreturn]] void refuse(const std::string& message) { throw Error(ExitCode::usage, message); }

// The pointer one level up; the root has none.
std::string_view parent_of(std::string_view pointer) { return pointer.substr(0, pointer.rfind('/')); }

nlohmann::json json_or_string(const std::string& text) {
    try {
        return JsonDocument::parse(text, "--set").value();
    } catch (const Error&) {
        return text;
    }
}

}  // namespace

JsonPlace place_in_text(std::string_view text, std::size_t offset, const std::string& file) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t line_start = before.rfind('\n') + 1;  // npos + 1 is 0
    // Each character but its UTF-8 continuation bytes, which look like 10xxxxxx.
    const auto columns = std::count_if(before.begin() + static_cast<std::ptrdiff_t>(line_start), before.end(),
                                       [](char c) { return (c & 0xC0) != 0x80; });
    return {file, static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n')) + 1,
            static_cast<std::size_t>(columns) + 1};
}

std::string error_line(const JsonPlace& place, std::string_view message) {
    std::string line = place.file;
    if (place.line > 0) line += ":" + std::to_string(place.line) + ":" + std::to_string(place.column);
    return line + ": error: " + std::string(message);
}

std::string json_pointer(std::string_view parent, std::string_view key) {
    std::string pointer(parent);
    pointer += '/';
    for (const char c : key) {
        if (c == '~') {
            pointer += "~0";
        } else if (c == '/') {
            pointer += "~1";
        } else {
            pointer += c;
        }
    }
    return pointer;
}

std::string json_pointer(std::string_view parent, std::size_t index) {
    return json_pointer(parent, std::to_string(index));
}

JsonDocument JsonDocument::load(const std::filesystem::path& path) {
    const std::string file = path.string();
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) refuse(file + ": error: a directory; name a JSON file");
    std::ifstream stream(path, std::ios::binary);
    if (!stream) refuse(file + ": error: cannot be opened; check the path and that it is readable");
    // Read rather than asked for its size, so that pipes work.
    std::string text(max_bytes + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (stream.bad()) refuse(file + ": error: cannot be read to its end; check the disk it is on");
    text.resize(static_cast<std::size_t>(stream.gcount()));
    return parse(text, file);
}

const JsonDocument::Origin& JsonDocument::nearest_origin(std::string_view pointer) const {
    for (;;) {
        const auto found = origins_.find(pointer);
        if (found != origins_.end()) return found->second;
        pointer = parent_of(pointer);  // ends at the root, which always has an origin
    }
}

void JsonDocument::forget_below(const std::string& pointer) {
    const std::string below = pointer + "/";
    auto entry = origins_.lower_bound(below);
    while (entry != origins_.end() && entry->first.starts_with(below)) entry = origins_.erase(entry);
}

JsonPlace JsonDocument::place_of(const Origin& origin, std::size_t offset) const {
    if (!origin.option.empty()) return {origin.option, 0, 0};
    return place_in_text(text_, offset, file_);
}

JsonPlace JsonDocument::place(std::string_view pointer) const {
    const Origin& origin = nearest_origin(pointer);
    return place_of(origin, origin.value);
}

JsonPlace JsonDocument::key_place(std::string_view pointer) const {
    const Origin& origin = nearest_origin(pointer);
    return place_of(origin, origin.key);
}

void JsonDocument::set(std::string_view edit, std::string option) {
    if (option.empty()) option = "--set " + std::string(edit);
    const std::size_t equals = edit.find('=');
    if (edit.empty() || edit.front() != '/' || equals == std::string_view::npos) {
        refuse(option + ": error: not an edit; write --set /json/pointer=value, as in --set /rounds=5");
    }
    std::string pointer(edit.substr(0, equals));
    try {
        const nlohmann::json::json_pointer path(pointer);
        const std::string parent(parent_of(pointer));
        if (!value_.contains(path.parent_pointer())) {
            refuse(option + ": error: " + file_ + " has no " + parent +
                   "; set that first, or write it there");
        }
        nlohmann::json& target = value_.at(path.parent_pointer());
        if (!target.is_object() && !target.is_array()) {
            refuse(option + ": error: " + (parent.empty() ? "the document" : parent) + " in " + file_ +
                   " is neither an object nor a list, so nothing can be set within it");
        }
        if (target.is_array()) {
            // The place of what is appended is looked up by its index, not by "-".
            if (path.back() == "-") {
                pointer = json_pointer(parent, target.size());
            } else if (!value_.contains(path)) {
                refuse(option + ": error: " + parent + " has " + std::to_string(target.size()) +
                       " elements, counted from 0; /- appends one");
            }
        }
        value_[path] = json_or_string(std::string(edit.substr(equals + 1)));
    } catch (const nlohmann::json::exception&) {
        refuse(option + ": error: not a JSON pointer; in a key write ~ as ~0 and / as ~1");
    }
    forget_below(pointer);
    origins_[pointer] = {0, 0, option};
}

}  // namespace ctpbench
