#include "scene/obj_text.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <string>
#include <system_error>

namespace ctpbench {
namespace {

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool is_line_end(char c) { return c == '\n' || c == '\r'; }

// The next word of `rest`, which is shortened by it; empty at the end.
std::string_view next_word(std::string_view& rest) {
    const char* begin = std::find_if_not(rest.begin(), rest.end(), is_blank);
    const char* end = std::find_if(begin, rest.end(), is_blank);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.begin()));
    return {begin, static_cast<std::size_t>(end - begin)};
}

std::optional<float> parse_number(std::string_view word) {
    if (word.starts_with('+')) word.remove_prefix(1);
    float value = 0.0f;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size() || word.empty()) return std::nullopt;
    // Too large or too small for a float: strtof says which, and gives infinity or the nearest tiny number.
    if (code == std::errc::result_out_of_range) return std::strtof(std::string(word).c_str(), nullptr);
    return value;
}

}  // namespace

ObjText::ObjText(std::string_view text) : counted_to_(text.data()) {
    char* begin = const_cast<char*>(text.data());  // only ever read
    setg(begin, begin, begin + text.size());
}

std::string_view ObjText::line() const {
    const char* end = gptr();
    if (end > eback() && end[-1] == '\n') --end;
    if (end > eback() && end[-1] == '\r') --end;
    const char* begin = end;
    while (begin > eback() && !is_line_end(begin[-1])) --begin;
    return {begin, static_cast<std::size_t>(end - begin)};
}

std::uint64_t ObjText::line_number() {
    const char* begin = line().data();
    newlines_ += static_cast<std::uint64_t>(std::count(counted_to_, begin, '\n'));
    counted_to_ = begin;
    return newlines_ + 1;
}

std::optional<Vec3> parse_vertex(std::string_view line) {
    next_word(line);  // "v"
    Vec3 vertex{};
    for (int axis = 0; axis < 3; ++axis) {
        const std::optional<float> value = parse_number(next_word(line));
        if (!value) return std::nullopt;
        vertex[axis] = *value;
    }
    return vertex;
}

std::optional<Vec2> parse_texcoord(std::string_view line) {
    next_word(line);  // "vt"
    const std::optional<float> u = parse_number(next_word(line));
    const std::string_view second = next_word(line);
    const std::optional<float> v = second.empty() || second.starts_with('#') ? 0.0f : parse_number(second);
    if (!u || !v) return std::nullopt;
    return Vec2{*u, *v};
}

}  // namespace ctpbench
