#include "core/io/FileBytes.h"
#include "core/io/zip/ZipArchive.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"
#include "tests/support/ShippedScene.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <zip.h>

namespace asperity {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

/// A run on a scan that only it knows, and a bundle of it.
class Bundle : public testing::Test {
protected:
    static void SetUpTestSuite() {
        scratch = std::make_unique<test::ScratchFolder>();
        fs::copy(test::shippedScene("polystyrene").parent_path().parent_path(),
                 scratch->file("data"), fs::copy_options::recursive);
        const auto made = run("explore " + in("data/scenes/polystyrene.toml") +
                              " --duration 1 --out " + in("run"));
        ASSERT_EQ(made.exitCode, 0) << made.output;
        const auto bundled = run("bundle " + in("run") + " " + in("run.zip"));
        ASSERT_EQ(bundled.exitCode, 0) << bundled.output;
    }
    static void TearDownTestSuite() { scratch.reset(); }

    static test::ProgramRun run(const std::string& arguments) {
        return test::runProgram(arguments);
    }
    static std::string in(const std::string& name) { return scratch->file(name).string(); }

    /// Replaces a file of a copy of the bundle, or adds one.
    static std::string altered(const char* entry, const std::string& content) {
        const std::string copy = in("altered.zip");
        fs::copy_file(in("run.zip"), copy, fs::copy_options::overwrite_existing);
        put(copy, entry, content);
        return copy;
    }

    /// The same, listed with its new hash.
    static std::string alteredAndListed(const char* entry, const std::string& content) {
        const std::string copy = altered(entry, content);
        const FileBytes bytes(copy);
        const ZipArchive archive(bytes);
        auto list = nlohmann::json::parse(archive.decoded(*archive.find("bundle.json"), 1U << 20U));
        for (auto& file : list["files"]) {
            if (file["name"] == entry) {
                file["bytes"] = content.size();
                file["sha256"] = sha256Of(MemoryBytes(content, entry));
            }
        }
        put(copy, "bundle.json", list.dump());
        return copy;
    }

    /// Replaces a file of an archive, or adds one.
    static void put(const std::string& zip, const char* entry, const std::string& content) {
        zip_t* const archive = zip_open(zip.c_str(), 0, nullptr);
        zip_source_t* const source = zip_source_buffer(archive, content.data(), content.size(), 0);
        EXPECT_GE(zip_file_add(archive, entry, source, ZIP_FL_OVERWRITE), 0);
        EXPECT_EQ(zip_close(archive), 0);
    }

    static std::unique_ptr<test::ScratchFolder> scratch;
};

std::unique_ptr<test::ScratchFolder> Bundle::scratch;

TEST_F(Bundle, ReplaysWithoutTheScanThatItWasMadeOn) {
    fs::rename(scratch->file("data"), scratch->file("gone"));
    const auto again = run("replay " + in("run.zip") + " --out " + in("again"));
    fs::rename(scratch->file("gone"), scratch->file("data"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("bit-identical: 1001 ticks"));
    EXPECT_EQ(test::contentOf(scratch->file("again") / "force_log.csv"),
              test::contentOf(scratch->file("run") / "force_log.csv"));
}

TEST_F(Bundle, IsDrawnAsItsRunIs) {
    const std::string look = " --at 0.5 --size 320x240 --out ";
    const auto ofBundle = run("render " + in("run.zip") + look + in("bundle.png"));
    ASSERT_EQ(ofBundle.exitCode, 0) << ofBundle.output;
    ASSERT_EQ(run("render " + in("run") + look + in("folder.png")).exitCode, 0);
    EXPECT_EQ(test::contentOf(scratch->file("bundle.png")),
              test::contentOf(scratch->file("folder.png")));
}

TEST_F(Bundle, IsAFilm) {
    const auto film =
        run("film " + in("run.zip") + " --duration 0.2 --size 320x240 --out " + in("film"));
    ASSERT_EQ(film.exitCode, 0) << film.output;
    EXPECT_TRUE(fs::exists(scratch->file("film") / "frame_00005.png"));
}

TEST_F(Bundle, IsAFolderOfARunWhenAnotherProgramUnpacksIt) {
    ASSERT_EQ(std::system(
                  ("cd " + scratch->path().string() + " && python3 -m zipfile -e run.zip unpacked")
                      .c_str()),
              0);
    for (const char* name : {"bundle.json", "picture.png", "scene.toml", "scan/particles.gsf",
                             "force_log.csv", "tick_input.csv", "summary.json"}) {
        EXPECT_TRUE(fs::exists(scratch->file("unpacked") / name)) << name;
    }
    EXPECT_THAT(test::contentOf(scratch->file("unpacked") / "scene.toml"),
                HasSubstr("file = 'scan/particles.gsf'"));
    const auto again = run("replay " + in("unpacked") + " --out " + in("again_unpacked"));
    EXPECT_THAT(again.output, HasSubstr("bit-identical: 1001 ticks"));
    const auto json =
        nlohmann::json::parse(test::contentOf(scratch->file("unpacked") / "bundle.json"));
    EXPECT_EQ(json["format"], "asperity bundle");
    EXPECT_EQ(json["files"].size(), 10U);
    for (const auto& file : json["files"]) {
        EXPECT_EQ(file["bytes"],
                  fs::file_size(scratch->file("unpacked") / file["name"].get<std::string>()));
        EXPECT_EQ(file["sha256"].get<std::string>().size(), 64U);
    }
}

TEST_F(Bundle, HoldsAPartThatReplays) {
    const auto part = run("bundle " + in("run") + " " + in("part.zip") + " --from 0.3 --to 0.6");
    ASSERT_EQ(part.exitCode, 0) << part.output;
    const auto again = run("replay " + in("part.zip") + " --out " + in("again_part"));
    EXPECT_EQ(again.exitCode, 0) << again.output;
    EXPECT_THAT(again.output, HasSubstr("bit-identical: 301 ticks"));
    const auto none = run("bundle " + in("run") + " " + in("none.zip") + " --from 5");
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_THAT(none.output, HasSubstr("it goes from 0 s to 1 s"));
    EXPECT_FALSE(fs::exists(in("none.zip")));
}

TEST_F(Bundle, ReplacesNothingUnasked) {
    const auto again = run("bundle " + in("run") + " " + in("run.zip"));
    EXPECT_EQ(again.exitCode, 1);
    EXPECT_THAT(again.output, HasSubstr("is there already"));
    const std::string log = test::contentOf(scratch->file("run") / "force_log.csv");
    const auto inside = run("bundle " + in("run") + " " + in("run/force_log.csv") + " --force");
    EXPECT_EQ(inside.exitCode, 1);
    EXPECT_THAT(inside.output, HasSubstr("lies in the folder of one"));
    EXPECT_EQ(test::contentOf(scratch->file("run") / "force_log.csv"), log);
}

TEST_F(Bundle, IsRefusedWhereTheRunDoesNotReplay) {
    fs::remove_all(scratch->file("tampered"));
    fs::copy(scratch->file("run"), scratch->file("tampered"));
    std::string log = test::contentOf(scratch->file("tampered") / "force_log.csv");
    const std::size_t line = log.find("\n0.5,");
    ASSERT_NE(line, std::string::npos);
    log.insert(log.find(',', log.find(',', line + 1) + 1), "1");
    std::ofstream(scratch->file("tampered") / "force_log.csv") << log;
    for (const char* part : {"", " --from 0.1 --to 0.2"}) {
        const auto refused = run("bundle " + in("tampered") + " " + in("tampered.zip") + part);
        EXPECT_EQ(refused.exitCode, 1);
        EXPECT_THAT(refused.output, HasSubstr("does not replay: first differing tick: 500"));
        EXPECT_FALSE(fs::exists(in("tampered.zip")));
    }
}

TEST_F(Bundle, HasNoPartThatEndsBeforeItBegins) {
    const auto none = run("bundle " + in("run") + " " + in("none.zip") + " --from 0.5 --to 0.3");
    EXPECT_EQ(none.exitCode, 1);
    EXPECT_THAT(none.output, HasSubstr("--from 0.5 s is after --to 0.3 s"));
}

TEST_F(Bundle, IsRefusedWhereTheScanIsAnother) {
    const fs::path scan = scratch->file("data") / "samples/particles.gsf";
    const std::string content = test::contentOf(scan);
    std::ofstream(scan, std::ios::app) << " ";
    const auto changed = run("bundle " + in("run") + " " + in("changed.zip"));
    std::ofstream(scan) << content;
    EXPECT_EQ(changed.exitCode, 3);
    EXPECT_THAT(changed.output, HasSubstr("particles.gsf"));
    EXPECT_FALSE(fs::exists(in("changed.zip")));
}

TEST_F(Bundle, SaysWhichFileIsDamaged) {
    const std::string replay = " --out " + in("damaged");
    const auto table = run("replay " + altered("force_log.csv", "time_s\n") + replay);
    EXPECT_EQ(table.exitCode, 3);
    EXPECT_THAT(table.output, HasSubstr("altered.zip: force_log.csv: this file is damaged"));
    const auto directory = run("replay " + altered("bundle.json", "{}") + replay);
    EXPECT_EQ(directory.exitCode, 3);
    EXPECT_THAT(directory.output, HasSubstr("altered.zip: bundle.json: expected"));
    const auto outside = run(
        "replay " +
        altered("bundle.json", R"({"format": "asperity bundle", "format_version": 1, "files": [)"
                               R"({"name": "scan/../../x", "bytes": 1, "sha256": ""}]})") +
        replay);
    EXPECT_EQ(outside.exitCode, 3);
    EXPECT_THAT(outside.output, HasSubstr("is no file of a run"));
    const auto noBundle = run("replay " + in("run/scene.toml") + replay);
    EXPECT_EQ(noBundle.exitCode, 3);
    EXPECT_THAT(noBundle.output, Not(HasSubstr("bit-identical")));
}

// They named a file of a folder that was gone by then.
TEST_F(Bundle, RefusalsNameItAndThePart) {
    const auto expectNamed = [](const std::string& command, const std::string& named) {
        const auto refused = run(command);
        EXPECT_EQ(refused.exitCode, 3) << command;
        EXPECT_THAT(refused.output, HasSubstr("asperity: " + named + ": ")) << command;
        EXPECT_THAT(refused.output, Not(HasSubstr(".asperity-"))) << command;
    };
    const std::string copy = alteredAndListed("scene.toml", "broken");
    for (const std::string& command :
         {"replay " + copy + " --out " + in("refused"), "report " + copy + " --out " + in("page"),
          "bundle " + copy + " " + in("refused.zip"),
          "render " + copy + " --out " + in("refused.png")}) {
        expectNamed(command, copy + ", scene.toml");
    }
    expectNamed("report " + alteredAndListed("summary.json", "[1]") + " --out " + in("page"),
                copy + ", summary.json");
}

}  // namespace
}  // namespace asperity
