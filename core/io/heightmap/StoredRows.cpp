#include "core/io/heightmap/StoredRows.h"

#include "core/FreshMemory.h"
#include "core/io/MemoryLimit.h"
#include "core/io/heightmap/ChannelRows.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <limits>
#include <thread>

namespace asperity {

namespace {

/// Parts in which an image is read.
constexpr int kStoredSteps = 32;

/// The first height; 0 when there is none.
double datumOf(ChannelRows& rows, const HeightMap& map, RowRoom& room) {
    std::vector<double> values(static_cast<std::size_t>(map.columns));
    for (int row = 0; row < map.rows; ++row) {
        (void)rows.read(row, room, values.data());
        const auto first =
            std::ranges::find_if(values, [](double value) { return isFiniteHeight(value); });
        if (first != values.end()) {
            return *first;
        }
    }
    return 0.0;
}

/// In single precision. No comparison raises a flag on what is no number.
float pixelOf(double value, double datum) {
    return isFiniteHeight(value) ? static_cast<float>(value - datum)
                                 : std::numeric_limits<float>::quiet_NaN();
}

/// Reads the rows of an image, some at a time: whoever is free takes the next ones. Any threads.
class SharedRows {
public:
    SharedRows(ChannelRows& rows, ScanMap& map)
        : rows_(rows), map_(map), step_(std::max(map.rows / kStoredSteps, 1)) {}

    /// @return whether there were any left
    /// @param values room for a row
    bool readNext(RowRoom& room, std::vector<double>& values) {
        const int first = next_.fetch_add(step_);
        for (int row = first; row < std::min(first + step_, map_.rows); ++row) {
            const bool mayHaveHoles = rows_.read(row, room, values.data());
            write(values, mayHaveHoles, map_.heights.data() + map_.index(row, 0));
        }
        return first < map_.rows;
    }
    /// Nobody takes another row.
    void stop() { next_ = map_.rows; }
    /// Share of the rows that somebody has begun with.
    [[nodiscard]] double begun() const {
        return static_cast<double>(std::min<int>(next_, map_.rows)) / map_.rows;
    }

private:
    void write(const std::vector<double>& values, bool mayHaveHoles, float* pixels) const {
        if (mayHaveHoles) {
            std::ranges::transform(values, pixels, [datum = map_.datum](double value) {
                return pixelOf(value, datum);
            });
            return;
        }
        for (std::size_t i = 0; i < values.size(); ++i) {
            pixels[i] = static_cast<float>(values[i] - map_.datum);
        }
    }

    ChannelRows& rows_;
    ScanMap& map_;
    int step_;
    std::atomic<int> next_ = 0;
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
void readRows(SharedRows& rows, const ScanMap& map, RowRoom& room, Progress* progress) {
    const auto columns = static_cast<std::size_t>(map.columns);
    constexpr std::size_t kWorthAThread = std::size_t{1} << 18U;
    std::exception_ptr failure;  // of the helper
    // Asked to stop and waited for at the end, when an exception flies by, too.
    std::jthread helper;
    if (map.heights.size() >= kWorthAThread) {
        helper = std::jthread([&](const std::stop_token& stop) {
            try {
                RowRoom own;
                std::vector<double> values(columns);
                while (!stop.stop_requested() && rows.readNext(own, values)) {
                }
            } catch (...) {
                failure = std::current_exception();
                rows.stop();
            }
        });
    }
    std::vector<double> values(columns);
    do {
        reportTo(progress, rows.begun());
    } while (rows.readNext(room, values));
    if (helper.joinable()) {
        helper.join();
    }
    if (failure) {
        std::rethrow_exception(failure);
    }
    reportTo(progress, 1.0);  // the helper may have read all rows after a cancellation
}

}  // namespace

HeightMap readHeightMap(const StoredChannel& stored, const ByteSource& bytes, Progress* progress) {
    HeightMap map = stored.channel.map;
    requireMemory(map.index(map.rows, 0) * sizeof(double), bytes.name(), "");
    const auto append = [&map](int row, const std::vector<double>& values) {
        if (row == 0) {  // what cannot be decoded is refused before there is room for its pixels
            map.heights.reserve(map.index(map.rows, 0));
            requestPages(map.heights.data(), map.heights.capacity() * sizeof(double));
        }
        map.heights.insert(map.heights.end(), values.begin(), values.end());
    };
    if (forEachStoredRow(stored, bytes, progress, append)) {
        invalidateNonFinite(map);
    }
    return map;
}

ScanMap readScanMap(const StoredChannel& stored, const ByteSource& bytes, Progress* progress) {
    const HeightMap& empty = stored.channel.map;
    // Twice as much again is needed for a surface that is fitted to them: docs/performance.md.
    requireMemory(empty.index(empty.rows, 0) * 3 * sizeof(float), bytes.name(), "");
    ScanMap map;
    map.columns = empty.columns;
    map.rows = empty.rows;
    map.pitchX = empty.pitchX;
    map.pitchY = empty.pitchY;
    ChannelRows rows(stored, bytes);
    RowRoom room;  // for both, so that samples are decoded once
    map.datum = datumOf(rows, empty, room);
    map.heights.resize(map.index(map.rows, 0));
    SharedRows shared(rows, map);
    readRows(shared, map, room, progress);
    rows.finish();
    if (rows.mayHaveHoles()) {
        markInvalid(map);
    }
    return map;
}

}  // namespace asperity
