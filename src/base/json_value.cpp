#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

#include "base/json_reader.h"
#include "base/suggest.h"

namespace ctpbench {
namespace {

// What was found instead, short enough for one line.
std::string describe(const nlohmann::json& json) {
    constexpr std::size_t longest = 40;
    if (json.is_object()) return "an object";
    if (json.is_array()) return "a list of " + std::to_string(json.size());
    std::string text = json.dump(-1, ' ', true, nlohmann::json::error_handler_t::replace);
    if (text.size() > longest) text = text.substr(0, longest) + "...";
    return text;
}

std::string number(double value) {
    std::ostringstream text;
    text.precision(15);
    text << value;
    return text.str();
}

std::string describe(const Range& allowed) {
    const std::string low = number(allowed.low), high = number(allowed.high);
    if (std::isinf(allowed.high)) return (allowed.includes_low ? "at least " : "greater than ") + low;
    if (std::isinf(allowed.low)) return "at most " + high;
    return (allowed.includes_low ? "from " : "greater than ") + low +
           (allowed.includes_low ? " to " : " and at most ") + high;
}

}  // namespace

bool JsonValue::is_list() const { return json_ && json_->is_array(); }
bool JsonValue::is_object() const { return json_ && json_->is_object(); }
bool JsonValue::is_string() const { return json_ && json_->is_string(); }

void JsonValue::error(std::string_view message) const { reader_->report(pointer_, message); }

bool JsonValue::wrong_type(std::string_view expected) const {
    error("expected " + std::string(expected) + ", found " + describe(*json_));
    return false;
}

bool JsonValue::in_range(double value, const Range& allowed) const {
    const bool low_enough = value <= allowed.high;
    const bool high_enough = allowed.includes_low ? value >= allowed.low : value > allowed.low;
    if (low_enough && high_enough) return true;
    error("must be " + describe(allowed) + ", found " + describe(*json_));
    return false;
}

bool JsonValue::read(bool& out) const {
    if (!json_) return false;
    if (!json_->is_boolean()) return wrong_type("true or false");
    out = json_->get<bool>();
    return true;
}

template <class Integer>
bool JsonValue::read_integer(Integer& out, const Range& allowed) const {
    if (!json_) return false;
    // JSON knows numbers alone: 1e3 and 1000.0 are the integer 1000.
    const double value = json_->is_number() ? json_->get<double>() : std::nan("");
    if (!(value == std::trunc(value))) return wrong_type("an integer");
    if (!in_range(value, allowed)) return false;
    using Limits = std::numeric_limits<Integer>;
    const bool fits = json_->is_number_unsigned() ? std::in_range<Integer>(json_->get<std::uint64_t>())
                      : json_->is_number_integer()
                          ? std::in_range<Integer>(json_->get<std::int64_t>())
                          : value >= static_cast<double>(Limits::min()) &&
                                value < std::ldexp(1.0, Limits::digits);  // one beyond the largest
    if (!fits) {
        error("must be from " + std::to_string(Limits::min()) + " to " + std::to_string(Limits::max()) +
              ", found " + describe(*json_));
        return false;
    }
    out = json_->is_number_float() ? static_cast<Integer>(value) : json_->get<Integer>();
    return true;
}

bool JsonValue::read(std::int32_t& out, const Range& allowed) const { return read_integer(out, allowed); }
bool JsonValue::read(std::int64_t& out, const Range& allowed) const { return read_integer(out, allowed); }
bool JsonValue::read(std::uint32_t& out, const Range& allowed) const { return read_integer(out, allowed); }
bool JsonValue::read(std::uint64_t& out, const Range& allowed) const { return read_integer(out, allowed); }

bool JsonValue::read(double& out, const Range& allowed) const {
    if (!json_) return false;
    if (!json_->is_number()) return wrong_type("a number");
    const double value = json_->get<double>();
    if (!in_range(value, allowed)) return false;
    out = value;
    return true;
}

bool JsonValue::read(float& out, const Range& allowed) const {
    double value = 0;
    if (!read(value, allowed)) return false;
    if (std::abs(value) > std::numeric_limits<float>::max()) {
        error("too large for single precision, found " + describe(*json_));
        return false;
    }
    out = static_cast<float>(value);
    return true;
}

bool JsonValue::read(std::string& out) const {
    if (!json_) return false;
    if (!json_->is_string()) return wrong_type("text in double quotes");
    out = json_->get<std::string>();
    return true;
}

bool JsonValue::read(std::string& out, const std::vector<std::string>& choices) const {
    std::string name;
    if (!read(name)) return false;
    if (std::find(choices.begin(), choices.end(), name) == choices.end()) {
        error(unknown_name("name", name, choices));
        return false;
    }
    out = std::move(name);
    return true;
}

bool JsonValue::read(Vec3& out, const Range& allowed) const {
    if (!json_) return false;
    if (!json_->is_array() || json_->size() != 3) return wrong_type("a list of three numbers");
    Vec3 value{};
    bool right = true;
    for (int axis = 0; axis < 3; ++axis)
        right &= list()[static_cast<std::size_t>(axis)].read(value[axis], allowed);
    if (right) out = value;
    return right;
}

JsonObject JsonValue::object() const {
    if (json_ && !json_->is_object()) {
        wrong_type("an object");
        return {reader_, nullptr, pointer_};
    }
    return {reader_, json_, pointer_};
}

std::vector<JsonValue> JsonValue::list() const {
    if (!json_) return {};
    if (!json_->is_array()) {
        wrong_type("a list");
        return {};
    }
    std::vector<JsonValue> elements;
    for (std::size_t i = 0; i < json_->size(); ++i) {
        elements.push_back({reader_, &(*json_)[i], json_pointer(pointer_, i)});
    }
    return elements;
}

std::vector<JsonValue> JsonValue::list_or_one() const {
    if (!json_ || json_->is_array()) return list();
    return {*this};
}

}  // namespace ctpbench
