#include "base/json_reader.h"

#include <algorithm>
#include <tuple>

#include "base/error.h"
#include "base/suggest.h"

namespace ctpbench {

JsonObject::JsonObject(JsonReader* reader, const nlohmann::json* json, std::string pointer)
    : reader_(reader), json_(json), pointer_(std::move(pointer)) {
    if (json_) reader_->visited_.try_emplace(pointer_, JsonReader::Visited{json_, {}});
}

JsonValue JsonObject::value(std::string_view key) const {
    const std::string pointer = json_pointer(pointer_, key);
    if (!json_) return {reader_, nullptr, pointer};
    std::vector<std::string>& known = reader_->visited_.at(pointer_).known;
    if (std::find(known.begin(), known.end(), key) == known.end()) known.emplace_back(key);
    const auto member = json_->find(key);
    return {reader_, member == json_->end() ? nullptr : &*member, pointer};
}

JsonObject JsonObject::object(std::string_view key) const { return value(key).object(); }

std::vector<std::pair<std::string, JsonValue>> JsonObject::members() const {
    std::vector<std::pair<std::string, JsonValue>> all;
    if (!json_) return all;
    reader_->visited_.at(pointer_).all_known = true;
    for (const auto& [key, member] : json_->items())
        all.emplace_back(key, JsonValue(reader_, &member, json_pointer(pointer_, key)));
    return all;
}

void JsonObject::error(std::string_view message) const { reader_->report(pointer_, message); }

void JsonObject::error(std::string_view key, std::string_view message) const { value(key).error(message); }

bool JsonObject::demand(std::string_view key) const {
    if (has(key)) return true;
    // Of an object that is absent itself, its parent has said so.
    if (json_) error("\"" + std::string(key) + "\" is missing; add it");
    return false;
}

JsonObject JsonReader::root() { return JsonValue(this, &document_.value(), "").object(); }

void JsonReader::report(std::string_view pointer, std::string_view message, bool at_key) {
    if (full()) return;
    std::string text(pointer);
    if (!text.empty()) text += ": ";
    problems_.push_back(
        {at_key ? document_.key_place(pointer) : document_.place(pointer), text + std::string(message)});
}

void JsonReader::report_unknown_keys() {
    for (const auto& [pointer, object] : visited_) {
        if (object.all_known) continue;
        for (const auto& [key, ignored] : object.json->items()) {
            const std::vector<std::string>& known = object.known;
            if (full()) return;
            if (std::find(known.begin(), known.end(), key) != known.end()) continue;
            std::string message = "unknown key";
            if (const auto nearest = nearest_name(key, known)) {
                message += "; did you mean \"" + *nearest + "\"?";
            } else if (!known.empty()) {
                message += "; known here:";
                for (std::size_t i = 0; i < known.size(); ++i)
                    message += (i ? ", \"" : " \"") + known[i] + "\"";
            }
            report(json_pointer(pointer, key), message, true);
        }
    }
}

void JsonReader::finish() {
    report_unknown_keys();
    if (problems_.empty()) return;
    std::stable_sort(problems_.begin(), problems_.end(), [](const Problem& a, const Problem& b) {
        return std::pair(a.place.line, a.place.column) < std::pair(b.place.line, b.place.column);
    });
    std::string lines;
    for (const Problem& problem : problems_) {
        if (!lines.empty()) lines += '\n';
        lines += error_line(problem.place, problem.message);
    }
    if (full()) lines += "\n" + document_.file() + ": error: there may be more; these are the first found";
    throw Error(ExitCode::usage, lines);
}

}  // namespace ctpbench
