// What a machine or a build is good for, told from what meta.json says of them.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "base/error.h"

namespace ctpbench {

struct Diagnosis {
    enum class State {
        ok,
        warning,  // it runs, but figures are worth less
        missing,  // something is left out
    };
    State state = State::ok;
    std::string what, detail;
    std::string remedy{};               // empty if all is well, or nothing can be done
    std::optional<ExitCode> failure{};  // that a run ends with for want of it
};

// Of describe_build() and describe_machine().
std::vector<Diagnosis> examine_build(const nlohmann::json& build);
std::vector<Diagnosis> examine_machine(const nlohmann::json& machine);

// A line each: `warning  load         2.1 on 2 cores: stop other work, or expect wide intervals`
std::string diagnoses_text(const std::vector<Diagnosis>& diagnoses);

// What the first of them that fails a run fails it with; ok if none does.
ExitCode exit_code_of(const std::vector<Diagnosis>& diagnoses);

}  // namespace ctpbench
