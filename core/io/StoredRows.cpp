#include "core/io/StoredRows.h"

#include "core/io/ScanImage.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

namespace asperity {

namespace {

/// Of the largest magnitude; more than the largest number where one is not finite. By the bits,
/// whose order is that of the magnitudes: no comparison raises a flag, and none is a branch.
std::uint64_t largestMagnitudeBits(const std::vector<double>& values) {
    constexpr std::uint64_t kMagnitude = 0x7fffffffffffffffU;
    std::uint64_t largest = 0;
    for (const double value : values) {
        largest = std::max(largest, std::bit_cast<std::uint64_t>(value) & kMagnitude);
    }
    return largest;
}

/// Turns rows of values into pixels of a map.
class ScanMapWriter {
public:
    explicit ScanMapWriter(ScanMap& map) : map_(map) {}

    void writeRow(int row, const std::vector<double>& values) {
        if (!hasDatum_) {
            findDatum(values);
        }
        const std::size_t first = map_.index(row, 0);
        if (largestMagnitudeBits(values) > std::bit_cast<std::uint64_t>(kPlain)) {
            for (std::size_t i = 0; i < values.size(); ++i) {
                writePixel(first + i, values[i]);
            }
            return;
        }
        float* pixels = map_.heights.data() + first;
        for (std::size_t i = 0; i < values.size(); ++i) {
            pixels[i] = static_cast<float>(values[i] - map_.datum);
        }
    }

private:
    /// Sums of two heights up to here fit into single precision.
    static constexpr double kPlain = std::numeric_limits<float>::max() / 4.0;

    void findDatum(const std::vector<double>& values) {
        for (const double value : values) {
            if (isFiniteHeight(value) && std::abs(value) <= kPlain) {
                map_.datum = value;
                hasDatum_ = true;
                return;
            }
        }
    }

    /// A height beyond single precision becomes the largest there is: no surface is made of it.
    void writePixel(std::size_t pixel, double value) {
        if (!isFiniteHeight(value)) {
            if (map_.invalid.empty()) {
                map_.invalid.resize(map_.heights.size(), 0);
            }
            map_.invalid[pixel] = 1;
            map_.heights[pixel] = std::numeric_limits<float>::quiet_NaN();
            return;
        }
        constexpr double kLargest = std::numeric_limits<float>::max();
        map_.heights[pixel] =
            static_cast<float>(std::clamp(value - map_.datum, -kLargest, kLargest));
    }

    ScanMap& map_;
    bool hasDatum_ = false;
};

}  // namespace

void readHeights(const StoredChannel& stored, HeightMap& map) {
    map.heights.resize(map.index(map.rows, 0));
    for (int row = 0; row < map.rows; ++row) {
        stored.readRow(row, map.heights.data() + map.index(row, 0));
    }
    invalidateNonFinite(map);
}

ScanMap readScanMap(const StoredChannel& stored, const MappedFile& file, Progress* progress) {
    const HeightMap& empty = stored.channel.map;
    ScanMap map;
    map.columns = empty.columns;
    map.rows = empty.rows;
    map.pitchX = empty.pitchX;
    map.pitchY = empty.pitchY;
    map.heights.resize(map.index(map.rows, 0));
    ScanMapWriter writer(map);
    std::vector<double> values(static_cast<std::size_t>(map.columns));
    const int rowsPerStep = std::max(map.rows / 32, 1);
    for (int row = 0; row < map.rows; ++row) {
        if (row % rowsPerStep == 0) {
            file.forget();
            reportTo(progress, static_cast<double>(row) / map.rows);
        }
        stored.readRow(row, values.data());
        writer.writeRow(row, values);
    }
    return map;
}

}  // namespace asperity
