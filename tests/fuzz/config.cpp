// Fuzzes the reader of configs: any text is an error that says so, or a config whose echo reads back as it.
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string_view>

#include "base/error.h"
#include "kernels/platform.h"
#include "tests/config/names.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    using namespace ctpbench;
    static const KnownNames names = reader_names();
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    try {
        const Config config = read_config(JsonDocument::parse(text, "fuzz.json"), names);
        const std::string echo = to_json(config).dump();
        try {
            if (!(read_config(JsonDocument::parse(echo, "echo.json"), names) == config)) trap();
        } catch (const Error&) {
            trap();  // what was accepted once must be accepted again
        }
        if (expand(config, names).empty()) trap();
    } catch (const Error& error) {
        if (error.code() != ExitCode::usage || std::string_view(error.what()).empty()) trap();
    }
    return 0;
}
