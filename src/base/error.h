// Errors that reach the user, and the exit codes that scripts rely on.
#pragma once

#include <stdexcept>
#include <string>

namespace ctpbench {

enum class ExitCode : int {
    ok = 0,
    internal = 1,       // a defect of ours
    usage = 2,          // command line, config or scene file
    scene_missing = 3,  // a mesh that was asked for is not there
    oracle = 4,         // a contender's hits disagree with the oracle
    regression = 5,
    unclear = 6,
    no_backend = 7,  // a backend asked for by name cannot run here
    output = 8,      // results cannot be written
    interrupted = 130,
};

// The message names the problem and its place, and says what to do.
class Error : public std::runtime_error {
public:
    Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
    ExitCode code() const { return code_; }

private:
    ExitCode code_;
};

}  // namespace ctpbench
