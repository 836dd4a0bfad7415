#include "tests/core/io/heightmap/RealScans.h"

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "tests/support/ReferenceTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

// The list of real files leaves none out, and those that are malformed are refused.

namespace asperity::test {

namespace {

class Malformed : public testing::TestWithParam<MalformedScan> {
protected:
    void SetUp() override { ASPERITY_NEEDS_SHARED_DATA(); }
};

TEST(RealScans, AreThoseOfTheManifestAndNoOthers) {
    ASPERITY_NEEDS_SHARED_DATA();
    const ReferenceTable manifest(sharedData("afm/MANIFEST.csv"));
    std::vector<std::string> files;
    for (std::size_t row = 0; row < manifest.rows(); ++row) {
        files.push_back(manifest.text(row, "file"));
    }
    EXPECT_THAT(allScans(), testing::UnorderedElementsAreArray(files));
}

TEST_P(Malformed, IsRefusedWithFileLocationAndReason) {
    const std::string path = sharedData("afm/" + GetParam().file).string();
    try {
        (void)readHeightMapFile(path);
        FAIL() << "it was read";
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith(path + ": " + GetParam().location + ": "));
        EXPECT_THAT(error.what(), testing::HasSubstr(GetParam().reason));
    }
}

INSTANTIATE_TEST_SUITE_P(RealScans, Malformed, testing::ValuesIn(malformedScans()),
                         [](const auto& scan) { return testName(scan.param.file); });

}  // namespace
}  // namespace asperity::test
