// The text of an OBJ file as the stream that tinyobjloader reads. Since the stream is one piece of memory,
// its read position tells which line a callback is about; tinyobjloader itself reports no positions.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <streambuf>
#include <string_view>

#include "kernels/texture.h"
#include "kernels/vec.h"

namespace ctpbench {

class ObjText : public std::streambuf {
public:
    explicit ObjText(std::string_view text);

    // The line that was read last, without its line end.
    std::string_view line() const;
    // Its number, from 1. Calls must go forward through the file; together they cost one pass over it.
    std::uint64_t line_number();

private:
    const char* counted_to_;
    std::uint64_t newlines_ = 0;
};

// The first three numbers of a line `v x y z ...`, each rounded correctly; "nan" and "inf" are numbers.
// Nothing if there are no three.
std::optional<Vec3> parse_vertex(std::string_view line);

// The first two numbers of a line `vt u v ...`; a second that is not there is 0, as the format says.
std::optional<Vec2> parse_texcoord(std::string_view line);

}  // namespace ctpbench
