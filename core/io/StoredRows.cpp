#include "core/io/StoredRows.h"

#include "core/io/ScanImage.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>
#include <limits>
#include <thread>

namespace asperity {

namespace {

/// Parts in which an image is read.
constexpr int kSteps = 32;

/// Sums of two heights up to here fit into single precision.
constexpr double kPlain = std::numeric_limits<float>::max() / 4.0;

/// The first height that is plain; 0 when none is.
double datumOf(const StoredChannel& stored) {
    const HeightMap& map = stored.channel.map;
    std::vector<double> values(static_cast<std::size_t>(map.columns));
    for (int row = 0; row < map.rows; ++row) {
        stored.readRow(row, values.data());
        for (const double value : values) {
            if (isFiniteHeight(value) && std::abs(value) <= kPlain) {
                return value;
            }
        }
    }
    return 0.0;
}

/// Whether no magnitude is beyond kPlain and every value is a number. By the bits, whose order is
/// that of the magnitudes: what is larger carries into the sign's place. No comparison raises a
/// flag, and none is a branch.
bool areAllPlain(const std::vector<double>& values) {
    constexpr std::uint64_t kMagnitude = 0x7fffffffffffffffU;
    constexpr std::uint64_t kRoom = kMagnitude - std::bit_cast<std::uint64_t>(kPlain);
    std::uint64_t carried = 0;
    for (const double value : values) {
        carried |= (std::bit_cast<std::uint64_t>(value) & kMagnitude) + kRoom;
    }
    return carried <= kMagnitude;
}

/// Any value in single precision. A height beyond it becomes the largest there is: no surface is
/// made of it.
float pixelOf(double value, double datum) {
    if (!isFiniteHeight(value)) {
        return std::numeric_limits<float>::quiet_NaN();
    }
    constexpr double kLargest = std::numeric_limits<float>::max();
    return static_cast<float>(std::clamp(value - datum, -kLargest, kLargest));
}

/// Turns a row of values into pixels; those without data become NaN. Tells whether there may be
/// any.
bool writeRow(const std::vector<double>& values, double datum, float* pixels) {
    if (!areAllPlain(values)) {
        std::ranges::transform(values, pixels,
                               [datum](double value) { return pixelOf(value, datum); });
        return true;
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        pixels[i] = static_cast<float>(values[i] - datum);
    }
    return false;
}

/// Reads the rows of an image, some at a time: whoever is free takes the next ones. Any threads.
class RowReader {
public:
    RowReader(const StoredChannel& stored, ScanMap& map)
        : stored_(stored), map_(map), step_(std::max(map.rows / kSteps, 1)) {}

    /// @return whether there were any left
    /// @param values room for a row
    bool readNext(std::vector<double>& values) {
        const int first = next_.fetch_add(step_);
        for (int row = first; row < std::min(first + step_, map_.rows); ++row) {
            stored_.readRow(row, values.data());
            if (writeRow(values, map_.datum, map_.heights.data() + map_.index(row, 0))) {
                mayHaveHoles_ = true;
            }
        }
        return first < map_.rows;
    }
    /// Share of the rows that somebody has begun with.
    [[nodiscard]] double begun() const {
        return static_cast<double>(std::min<int>(next_, map_.rows)) / map_.rows;
    }

    /// Whether a pixel that was read may hold no data.
    [[nodiscard]] bool mayHaveHoles() const { return mayHaveHoles_; }

private:
    const StoredChannel& stored_;
    ScanMap& map_;
    int step_;
    std::atomic<int> next_ = 0;
    std::atomic<bool> mayHaveHoles_ = false;
};

/// Marks the pixels without data, if there are any.
void markInvalid(ScanMap& map) {
    const auto hasData = [](float height) { return isFiniteHeight(height); };
    if (std::ranges::all_of(map.heights, hasData)) {
        return;
    }
    map.invalid.resize(map.heights.size());
    for (std::size_t i = 0; i < map.heights.size(); ++i) {
        map.invalid[i] = !hasData(map.heights[i]);
    }
}

/// Reads all rows, on two threads where that is worth one.
void readRows(RowReader& reader, const ScanMap& map, const MappedFile& file, Progress* progress) {
    const auto columns = static_cast<std::size_t>(map.columns);
    constexpr std::size_t kWorthAThread = std::size_t{1} << 18U;
    // Asked to stop and waited for at the end, when Cancelled flies by, too.
    std::jthread helper;
    if (map.heights.size() >= kWorthAThread) {
        helper = std::jthread([&](const std::stop_token& stop) {
            std::vector<double> values(columns);
            while (!stop.stop_requested() && reader.readNext(values)) {
            }
        });
    }
    std::vector<double> values(columns);
    do {
        file.forget();
        reportTo(progress, reader.begun());
    } while (reader.readNext(values));
    if (helper.joinable()) {
        helper.join();
    }
    reportTo(progress, 1.0);  // the helper may have read all rows after a cancellation
}

}  // namespace

void readHeights(const StoredChannel& stored, HeightMap& map) {
    map.heights.resize(map.index(map.rows, 0));
    for (int row = 0; row < map.rows; ++row) {
        stored.readRow(row, map.heights.data() + map.index(row, 0));
    }
    invalidateNonFinite(map);
}

HeightMap readHeightMap(const StoredChannel& stored, const MappedFile& file, Progress* progress) {
    HeightMap map = stored.channel.map;
    map.heights.resize(map.index(map.rows, 0));
    const int step = std::max(map.rows / kSteps, 1);
    for (int row = 0; row < map.rows; ++row) {
        if (row % step == 0) {
            file.forget();
            reportTo(progress, static_cast<double>(row) / map.rows);
        }
        stored.readRow(row, map.heights.data() + map.index(row, 0));
    }
    invalidateNonFinite(map);
    return map;
}

ScanMap readScanMap(const StoredChannel& stored, const MappedFile& file, Progress* progress) {
    const HeightMap& empty = stored.channel.map;
    ScanMap map;
    map.columns = empty.columns;
    map.rows = empty.rows;
    map.pitchX = empty.pitchX;
    map.pitchY = empty.pitchY;
    map.heights.resize(map.index(map.rows, 0));
    map.datum = datumOf(stored);
    RowReader reader(stored, map);
    readRows(reader, map, file, progress);
    if (reader.mayHaveHoles()) {
        markInvalid(map);
    }
    return map;
}

}  // namespace asperity
