#include "core/Error.h"
#include "core/io/curves/CurveSegments.h"
#include "core/io/curves/ForceCurveFile.h"
#include "tests/core/io/curves/CurveFiles.h"
#include "tests/core/io/heightmap/InstrumentFiles.h"
#include "tests/core/io/heightmap/ZipFiles.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

// Small files of each format, cut at each byte and with each bit flipped: they are read as a curve
// of finite samples, or refused, nothing else.

namespace asperity::test {

namespace {

std::vector<std::string> smallCurveFiles() {
    IgorWaveText wave;
    wave.counts = {6, 3, 0, 0};
    wave.columnLabels = {"", "Raw", "Defl", "ZSnsr"};
    wave.note = "SpringConstant: 0.5\rIndexes: 0,3,5\rDirection: NaN,1,-1,\r";
    wave.footer = "0292 Force";
    wave.numbers = {10, 11, 12, 13, 12, 11, 0, 0, 1, 2, 1, -1, 20, 21, 22, 23, 22, 21};
    NanosurfChannel lever;
    lever.frame = "Spec forward";
    lever.name = "Deflection";
    const std::string text = "k (N/m)\t0.5\nz [nm]\tforce [nN]\n1,5\t2\n2\t3\n1\t4\n0\t0\n";
    return {nanoscopeCurveFile({}), igorFile(wave), nanosurfFile({lever}), text,
            zipFile({{"a.txt", text}})};
}

/// Returns whether it was read.
bool expectCurveOrRefusal(std::string_view bytes, const std::string& what) {
    try {
        const MemoryBytes source(bytes, "damaged");
        const ForceCurveFile file(source);
        for (std::size_t i = 0; i < std::min<std::size_t>(file.count(), 3); ++i) {
            for (const CurveSegment& segment : file.curve(i).segments) {
                const std::size_t points = loadOf(segment).size();
                EXPECT_GE(points, 2U) << what;
                EXPECT_TRUE(segment.base.size() == points || segment.separation.size() == points)
                    << what;
                for (const auto array : kCurveArrays) {
                    EXPECT_TRUE((segment.*array).empty() || (segment.*array).size() == points)
                        << what;
                    EXPECT_TRUE(std::ranges::all_of(segment.*array, [](double value) {
                        return std::isfinite(value);
                    })) << what;
                }
            }
        }
        return true;
    } catch (const InputError& error) {
        EXPECT_THAT(error.what(), testing::StartsWith("damaged")) << what;
        return false;
    }
}

std::string flippedAt(std::string bytes, std::size_t offset, unsigned bit) {
    bytes[offset] = static_cast<char>(static_cast<unsigned char>(bytes[offset]) ^ (1U << bit));
    return bytes;
}

}  // namespace

TEST(DamagedCurves, AreReadOrRefusedWhicheverBitFlips) {
    for (const std::string& bytes : smallCurveFiles()) {
        EXPECT_TRUE(expectCurveOrRefusal(bytes, "whole")) << bytes.substr(0, 40);
        for (std::size_t offset = 0; offset < bytes.size(); ++offset) {
            for (unsigned bit = 0; bit < 8; ++bit) {
                (void)expectCurveOrRefusal(flippedAt(bytes, offset, bit),
                                           "bit " + std::to_string(bit) + " of byte " +
                                               std::to_string(offset));
            }
        }
    }
}

TEST(DamagedCurves, AreReadOrRefusedWhereverTheyAreCut) {
    std::vector<std::string> files = smallCurveFiles();
    files.push_back(jpkCurveFile({{{"", jpkCycle()}}, {}}));
    for (const std::string& bytes : files) {
        for (std::size_t length = 0; length < bytes.size(); ++length) {
            (void)expectCurveOrRefusal(std::string_view(bytes).substr(0, length),
                                       "cut to " + std::to_string(length));
        }
    }
}

TEST(DamagedCurves, OfJpkAreReadOrRefusedWhicheverByteFlips) {
    const std::string bytes = jpkCurveFile({{{"", jpkCycle()}}, {}});
    for (std::size_t offset = 0; offset < bytes.size(); ++offset) {
        (void)expectCurveOrRefusal(flippedAt(bytes, offset, offset % 8),
                                   "byte " + std::to_string(offset));
    }
}

}  // namespace asperity::test
