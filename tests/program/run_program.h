// Runs the program as a user would, and reads what it left behind.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace ctpbench::test {

struct Outcome {
    int exit_code = -1;
    std::string output;  // of both streams
};

// `shell` may hold quotes and redirections; $P stands for the program.
inline Outcome run_shell(const std::string& shell) {
    Outcome outcome;
    const std::string command = "P='" CTPBENCH_PROGRAM "'; { " + shell + "; } 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return outcome;
    char buffer[4096];
    for (std::size_t n; (n = std::fread(buffer, 1, sizeof buffer, pipe)) > 0;)
        outcome.output.append(buffer, n);
    const int status = pclose(pipe);
    outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
    return outcome;
}

// A folder for one test, removed afterwards.
class ProgramTest : public testing::Test {
protected:
    void SetUp() override {
        const auto* info = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() /
                  ("ctpbench_" + std::to_string(getpid()) + "_" + info->name());
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    std::filesystem::path write(const std::string& name, const std::string& text) const {
        std::ofstream(folder_ / name, std::ios::binary) << text;
        return folder_ / name;
    }
    static std::string read(const std::filesystem::path& path) {
        std::stringstream text;
        text << std::ifstream(path, std::ios::binary).rdbuf();
        return text.str();
    }
    // Lines as maps from column name to field. Quotes enclose fields and are not in them.
    static std::vector<std::map<std::string, std::string>> read_csv(const std::filesystem::path& path) {
        std::istringstream text(read(path));
        std::vector<std::string> names;
        std::vector<std::map<std::string, std::string>> lines;
        for (std::string line; std::getline(text, line);) {
            if (!line.empty() && line.back() == '\r') line.pop_back();
            std::vector<std::string> fields{""};
            bool quoted = false;
            for (char c : line) {
                if (c == '"')
                    quoted = !quoted;
                else if (c == ',' && !quoted)
                    fields.emplace_back();
                else
                    fields.back() += c;
            }
            if (names.empty()) {
                names = fields;
                continue;
            }
            auto& entry = lines.emplace_back();
            for (std::size_t i = 0; i < fields.size(); ++i) entry[names.at(i)] = fields[i];
        }
        return lines;
    }
    // Runs the program with these arguments; ${D} in them stands for the test's folder.
    Outcome run(const std::string& arguments) const {
        return run_shell("D='" + folder_.string() + "'; C='" CTPBENCH_SOURCE_DIR "/configs'; \"$P\" " +
                         arguments);
    }

    std::filesystem::path folder_;
};

}  // namespace ctpbench::test
