#include "base/suggest.h"

#include <algorithm>
#include <cctype>

namespace ctpbench {
namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

// Edits between two names; a swap of neighbours counts once (optimal string alignment distance).
std::size_t edits_between(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    for (std::size_t j = 0; j <= b.size(); ++j) d[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const bool same = lower(a[i - 1]) == lower(b[j - 1]);
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (same ? 0 : 1)});
            const bool swapped =
                i > 1 && j > 1 && lower(a[i - 1]) == lower(b[j - 2]) && lower(a[i - 2]) == lower(b[j - 1]);
            if (swapped) d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

}  // namespace

std::optional<std::string> nearest_name(std::string_view name, const std::vector<std::string>& known) {
    constexpr std::size_t longest = 64;  // the cost is quadratic, and no name of ours is longer
    if (name.size() > longest) return std::nullopt;
    std::optional<std::string> nearest;
    std::size_t fewest = std::max<std::size_t>(1, name.size() / 3) + 1;
    for (const std::string& candidate : known) {
        const std::size_t edits = edits_between(name, candidate);
        // Replacing every letter is no likeness.
        if (edits < fewest && edits < candidate.size()) {
            fewest = edits;
            nearest = candidate;
        }
    }
    return nearest;
}

std::string unknown_name(std::string_view what, std::string_view name,
                         const std::vector<std::string>& known) {
    std::string message = "unknown " + std::string(what) + " \"" + std::string(name) + "\"";
    if (const auto nearest = nearest_name(name, known)) message += "; did you mean \"" + *nearest + "\"?";
    if (known.empty()) return message;
    message += message.back() == '?' ? " choices: " : "; choices: ";
    for (std::size_t i = 0; i < known.size(); ++i) message += (i ? ", \"" : "\"") + known[i] + "\"";
    return message;
}

}  // namespace ctpbench
