#include "core/io/FileBytes.h"
#include "core/io/curves/ForceCurveFile.h"
#include "core/io/curves/ThermalSpectrumFile.h"
#include "tests/core/io/curves/CurveFiles.h"
#include "tests/core/io/heightmap/BoundedRead.h"
#include "tests/support/ReferenceTable.h"
#include "tests/support/Sanitized.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <vector>

// Real files of force curves cut off or with a flipped bit, and archives of zeros: never a crash or
// a hang, nor more memory than their size explains. ASPERITY_DAMAGES says how many of each (10).

namespace asperity::test {

namespace {

constexpr double kMaxCurveSeconds = 2.0;
constexpr std::uint64_t kCurveMiB = std::uint64_t{1} << 20U;

/// A curve has ten times the bytes of its samples in memory, which are packed in the file.
std::uint64_t curveMemoryBound(std::uint64_t size) { return 320 * size + 64 * kCurveMiB; }

int curveDamages() {
    const char* const wanted = std::getenv("ASPERITY_DAMAGES");
    return wanted != nullptr ? std::atoi(wanted) : 10;
}

/// The first and the last curve, or the spectrum.
void readCurves(std::string_view content) {
    const MemoryBytes bytes(content, "damaged");
    if (holdsThermalSpectrum(bytes)) {
        (void)readThermalSpectrum(bytes);
        return;
    }
    const ForceCurveFile file(bytes);
    (void)file.curve(0);
    (void)file.curve(file.count() - 1);
    (void)file.position(0);
}

void expectCurveWithinBounds(const std::string& damaged, const std::string& what) {
    const std::uint64_t most = curveMemoryBound(damaged.size());
    const BoundedRead result = readBounded(damaged, most, readCurves);
    EXPECT_EQ(result.failure, "") << what;
    EXPECT_LT(result.seconds, kMaxCurveSeconds) << what;
}

/// Most damages near the ends, where headers and directories are.
std::size_t damagedOffset(std::mt19937_64& random, std::size_t size) {
    constexpr std::size_t kNear = 4096;
    const std::size_t near = random() % std::min(size, kNear);
    switch (random() % 3) {
    case 0:
        return random() % size;
    case 1:
        return size - 1 - near;
    default:
        return near;
    }
}

}  // namespace

TEST(CurveDamageBounds, HoldForCutAndFlippedFiles) {
    ASPERITY_NEEDS_SHARED_DATA();
    if (kSanitized) {
        GTEST_SKIP() << "a sanitizer takes memory of its own";
    }
    std::mt19937_64 random{20261201};
    std::size_t files = 0;
    for (const auto& entry : std::filesystem::directory_iterator(sharedData("curves/original"))) {
        const std::string bytes = readFileBytes(entry.path());
        const std::string name = entry.path().filename().string();
        for (int i = 0; i < curveDamages(); ++i) {
            const std::size_t length = damagedOffset(random, bytes.size());
            expectCurveWithinBounds(bytes.substr(0, length),
                                    name + " cut to " + std::to_string(length));
            const std::size_t flipped = damagedOffset(random, bytes.size());
            std::string damaged = bytes;
            damaged[flipped] = static_cast<char>(static_cast<unsigned char>(damaged[flipped]) ^
                                                 (1U << (random() % 8)));
            expectCurveWithinBounds(damaged,
                                    name + ", byte " + std::to_string(flipped) + " flipped");
        }
        ++files;
    }
    EXPECT_GE(files, 25U);
}

TEST(CurveDamageBounds, HoldForAnArchiveOfZeros) {
    if (kSanitized) {
        GTEST_SKIP() << "a sanitizer takes memory of its own";
    }
    JpkCurveText text;
    for (int i = 0; i < 40; ++i) {
        JpkSegmentText segment;
        segment.height.assign(450'000, 0);
        segment.deflection = segment.height;
        segment.points = "450000";
        text.curves[""].push_back(segment);
    }
    const std::string bytes = jpkCurveFile(text);
    ASSERT_LT(bytes.size(), kCurveMiB);
    expectCurveWithinBounds(bytes, "an archive of zeros");
}

}  // namespace asperity::test
