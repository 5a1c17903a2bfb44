// scripts/fetch_scenes against archives that lie on this disk, and against an address that does not exist.
#ifdef CTPBENCH_SOURCE_DIR

#include <cstdlib>

#include "tests/scene/files.h"

namespace ctpbench {
namespace {

class FetchScenes : public SceneFiles {
protected:
    void SetUp() override {
        SceneFiles::SetUp();
        if (std::system("command -v curl >/dev/null && test -x /usr/bin/python3") != 0) {
            GTEST_SKIP() << "needs curl and python3";
        }
        write("packed/inner/room.obj", "v 0 0 0\n");
        write("packed/inner/room.mtl", "newmtl a\n");
        ASSERT_EQ(
            shell("cd '" + (folder / "packed").string() + "' && python3 -m zipfile -c ../room.zip inner"), 0);
        bytes = std::to_string(fs::file_size(folder / "room.zip"));
        shell("sha256sum '" + (folder / "room.zip").string() + "' | cut -c1-64 | tr -d '\\n' > '" +
              (folder / "sum").string() + "'");
        sha256 = read(folder / "sum");
        url = "file://" + (folder / "room.zip").string();
    }

    // What it prints is left in `output`.
    int shell(const std::string& command) {
        const fs::path log = folder / "log";
        const int status = std::system(("(" + command + ") >'" + log.string() + "' 2>&1").c_str());
        output = read(log);
        return WEXITSTATUS(status);
    }
    int fetch(const std::string& arguments = "") {
        write("manifest.json",
              R"({"page": "https://example.org/page", "scenes": [{"name": "room", "url": ")" + url +
                  R"(", "bytes": )" + bytes + R"(, "sha256": )" +
                  (sha256.empty() ? "null" : "\"" + sha256 + "\"") +
                  R"(, "checked": "yes", "folder": "room", "mesh": ")" + mesh +
                  R"(", "triangles": 12, "licence": "CC0", "credit": "Nobody"}]})");
        return shell(std::string(CTPBENCH_SOURCE_DIR) + "/scripts/fetch_scenes --manifest '" +
                     (folder / "manifest.json").string() + "' --dest '" + (folder / "scenes").string() +
                     "' " + arguments);
    }
    bool said(const std::string& part) const { return output.find(part) != std::string::npos; }
    bool fetched() const {
        return fs::exists(folder / "scenes/room/room.obj") && fs::exists(folder / "scenes/room/room.mtl");
    }

    std::string url, bytes, sha256, mesh = "room.obj", output;
};

TEST_F(FetchScenes, UnpacksAndIsIdempotent) {
    EXPECT_EQ(fetch(), 0) << output;
    EXPECT_TRUE(fetched());
    EXPECT_TRUE(said("Nobody") && said("CC0")) << output;
    EXPECT_EQ(std::distance(fs::directory_iterator(folder / "scenes"), {}), 1);  // nothing is left over
    fs::remove(folder / "room.zip");
    EXPECT_EQ(fetch("room"), 0) << output;
    EXPECT_TRUE(said("already there")) << output;
}

TEST_F(FetchScenes, ContinuesAnInterruptedDownload) {
    write("scenes/room.zip.part", read(folder / "room.zip").substr(0, 50));
    EXPECT_EQ(fetch(), 0) << output;
    EXPECT_TRUE(fetched());
}

TEST_F(FetchScenes, SaysTheHashItCannotCheck) {
    sha256.clear();
    bytes = "null";
    EXPECT_EQ(fetch(), 0) << output;
    EXPECT_TRUE(said("the manifest has none to compare with")) << output;
    EXPECT_TRUE(fetched());
}

TEST_F(FetchScenes, RefusesWrongContent) {
    sha256[0] = sha256[0] == '0' ? '1' : '0';
    EXPECT_EQ(fetch(), 1);
    EXPECT_TRUE(said("has SHA-256") && said("it was removed")) << output;
    bytes = "7";
    EXPECT_EQ(fetch(), 1);
    EXPECT_TRUE(said("bytes, not 7")) << output;
    bytes = "null";
    sha256.clear();
    write("room.zip", "<html>not found</html>");
    EXPECT_EQ(fetch(), 1);
    EXPECT_TRUE(said("is not a zip file")) << output;
    EXPECT_FALSE(fs::exists(folder / "scenes/room"));
    EXPECT_FALSE(fs::exists(folder / "scenes/room.zip.part"));
}

TEST_F(FetchScenes, SaysWhichMeshIsMissing) {
    mesh = "hall.obj";
    EXPECT_EQ(fetch(), 1);
    EXPECT_TRUE(said("has no hall.obj; it holds room.obj")) << output;
}

TEST_F(FetchScenes, SaysWhatToDoOffline) {
    url = "file:///nowhere/room.zip";
    EXPECT_EQ(fetch(), 1);
    EXPECT_TRUE(said("cannot download file:///nowhere/room.zip") && said("https://example.org/page"))
        << output;
    EXPECT_TRUE(said((folder / "scenes/room/room.obj").string())) << output;
}

TEST_F(FetchScenes, ListsAndRefusesUnknownNames) {
    EXPECT_EQ(fetch("--list"), 0);
    EXPECT_TRUE(said("12 triangles")) << output;
    EXPECT_EQ(fetch("hall"), 2);
    EXPECT_TRUE(said("unknown scene \"hall\"; choices: room")) << output;
}

TEST_F(FetchScenes, TheManifestThatShipsIsReadable) {
    EXPECT_EQ(shell(std::string(CTPBENCH_SOURCE_DIR) + "/scripts/fetch_scenes --list"), 0) << output;
    for (const char* name : {"conference", "sponza", "san_miguel"}) EXPECT_TRUE(said(name)) << output;
}

}  // namespace
}  // namespace ctpbench

#endif
