#include "core/io/heightmap/MaskValues.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/surface/HeightMap.h"

#include <algorithm>

namespace asperity {

namespace {

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

/// Of a large image, of every so many rows.
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

}  // namespace

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
    } catch (const InputError&) {  // told to those who read its values
    }
}

}  // namespace asperity
