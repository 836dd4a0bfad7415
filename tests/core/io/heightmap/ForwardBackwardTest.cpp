#include "core/io/TextValue.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/ScanFile.h"
#include "tests/core/io/heightmap/RealScans.h"
#include "tests/support/ReferenceTable.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>
#include <utility>
#include <vector>

// Forward and backward image of one scan show the same surface in the same orientation, whatever
// program wrote it: a check of left and right that no other reader is needed for.

namespace asperity::test {

namespace {

using Pair = std::pair<const ScanChannel*, const ScanChannel*>;

/// A channel's name without what says its direction: "HeightRetrace" → "height".
std::string stemOf(const ScanChannel& channel) {
    std::string stem = lowerCase(channel.name);
    for (const std::string word :
         {"(forward)", "(backward)", "forward", "backward", "retrace", "trace"}) {
        if (const std::size_t offset = stem.find(word); offset != std::string::npos) {
            stem.erase(offset, word.size());
        }
    }
    return std::string(trimmed(stem));
}

/// Images of both directions, of the topography where the file has such.
std::vector<Pair> pairsOf(const HeightMapFile& file) {
    std::vector<Pair> heights;
    std::vector<Pair> others;
    for (const ScanChannel& forward : file.channels) {
        for (const ScanChannel& backward : file.channels) {
            if (forward.direction == "forward" && backward.direction == "backward" &&
                stemOf(forward) == stemOf(backward) && forward.unit == backward.unit) {
                (isTopography(forward) ? heights : others).emplace_back(&forward, &backward);
            }
        }
    }
    return heights.empty() ? others : heights;
}

/// The values less the median of their row; what holds no data is NaN.
std::vector<double> withoutRowMedians(const HeightMap& map) {
    std::vector<double> leveled = map.heights;
    for (int row = 0; row < map.rows; ++row) {
        const auto begin = leveled.begin() + static_cast<std::ptrdiff_t>(map.index(row, 0));
        std::vector<double> valid;
        std::copy_if(begin, begin + map.columns, std::back_inserter(valid),
                     [](double value) { return std::isfinite(value); });
        if (valid.empty()) {
            continue;
        }
        const auto middle = valid.begin() + static_cast<std::ptrdiff_t>(valid.size() / 2);
        std::nth_element(valid.begin(), middle, valid.end());
        std::for_each(begin, begin + map.columns, [&](double& value) { value -= *middle; });
    }
    return leveled;
}

/// Correlation of two images of the same size, the second one mirrored or not.
double correlation(const HeightMap& a, const HeightMap& b, bool mirrored) {
    const std::vector<double> left = withoutRowMedians(a);
    const std::vector<double> right = withoutRowMedians(b);
    double n = 0.0;
    double sumA = 0.0;
    double sumB = 0.0;
    double sumAA = 0.0;
    double sumBB = 0.0;
    double sumAB = 0.0;
    for (int row = 0; row < a.rows; ++row) {
        for (int column = 0; column < a.columns; ++column) {
            const double x = left[a.index(row, column)];
            const double y = right[b.index(row, mirrored ? b.columns - 1 - column : column)];
            if (!std::isfinite(x) || !std::isfinite(y)) {
                continue;
            }
            n += 1.0;
            sumA += x;
            sumB += y;
            sumAA += x * x;
            sumBB += y * y;
            sumAB += x * y;
        }
    }
    return (sumAB - sumA * sumB / n) /
           std::sqrt((sumAA - sumA * sumA / n) * (sumBB - sumB * sumB / n));
}

}  // namespace

TEST(ForwardAndBackward, ShowTheSameSurfaceInTheSameOrientation) {
    ASPERITY_NEEDS_SHARED_DATA();
    std::set<std::string> withBoth;
    for (const std::string& name : realScans()) {
        SCOPED_TRACE(name);
        const HeightMapFile file = readHeightMapFile(sharedData("afm/" + name));
        for (const auto& [forward, backward] : pairsOf(file)) {
            ASSERT_EQ(forward->map.rows, backward->map.rows);
            ASSERT_EQ(forward->map.columns, backward->map.columns);
            const double straight = correlation(forward->map, backward->map, false);
            const double mirrored = correlation(forward->map, backward->map, true);
            EXPECT_GT(straight, 0.4) << forward->name;
            EXPECT_GT(straight, mirrored) << forward->name;
            withBoth.insert(name);
            std::cout << name << " '" << forward->name << "': " << straight << ", mirrored "
                      << mirrored << "\n";
        }
    }
    for (const char* name : {"igor/spot_1-1000nm.ibw", "nanonis/STM_nanonis_generic_4_5.sxm",
                             "nid/circles.nid", "nid/squares_holes.nid", "mi/mi-1.mi"}) {
        EXPECT_TRUE(withBoth.contains(name)) << name;
    }
}

}  // namespace asperity::test
