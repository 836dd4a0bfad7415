#include "core/io/heightmap/SampleRows.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/io/ByteReader.h"
#include "core/io/MemoryLimit.h"
#include "core/io/heightmap/ChannelRows.h"
#include "core/surface/HeightMap.h"

#include <atomic>
#include <exception>
#include <limits>
#include <span>
#include <thread>
#include <vector>

namespace asperity {

namespace {

template <typename Number>
void convert(const char* stored, ByteOrder order, std::span<double> numbers) {
    for (double& number : numbers) {
        number = static_cast<double>(order == ByteOrder::Little ? littleEndian<Number>(stored)
                                                                : bigEndian<Number>(stored));
        stored += sizeof(Number);
    }
}

void readSamples(const ByteSource& bytes, const SampleLayout& layout, int row, RowRoom& room,
                 double* numbers) {
    const int stored = layout.bottomFirst ? layout.size.rows - 1 - row : row;
    room.bytes.resize(layout.rowBytes());
    bytes.read(layout.offset + static_cast<std::uint64_t>(stored) * layout.rowBytes(), room.bytes);
    const std::span<double> whole(numbers, static_cast<std::size_t>(layout.size.columns));
    convertSamples(layout.type, layout.order, room.bytes.data(), whole);
    if (layout.rightFirst) {
        std::ranges::reverse(whole);
    }
}

/// Counts of values that are 0, the maximum, or between them.
class EndCounts {
public:
    void add(double value) {
        ++total_;
        if (value == 0.0) {
            ++zeros_;
        } else if (value == highest_) {
            ++highs_;
        } else if (value > highest_) {
            highest_ = value;
            highs_ = 1;
        }
        isNegative_ = isNegative_ || value < 0.0;
    }

    /// Shares have smooth borders, so that some of them lie between; but as a mask marks areas,
    /// more than a few are 1.
    [[nodiscard]] bool isMask() const {
        constexpr double kMinAtEnds = 0.5;
        constexpr double kMinOfOnes = 0.01;
        constexpr double kFullByte = 255.0;
        constexpr double kFullWord = 65535.0;
        if (isNegative_ || zeros_ == 0) {
            return false;
        }
        if (highest_ == 1.0) {
            return atEnds() >= kMinAtEnds && shareOf(highs_) >= kMinOfOnes;
        }
        return (highest_ == kFullByte || highest_ == kFullWord) && zeros_ + highs_ == total_;
    }
    [[nodiscard]] double highest() const { return highest_; }
    /// Share of the values that are 0 or the highest one.
    [[nodiscard]] double atEnds() const { return shareOf(zeros_ + highs_); }

private:
    [[nodiscard]] double shareOf(std::size_t count) const {
        return static_cast<double>(count) / static_cast<double>(total_);
    }

    double highest_ = 0.0;
    std::size_t total_ = 0;
    std::size_t zeros_ = 0;
    std::size_t highs_ = 0;
    bool isNegative_ = false;
};

/// Counts the ends; in a large image, those of some rows only.
EndCounts endCounts(const StoredChannel& stored) {
    constexpr std::size_t kMaxPixels = std::size_t{1} << 20U;
    const HeightMap& map = stored.channel.map;
    const int step = static_cast<int>(map.index(map.rows, 0) / kMaxPixels) + 1;
    EndCounts counts;
    RowRoom room;
    std::vector<double> values(static_cast<std::size_t>(map.columns));
    for (int row = 0; row < map.rows; row += step) {
        stored.readRow(row, room, values.data());
        for (const double value : values) {
            if (isFiniteHeight(value)) {
                counts.add(stored.factor * value);
            }
        }
    }
    return counts;
}

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

/// Reads the rows of an image, some at a time: a free thread takes the next ones. Any threads.
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

void convertSamples(SampleType type, ByteOrder order, const char* stored,
                    std::span<double> numbers) {
    switch (type) {
    case SampleType::Int8:
        return convert<std::int8_t>(stored, order, numbers);
    case SampleType::UInt8:
        return convert<std::uint8_t>(stored, order, numbers);
    case SampleType::Int16:
        return convert<std::int16_t>(stored, order, numbers);
    case SampleType::UInt16:
        return convert<std::uint16_t>(stored, order, numbers);
    case SampleType::Int32:
        return convert<std::int32_t>(stored, order, numbers);
    case SampleType::UInt32:
        return convert<std::uint32_t>(stored, order, numbers);
    case SampleType::Int64:
        return convert<std::int64_t>(stored, order, numbers);
    case SampleType::UInt64:
        return convert<std::uint64_t>(stored, order, numbers);
    case SampleType::Float32:
        return convert<float>(stored, order, numbers);
    case SampleType::Float64:
        return convert<double>(stored, order, numbers);
    }
}

std::size_t sizeOf(SampleType type) {
    switch (type) {
    case SampleType::Int8:
    case SampleType::UInt8:
        return 1;
    case SampleType::Int16:
    case SampleType::UInt16:
        return 2;
    case SampleType::Int32:
    case SampleType::UInt32:
    case SampleType::Float32:
        return 4;
    case SampleType::Int64:
    case SampleType::UInt64:
    case SampleType::Float64:
        return 8;
    }
    return 0;
}

void requireSamples(const ByteSource& bytes, const SampleLayout& layout, const std::string& owner) {
    if (layout.offset > bytes.size() || layout.bytes() > bytes.size() - layout.offset) {
        throw InputError(bytes.name(), owner,
                         "its data end at byte " + std::to_string(layout.offset + layout.bytes()) +
                             ", but the file has " + std::to_string(bytes.size()) +
                             "; it is truncated");
    }
}

ReadRow rowsOf(const ByteSource& bytes, const SampleLayout& layout) {
    return [&bytes, layout](int row, RowRoom& room, double* numbers) {
        readSamples(bytes, layout, row, room, numbers);
    };
}

std::shared_ptr<const ByteSource> DecodedSamples::bytes() {
    const std::lock_guard lock(mutex_);
    std::shared_ptr<const ByteSource> samples = samples_.lock();
    if (!samples) {
        keep(nullptr);  // they need no memory while others are decoded
        samples = std::make_shared<OwnedBytes>(decode_(), "decoded samples");
        samples_ = samples;
        keep(samples);
    }
    return samples;
}

void DecodedSamples::keep(std::shared_ptr<const ByteSource> samples) {
    if (latest_) {
        const std::lock_guard lock(latest_->mutex);
        latest_->bytes = std::move(samples);
    }
}

ReadRow rowsOfDecoded(std::function<std::string()> decode, const SampleLayout& layout,
                      const std::string& file) {
    return rowsOfDecoded(std::make_shared<DecodedSamples>(std::move(decode)), layout, file);
}

ReadRow rowsOfDecoded(std::shared_ptr<DecodedSamples> samples, const SampleLayout& layout,
                      const std::string& file) {
    requireMemory(layout.offset + layout.bytes() + layout.size.pixels() * sizeof(double), file, "");
    return [samples = std::move(samples), layout](int row, RowRoom& room, double* numbers) {
        std::shared_ptr<const ByteSource>& bytes = room.decoded[samples];
        if (!bytes) {
            bytes = samples->bytes();
        }
        readSamples(*bytes, layout, row, room, numbers);
    };
}

ReadRow rowsOfNumbers(std::deque<double> numbers, int columns) {
    return [kept = std::make_shared<const std::deque<double>>(std::move(numbers)),
            columns](int row, RowRoom&, double* target) {
        std::copy_n(kept->begin() + static_cast<std::ptrdiff_t>(row) * columns, columns, target);
    };
}

ReadRow masked(ReadRow rows, int columns, ReadRow mask) {
    return [rows = std::move(rows), columns, mask = std::move(mask)](int row, RowRoom& room,
                                                                     double* numbers) {
        rows(row, room, numbers);
        std::vector<double> marks(static_cast<std::size_t>(columns));
        mask(row, room, marks.data());
        for (std::size_t i = 0; i < marks.size(); ++i) {
            if (isMarked(marks[i])) {
                numbers[i] = std::numeric_limits<double>::quiet_NaN();
            }
        }
    };
}

ReadRow keeping(ReadRow rows, std::shared_ptr<const ByteSource> bytes) {
    return [rows = std::move(rows), bytes = std::move(bytes)](
               int row, RowRoom& room, double* numbers) { rows(row, room, numbers); };
}

void noteMask(StoredChannel& stored) {
    ScanChannel& channel = stored.channel;
    if (!channel.unit.empty()) {
        return;
    }
    try {
        const EndCounts counts = endCounts(stored);
        if (counts.isMask()) {
            channel.isMask = true;
            channel.notes.push_back(formatted("this is a mask, not heights: its values have no "
                                              "unit, and %.3g %% of them are 0 or %.0f",
                                              100.0 * counts.atEnds(), counts.highest()));
        }
    } catch (const InputError&) {  // reported to those who read its values
    }
}

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
