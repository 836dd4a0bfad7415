#include "core/io/heightmap/nexus/NexusReader.h"

#include "core/io/heightmap/SampleRows.h"
#include "tests/core/io/hdf5/ContentText.h"
#include "tests/support/Refusal.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

// Cases that nexus_scans.py, which writes whole files, does not reach.

namespace asperity::test {
namespace {

using testing::HasSubstr;

void addText(ContentText& content, char record, const std::string& path, const std::string& text) {
    content.start(record, path)
        .values(Hdf5Type::Text, static_cast<std::uint32_t>(text.size()), {}, true)
        .add(text);
}

/// A scan of 2 x 3 pixels. @param withSignal whether its values are in the file
ContentText scan(bool withSignal) {
    ContentText content;
    content.start(hdf5_content::kGroup, "/");
    content.start(hdf5_content::kGroup, "/entry");
    addText(content, hdf5_content::kDataset, "/entry/definition", "NXafm");
    content.start(hdf5_content::kGroup, "/entry/z");
    addText(content, hdf5_content::kAttribute, "/entry/z@NX_class", "NXdata");
    addText(content, hdf5_content::kAttribute, "/entry/z@signal", "height");
    if (withSignal) {
        content.start(hdf5_content::kDataset, "/entry/z/height")
            .values(Hdf5Type::Signed, 1, {3, 2}, true)
            .add(std::string_view("\1\2\3\4\5\6", 6));
        addText(content, hdf5_content::kAttribute, "/entry/z/height@units", "Nanometers");
    }
    return content;
}

StoredScan readContent(const ContentText& content) {
    const auto bytes = std::make_shared<OwnedBytes>(content.ended(), "content");
    return readNexus("scan.nxs", [bytes](const std::vector<std::string>&) {
        return Hdf5Content(bytes, "scan.nxs");
    });
}

TEST(NexusReader, ReadsItsSignalFromTheBottom) {
    const StoredScan read = readContent(scan(true));
    ASSERT_EQ(read.channels.size(), 1U);
    EXPECT_EQ(read.channels[0].channel.unit, "m");
    const HeightMap map = readHeightMap(read.channels[0], OwnedBytes("", "scan.nxs"));
    EXPECT_DOUBLE_EQ(map.at(0, 1), 6e-9);
    EXPECT_DOUBLE_EQ(map.at(2, 0), 1e-9);
}

TEST(NexusReader, SaysThatItsSignalIsNotInTheFile) {
    EXPECT_THAT(refusalOf([] { (void)readContent(scan(false)); }),
                HasSubstr("the signal of its NXdata /entry/z is not in this file; a link to "
                          "another file is not followed"));
}

}  // namespace
}  // namespace asperity::test
