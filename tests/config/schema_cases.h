// Configs that are wrong, or right, in one place: seeded changes to those that are right throughout.
#pragma once

#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

namespace ctpbench::test {

class ConfigMutator {
public:
    ConfigMutator(const nlohmann::ordered_json& schema, std::uint64_t seed) : schema_(schema), engine_(seed) {
        for (const char* text : {"null",
                                 "true",
                                 "0",
                                 "-1",
                                 "1",
                                 "2",
                                 "-0.0",
                                 "1.5",
                                 "3.0",
                                 "1e3",
                                 "1e300",
                                 "-1e300",
                                 "18446744073709551615",
                                 "18446744073709551616",
                                 "\"\"",
                                 "\"x\"",
                                 "\"a/b\"",
                                 "\"ctp\"",
                                 "\".x\"",
                                 "[]",
                                 "{}",
                                 "[1, 1]",
                                 "[1, 1.0]",
                                 "[0.5, 2]",
                                 "[true, true]",
                                 "[\"ctp\", \"ctp\"]",
                                 "[\"x\", null]",
                                 "[[1]]",
                                 "{\"x\": 1}",
                                 "[{}]",
                                 "[{\"scene\": []}]",
                                 "[{\"x\": 1}]",
                                 "\"table2\"",
                                 "[\"table2\"]"})
            values_.push_back(nlohmann::json::parse(text));
        nlohmann::json many = nlohmann::json::array();
        while (many.size() < 1001) many.push_back(many.size());
        values_.push_back(many);
        collect_bounds(schema);
    }

    // With one change.
    nlohmann::json mutated(nlohmann::json config) {
        nlohmann::json* at = &config;
        const nlohmann::ordered_json* keys = &schema_.at("properties");
        if (chance(2) && config.contains("matrix")) {
            at = &config["matrix"];
            keys = &schema_.at("definitions").at("axes").at("properties");
        }
        const std::string key = chance(12) ? "x" : key_of(*keys);
        switch (below(4)) {
            case 0:
                at->erase(key);
                break;
            case 1:
                (*at)[key] = nlohmann::json::array({values_[below(values_.size())]});
                break;
            default:
                (*at)[key] = values_[below(values_.size())];
        }
        return config;
    }

private:
    std::size_t below(std::size_t n) { return engine_() % n; }
    bool chance(std::size_t one_in) { return below(one_in) == 0; }
    std::string key_of(const nlohmann::ordered_json& keys) {
        return std::next(keys.begin(), static_cast<std::ptrdiff_t>(below(keys.size()))).key();
    }

    // Numbers at the ends of ranges and beyond them, and all names.
    void collect_bounds(const nlohmann::ordered_json& schema) {
        for (const auto& [key, value] : schema.items()) {
            if (key == "enum") {
                for (const auto& name : value) values_.push_back(name);
            } else if (key == "minimum" || key == "maximum" || key == "exclusiveMinimum") {
                values_.push_back(value);
                if (value > 0 && value < 1e18) values_.push_back(value.get<double>() + 1);
                if (value < 1e18) values_.push_back(value.get<std::int64_t>() + (key == "maximum" ? 1 : -1));
            } else if (value.is_structured()) {
                collect_bounds(value);
            }
        }
    }

    const nlohmann::ordered_json& schema_;
    std::mt19937_64 engine_;
    std::vector<nlohmann::json> values_;
};

}  // namespace ctpbench::test
