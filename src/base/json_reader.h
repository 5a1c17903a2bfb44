// Typed reading of a JsonDocument into plain structs with defaults. It never stops at the first mistake:
// wrong types, values out of range, unknown names and unknown keys are collected, and finish() throws them
// all as one Error.
//
//     JsonReader reader(JsonDocument::load(path));
//     JsonObject root = reader.root();
//     root.get("width", config.width, range(1, 16384));      // absent: config.width keeps its default
//     root.require("name", config.name);                     // absent: an error
//     root.get("mode", config.mode, {"fast", "exact"});      // one of these names
//     JsonObject camera = root.object("camera");             // absent: an object without members
//     camera.get("eye", config.eye);
//     for (JsonValue file : root.list("files")) ...          // absent: no elements
//     for (auto& [name, value] : root.object("materials").members()) ...  // keys that are the user's own
//     reader.finish();                                       // also reports the keys nobody asked for
//
// JsonObject and JsonValue point into the reader and must not outlive it.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <limits>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/json_document.h"
#include "kernels/vec.h"

namespace ctpbench {

class JsonReader;
class JsonObject;

struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool includes_low = true;
};
inline Range range(double low, double high) { return {low, high, true}; }
inline Range at_least(double low) { return {low, std::numeric_limits<double>::infinity(), true}; }
inline Range above(double low) { return {low, std::numeric_limits<double>::infinity(), false}; }

// One value, or the absence of one. read() leaves `out` alone and returns false if the value is absent or
// wrong; the latter is recorded as an error. Numbers are finite.
class JsonValue {
public:
    bool present() const { return json_ != nullptr; }
    bool is_list() const;
    bool is_object() const;
    bool is_string() const;

    bool read(bool& out) const;
    bool read(std::int32_t& out, const Range& allowed = {}) const;
    bool read(std::int64_t& out, const Range& allowed = {}) const;
    bool read(std::uint32_t& out, const Range& allowed = {}) const;
    bool read(std::uint64_t& out, const Range& allowed = {}) const;
    bool read(float& out, const Range& allowed = {}) const;
    bool read(double& out, const Range& allowed = {}) const;
    bool read(std::string& out) const;
    bool read(std::string& out, const std::vector<std::string>& choices) const;
    bool read(Vec3& out, const Range& allowed = {}) const;  // [x, y, z]

    JsonObject object() const;
    std::vector<JsonValue> list() const;
    // The elements of a list; a value that is no list stands for a list of itself.
    std::vector<JsonValue> list_or_one() const;

    // Records an error at this value.
    void error(std::string_view message) const;
    const std::string& pointer() const { return pointer_; }

private:
    friend class JsonObject;
    friend class JsonReader;
    JsonValue(JsonReader* reader, const nlohmann::json* json, std::string pointer)
        : reader_(reader), json_(json), pointer_(std::move(pointer)) {}
    template <class Integer>
    bool read_integer(Integer& out, const Range& allowed) const;
    bool in_range(double value, const Range& allowed) const;
    bool wrong_type(std::string_view expected) const;

    JsonReader* reader_;
    const nlohmann::json* json_;
    std::string pointer_;
};

// The members of one object. Asking for a key makes it a known key.
class JsonObject {
public:
    bool has(std::string_view key) const { return value(key).present(); }
    JsonValue value(std::string_view key) const;

    template <class T>
    bool get(std::string_view key, T& out) const {
        return value(key).read(out);
    }
    template <class T>
    bool get(std::string_view key, T& out, const Range& allowed) const {
        return value(key).read(out, allowed);
    }
    bool get(std::string_view key, std::string& out, const std::vector<std::string>& choices) const {
        return value(key).read(out, choices);
    }
    // As get(), but the key must be there.
    template <class T, class... Limit>
    bool require(std::string_view key, T& out, const Limit&... limit) const {
        return demand(key) && get(key, out, limit...);
    }

    JsonObject object(std::string_view key) const;
    std::vector<JsonValue> list(std::string_view key) const { return value(key).list(); }
    // Every member, for an object whose keys are data; none of them is reported as unknown.
    std::vector<std::pair<std::string, JsonValue>> members() const;

    // Records an error at the object itself, or at the value of one of its keys.
    void error(std::string_view message) const;
    void error(std::string_view key, std::string_view message) const;

private:
    friend class JsonValue;
    friend class JsonReader;
    JsonObject(JsonReader* reader, const nlohmann::json* json, std::string pointer);
    bool demand(std::string_view key) const;

    JsonReader* reader_;
    const nlohmann::json* json_;  // null if the object is absent
    std::string pointer_;
};

class JsonReader {
public:
    explicit JsonReader(JsonDocument document) : document_(std::move(document)) {}
    JsonReader(const JsonReader&) = delete;
    JsonReader& operator=(const JsonReader&) = delete;

    JsonObject root();
    const JsonDocument& document() const { return document_; }
    bool failed() const { return !problems_.empty(); }

    // Reports the keys that were never asked for; throws Error(usage), one line per error in the order of
    // the file, if there was any.
    void finish();

private:
    friend class JsonValue;
    friend class JsonObject;
    struct Problem {
        JsonPlace place;
        std::string message;
    };
    // An object that was read, and the keys that it may have.
    struct Visited {
        const nlohmann::json* json;
        std::vector<std::string> known;
        bool all_known = false;  // keys are data
    };
    void report(std::string_view pointer, std::string_view message, bool at_key = false);
    void report_unknown_keys();
    bool full() const { return problems_.size() >= JsonDocument::max_errors; }

    JsonDocument document_;
    std::vector<Problem> problems_;
    std::map<std::string, Visited> visited_;  // by JSON pointer
};

}  // namespace ctpbench
