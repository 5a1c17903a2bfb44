// JsonDocument::parse. The grammar is nlohmann_json's, through its event interface, which does not tell where
// a token started. TokenCursor finds that out: it walks the same text one token behind the parser, so all it
// sees has been accepted already, and it need not judge.
#include <algorithm>

#include "base/error.h"
#include "base/json_document.h"

namespace ctpbench {
namespace {

class TokenCursor {
public:
    explicit TokenCursor(std::string_view text) : text_(text) {}

    // Start of the next token that is a key, a value or a bracket; the text's size if there is none.
    std::size_t peek() {
        while (at_ < text_.size()) {
            const std::string_view rest = text_.substr(at_);
            if (std::string_view(" \t\r\n,:").find(rest.front()) != std::string_view::npos) {
                ++at_;
            } else if (rest.starts_with("//")) {
                at_ += std::min(rest.find('\n'), rest.size());
            } else if (rest.starts_with("/*")) {
                at_ += std::min(rest.find("*/", 2), rest.size() - 2) + 2;
            } else {
                break;
            }
        }
        return at_;
    }

    std::size_t take() {
        const std::size_t start = peek();
        if (start >= text_.size()) return start;
        const char first = text_[at_++];
        if (first == '"') {
            while (at_ < text_.size() && text_[at_] != '"') at_ += text_[at_] == '\\' ? 2 : 1;
            ++at_;
        } else if (std::string_view("{}[]").find(first) == std::string_view::npos) {
            at_ = std::min(text_.find_first_of(" \t\r\n,:/]}", at_), text_.size());
        }
        return start;
    }

private:
    std::string_view text_;
    std::size_t at_ = 0;
};

// "unexpected ']'; expected ..." out of the library's long message, which repeats the place its own way.
std::string essence(const std::string& what) {
    const std::size_t dash = what.find(" - ");
    if (dash == std::string::npos) return what.substr(what.find("] ") + 2);
    const std::string reason = what.substr(dash + 3);
    return reason.substr(0, reason.find("; last read"));
}

}  // namespace

class JsonDocumentBuilder : public nlohmann::json_sax<nlohmann::json> {
public:
    JsonDocumentBuilder(JsonDocument& document, std::string_view text)
        : document_(document), text_(text), cursor_(text) {}

    bool null() override { return leaf(nullptr); }
    bool boolean(bool value) override { return leaf(value); }
    bool number_integer(number_integer_t value) override { return leaf(value); }
    bool number_unsigned(number_unsigned_t value) override { return leaf(value); }
    bool number_float(number_float_t value, const string_t&) override { return leaf(value); }
    bool string(string_t& value) override { return leaf(std::move(value)); }
    bool binary(binary_t&) override { return false; }  // JSON text has none
    bool start_object(std::size_t) override { return open(nlohmann::json::object()); }
    bool start_array(std::size_t) override { return open(nlohmann::json::array()); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        key_start_ = cursor_.take();
        key_ = name;
        pointer_ = json_pointer(open_.back().pointer, key_);
        if (pointer_.size() > JsonDocument::max_pointer) {
            add_error(key_start_, "the keys down to here have more than " +
                                      std::to_string(JsonDocument::max_pointer) +
                                      " characters together; shorten them");
            return false;
        }
        const auto earlier = document_.origins_.find(pointer_);
        if (earlier != document_.origins_.end()) {
            const JsonPlace first = place_in_text(text_, earlier->second.key, document_.file_);
            add_error(key_start_, pointer_ + ": the key is here twice, first in line " +
                                      std::to_string(first.line) + "; remove one of the two");
            document_.forget_below(pointer_);
        }
        return error_count_ < JsonDocument::max_errors;
    }

    bool parse_error(std::size_t position, const std::string&, const nlohmann::json::exception& ex) override {
        const std::string reason = essence(ex.what());
        const std::size_t token = cursor_.peek();
        // Within a token the parser knows the very character; between tokens, the token counts.
        const bool within = reason.starts_with("invalid") && position > 0;
        add_error(within ? std::min(position - 1, text_.size()) : token, reason + remedy(reason, token));
        return false;
    }

    // All errors, one a line; empty if there were none.
    const std::string& errors() const { return errors_; }

private:
    struct Open {
        nlohmann::json* container;
        std::string pointer;
    };

    bool leaf(nlohmann::json value) {
        add(std::move(value));
        return true;
    }

    bool open(nlohmann::json empty) {
        if (open_.size() >= JsonDocument::max_depth) {
            add_error(cursor_.peek(), "nested deeper than " + std::to_string(JsonDocument::max_depth) +
                                          " levels; flatten it");
            return false;
        }
        nlohmann::json& container = add(std::move(empty));
        open_.push_back({&container, pointer_});
        return true;
    }

    bool close() {
        cursor_.take();
        open_.pop_back();
        return true;
    }

    // A container is reached through open_ only while it grows no further, so its address holds.
    nlohmann::json& add(nlohmann::json value) {
        const std::size_t start = cursor_.take();
        if (open_.empty()) {
            document_.origins_[pointer_] = {start, start, {}};
            return document_.value_ = std::move(value);
        }
        nlohmann::json& container = *open_.back().container;
        if (container.is_object()) {
            document_.origins_[pointer_] = {key_start_, start, {}};
            return container[key_] = std::move(value);
        }
        pointer_ = json_pointer(open_.back().pointer, container.size());
        document_.origins_[pointer_] = {start, start, {}};
        container.push_back(std::move(value));
        return container.back();
    }

    std::string remedy(const std::string& reason, std::size_t token) const {
        const auto says = [&](std::string_view part) { return reason.find(part) != std::string::npos; };
        const std::size_t last =
            token == 0 ? std::string_view::npos : text_.find_last_not_of(" \t\r\n", token - 1);
        if (token >= text_.size()) return "; the text ends too early: close every string, list and object";
        if (says("closing quote") || says("control character")) return "; close the string on its own line";
        if (says("unexpected ']'") || says("unexpected '}'")) {
            if (last != std::string_view::npos && text_[last] == ',') return "; remove the comma before it";
            return "; check that brackets pair up and that no value is missing";
        }
        if (says("expected end of input")) return "; remove what follows the end of the document";
        if (says("expected ']'") || says("expected '}'")) return "; put a comma between two values";
        if (says("expected string literal")) return "; write keys in double quotes";
        if (says("expected ':'")) return "; put a colon between key and value";
        if (says("invalid literal")) {
            return "; text and keys go in double quotes, other values are numbers, true, false or null";
        }
        if (says("number overflow")) return "; the largest number is about 1.8e308";
        return {};
    }

    void add_error(std::size_t offset, const std::string& message) {
        ++error_count_;
        if (!errors_.empty()) errors_ += '\n';
        errors_ += error_line(place_in_text(text_, offset, document_.file_), message);
    }

    JsonDocument& document_;
    std::string_view text_;
    TokenCursor cursor_;
    std::vector<Open> open_;
    std::string pointer_;  // of the member or element at hand
    std::string key_;
    std::size_t key_start_ = 0;
    std::string errors_;
    std::size_t error_count_ = 0;
};

JsonDocument JsonDocument::parse(std::string_view text, const std::string& file) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark takes no column
    const auto refuse_at = [&](std::size_t offset, const std::string& message) {
        throw Error(ExitCode::usage, error_line(place_in_text(text, offset, file), message));
    };
    if (text.size() > max_bytes) {
        refuse_at(0, "larger than " + std::to_string(max_bytes >> 10) + " KiB; is it the right file?");
    }
    // The library takes a zero byte for the end of the text and would not see what follows it.
    const std::size_t zero = text.find('\0');
    if (zero != std::string_view::npos) refuse_at(zero, "a zero byte; save the file as UTF-8 text");

    JsonDocument document;
    document.file_ = file;
    document.text_ = text;
    JsonDocumentBuilder builder(document, text);
    constexpr bool strict = true, ignore_comments = true;
    const bool parsed = nlohmann::json::sax_parse(
        text.begin(), text.end(), &builder, nlohmann::json::input_format_t::json, strict, ignore_comments);
    if (!parsed || !builder.errors().empty()) throw Error(ExitCode::usage, builder.errors());
    return document;
}

}  // namespace ctpbench
