#include "app/recording/Bundle.h"
#include "core/io/zip/ZipWriter.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

namespace asperity::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

constexpr const char* kHash = "2cf24dba5fb0a30e26e83b2ac5b9e29e1b161e5c1fa7425e73043362938b9824";

/// A bundle of one file, "hello", whose directory says of it what a test wants.
class UnpackBundle : public testing::Test {
protected:
    [[nodiscard]] std::string refusal(const json& files, const std::string& name = "summary.json") {
        const json directory{
            {"format", "asperity bundle"}, {"format_version", 1}, {"files", files}};
        ZipWriter zip(bundle);
        zip.addFile("bundle.json", scratch.write("directory", directory.dump()));
        zip.addFile(name, scratch.write("content", "hello"));
        zip.close();
        return refusalOf([this] { unpackBundle(bundle, scratch.file("out")); });
    }
    static json listed(const std::string& name, int bytes = 5) {
        return {{"name", name}, {"bytes", bytes}, {"sha256", kHash}};
    }

    ScratchFolder scratch;
    std::filesystem::path bundle = scratch.file("a.zip");
};

TEST_F(UnpackBundle, WritesWhatIsListed) {
    EXPECT_EQ(refusal(json::array({listed("summary.json")})), "");
    EXPECT_EQ(contentOf(scratch.file("out") / "summary.json"), "hello");
}

/// A small archive could hold a file for the whole disk.
TEST_F(UnpackBundle, RefusesMoreBytesThanAreListed) {
    EXPECT_THAT(refusal(json::array({listed("summary.json", 4)})),
                HasSubstr("a.zip: summary.json: it holds 5 bytes; at most 4 are expected"));
    EXPECT_FALSE(std::filesystem::exists(scratch.file("out") / "summary.json"));
}

TEST_F(UnpackBundle, RefusesMoreBytesThanItsOwnCanBe) {
    const int most = 1 << 29;
    EXPECT_THAT(
        refusal(json::array({listed("force_log.csv", most), listed("summary.json", 1)})),
        HasSubstr("a.zip: summary.json: the files up to this one have more than 536870912"));
    EXPECT_FALSE(std::filesystem::exists(scratch.file("out")));
}

TEST_F(UnpackBundle, RefusesWhatIsNoNumberOfBytes) {
    for (const json& bytes : {json(1e300), json(5.0), json(-5), json("5"), json(true), json()}) {
        json file = listed("summary.json");
        file["bytes"] = bytes;
        EXPECT_THAT(refusal(json::array({file})),
                    HasSubstr("a.zip: bundle.json: expected a whole number of bytes"))
            << bytes;
    }
}

TEST_F(UnpackBundle, RefusesADirectoryThatIsTooDeep) {
    json deep = json::array();
    for (int i = 0; i < 100; ++i) {
        deep = json::array({deep});
    }
    EXPECT_THAT(refusal(deep), HasSubstr("a.zip: bundle.json: line 1: values nested deeper"));
}

TEST_F(UnpackBundle, RefusesAFileThatIsListedTwice) {
    EXPECT_THAT(refusal(json::array({listed("summary.json"), listed("summary.json")})),
                HasSubstr("'summary.json' is listed twice"));
}

TEST_F(UnpackBundle, RefusesANameThatNoFolderTakes) {
    const std::string name = "scan/" + std::string(300, 'a');
    EXPECT_THAT(refusal(json::array({listed(name)}), name), HasSubstr("is no file of a run"));
}

}  // namespace
}  // namespace asperity::test
