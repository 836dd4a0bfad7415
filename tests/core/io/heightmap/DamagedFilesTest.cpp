#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/ReferenceTable.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>

// Real files cut off or with flipped bits: read as far as channels are whole, or refused, nothing
// else.

namespace asperity::test {

namespace {

class DamagedFile : public testing::TestWithParam<std::string> {
protected:
    void SetUp() override {
        ASPERITY_NEEDS_SHARED_DATA();
        bytes = readFileBytes(sharedData("afm/" + GetParam()));
    }

    std::string bytes;
};

/// Where a cut may hit something: the first bytes, around every structural mark, and a spread.
std::set<std::size_t> cuts(const std::string& bytes) {
    std::set<std::size_t> offsets = {0, 1, 2, 3, 4, 5, 10, 16, 17, 18, 21, 22, 100, 1000};
    for (const char* mark : {"\\*", "\\Data offset", "\x1A", "\n\\@2:Z scale", "Gwy", "xres",
                             "yres", "data", "si_unit", "unitstr", "XRes", "ZUnits", "/0", "/1"}) {
        std::size_t offset = bytes.find(mark);
        for (int count = 0; count < 20 && offset != std::string::npos; ++count) {
            offsets.insert({offset, offset + 1, offset + 4, offset + 9});
            offset = bytes.find(mark, offset + 1);
        }
    }
    const std::size_t header = bytes.find('\0');
    for (std::size_t i = 0; i < 6; ++i) {
        offsets.insert(header + i);
        offsets.insert(bytes.size() - 1 - i);
    }
    for (std::size_t i = 1; i < 200; ++i) {
        offsets.insert(bytes.size() * i / 200);
    }
    offsets.erase(offsets.lower_bound(bytes.size()), offsets.end());
    return offsets;
}

/// Part of a file that must be there. Nobody can know how many lines a matrix or points as text had
/// where nothing before them says so, nor how many digits the last number; and the trailer of an
/// SDF file is no part of its data.
std::size_t neededBytes(const std::string& file, const std::string& bytes) {
    if (file.starts_with("text/matrix-4")) {
        return bytes.rfind(' ', bytes.size() - 3) + 1;
    }
    if (file.starts_with("sdf/")) {
        return bytes.find("\n*\n", bytes.find("\n*\n") + 1) + 2;
    }
    return file.starts_with("text/") ? 0 : bytes.size();
}

void expectReadOrRefused(const std::string& bytes, const std::string& what) {
    try {
        const HeightMapFile file = readHeightMapBytes(bytes, "flipped");
        for (const ScanChannel& channel : file.channels) {
            const HeightMap& map = channel.map;
            ASSERT_EQ(map.heights.size(), map.index(map.rows, 0)) << what;
        }
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("flipped: ")) << what;
    }
}

bool haveSameCorners(const HeightMap& a, const HeightMap& b) {
    const auto same = [](double x, double y) { return x == y || (std::isnan(x) && std::isnan(y)); };
    return a.columns == b.columns && a.rows == b.rows && same(a.at(0, 0), b.at(0, 0)) &&
           same(a.at(a.rows - 1, a.columns - 1), b.at(b.rows - 1, b.columns - 1));
}

/// A truncated file is refused, or its whole channels are those that it had, and a note says so.
void expectRefusedOrWhole(std::string_view cut, const HeightMapFile& whole) {
    SCOPED_TRACE("cut to " + std::to_string(cut.size()));
    try {
        const HeightMapFile file = readHeightMapBytes(cut, "cut.scan");
        EXPECT_THAT(file.notes, testing::Contains(testing::HasSubstr("truncated")));
        const bool mayLackMask = std::ranges::any_of(file.notes, [](const std::string& note) {
            return note.find("mask") != std::string::npos;
        });
        for (const ScanChannel& channel : file.channels) {
            const bool isOne = std::ranges::any_of(whole.channels, [&](const ScanChannel& each) {
                return haveSameCorners(channel.map, each.map);
            });
            EXPECT_TRUE(isOne || mayLackMask) << channel.name;
        }
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("cut.scan: "));
    }
}

/// One of each format, without anything that may be missing at the end.
std::vector<std::string> smallFiles() {
    return {nanoscopeFile({}),  gwyFile(gwyComponent("/0/data", smallGwyField())),
            igorFile({}),       nanonisFile({}),
            nanosurfFile({{}}), picoviewFile({}, SampleType::Int32),
            wsxmFile({}),       digitalSurfFile({})};
}

TEST_P(DamagedFile, EveryTruncationIsRefusedByNameOrLeavesWholeChannels) {
    const HeightMapFile whole = readHeightMapBytes(bytes, "whole.scan");
    const std::size_t needed = neededBytes(GetParam(), bytes);
    for (const std::size_t length : cuts(bytes)) {
        if (length >= needed) {
            expectReadOrRefused(bytes.substr(0, length), "cut to " + std::to_string(length));
            continue;
        }
        expectRefusedOrWhole(std::string_view(bytes).substr(0, length), whole);
    }
}

TEST_P(DamagedFile, FlippedBitsAreReadOrRefused) {
    std::mt19937_64 random(20240229);
    const std::size_t header = std::min<std::size_t>(bytes.size(), 48000);
    for (int flip = 0; flip < 400; ++flip) {
        std::string damaged = bytes;
        // Most flips into the header: in the samples they only change a height.
        const std::size_t reach = flip % 4 == 0 ? bytes.size() : header;
        const std::size_t offset = random() % reach;
        const auto bit = static_cast<unsigned char>(1U << (random() % 8));
        damaged[offset] = static_cast<char>(static_cast<unsigned char>(damaged[offset]) ^ bit);
        expectReadOrRefused(damaged,
                            "flip " + std::to_string(flip) + " at byte " + std::to_string(offset));
    }
}

INSTANTIATE_TEST_SUITE_P(RealScans, DamagedFile, testing::ValuesIn(realScans()),
                         [](const auto& scan) { return testName(scan.param); });

TEST(DamagedFile, EveryBitOfSmallFilesMayFlip) {
    for (const std::string& bytes : smallFiles()) {
        for (std::size_t offset = 0; offset < bytes.size(); ++offset) {
            for (unsigned bit = 0; bit < 8; ++bit) {
                std::string damaged = bytes;
                damaged[offset] =
                    static_cast<char>(static_cast<unsigned char>(damaged[offset]) ^ (1U << bit));
                expectReadOrRefused(damaged, "byte " + std::to_string(offset));
            }
        }
    }
}

TEST(DamagedFile, EveryTruncationOfSmallFilesIsRefusedOrLeavesWholeChannels) {
    for (const std::string& bytes : smallFiles()) {
        const HeightMapFile whole = readHeightMapBytes(bytes, "whole");
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            expectRefusedOrWhole(std::string_view(bytes).substr(0, length), whole);
        }
    }
}

}  // namespace
}  // namespace asperity::test
