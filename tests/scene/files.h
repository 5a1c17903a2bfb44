// What the scene tests share: a folder of their own, an environment of their own, and errors as values.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "scene/notices.h"

namespace ctpbench {

namespace fs = std::filesystem;

// A temporary folder that also holds the cache and the home folder, so that no test sees the user's own.
class SceneFiles : public testing::Test {
protected:
    void SetUp() override {
        std::string name = (fs::temp_directory_path() / "ctpbench-test-XXXXXX").string();
        ASSERT_NE(::mkdtemp(name.data()), nullptr);
        folder = name;
        for (const char* variable : {"HOME", "CTPBENCH_CACHE", "CTPBENCH_SCENES"}) {
            const char* value = ::getenv(variable);
            saved_.emplace_back(variable, value ? std::optional<std::string>(value) : std::nullopt);
        }
        ::setenv("HOME", (folder / "home").c_str(), 1);
        ::setenv("CTPBENCH_CACHE", (folder / "cache").c_str(), 1);
        ::unsetenv("CTPBENCH_SCENES");
    }
    void TearDown() override {
        fs::remove_all(folder);
        for (const auto& [name, value] : saved_) value ? ::setenv(name, value->c_str(), 1) : ::unsetenv(name);
    }

    fs::path write(const fs::path& name, const std::string& text) const {
        const fs::path path = folder / name;
        fs::create_directories(path.parent_path());
        std::ofstream(path, std::ios::binary) << text;
        return path;
    }
    static std::string read(const fs::path& path) {
        std::stringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }

    fs::path folder;
    Notices notices;

private:
    std::vector<std::pair<const char*, std::optional<std::string>>> saved_;
};

inline bool has_notice(const Notices& notices, const std::string& part) {
    for (const std::string& notice : notices) {
        if (notice.find(part) != std::string::npos) return true;
    }
    return false;
}

// The error that a call ends with; an ok one if it returns.
template <class Call>
std::pair<ExitCode, std::string> error_of(Call&& call) {
    try {
        call();
        return {ExitCode::ok, ""};
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
}

#define EXPECT_ERROR(call, expected_code, part)                                            \
    do {                                                                                   \
        const auto [code, message] = ::ctpbench::error_of([&] { (void)(call); });          \
        EXPECT_EQ(static_cast<int>(code), static_cast<int>(expected_code)) << message;     \
        EXPECT_NE(message.find(part), std::string::npos) << "the message is: " << message; \
    } while (false)

}  // namespace ctpbench
