#include "core/surface/leveling/ScarRemoval.h"

#include "core/ShareOut.h"
#include "core/surface/leveling/CountedPixels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <utility>

namespace asperity {

namespace {

/// Over the pixels of a row with data.
struct StepSums {
    double square = 0.0;  ///< of the steps to the row below [m^2]
    double pixels = 0.0;
};

template <class Heights>
StepSums stepsBelow(const BasicHeightMap<Heights>& map, int row) {
    StepSums sums;
    for (int column = 0; column < map.columns; ++column) {
        if (!counts(map, row, column)) {
            continue;
        }
        sums.pixels += 1.0;
        if (row + 1 < map.rows && counts(map, row + 1, column)) {
            const double step = map.at(row + 1, column) - map.at(row, column);
            sums.square += step * step;
        }
    }
    return sums;
}

/// Root mean square of the differences between pixels above each other [m].
template <class Heights>
double verticalRms(const BasicHeightMap<Heights>& map, Progress* progress) {
    StepSums all;
    for (const StepSums& one :
         ofEachRow(map.rows, progress, [&](int row) { return stepsBelow(map, row); })) {
        all.square += one.square;
        all.pixels += one.pixels;
    }
    return all.pixels > 0.0 ? std::sqrt(all.square / all.pixels) : 0.0;
}

/// Pixels of a row, from `begin` to before `end`: indices in the map.
struct Segment {
    std::ptrdiff_t begin = 0;
    std::ptrdiff_t end = 0;
};

/// Finds scars of one sign, row by row.
template <class Heights>
class ScarSearch {
public:
    /// @param sign +1: scars above their surroundings, -1: below
    /// @param rms verticalRms(), above 0 [m]
    ScarSearch(const BasicHeightMap<Heights>& map, const ScarLimits& limits, double sign,
               double rms)
        : map_(map)
        , limits_(limits)
        , sign_(sign)
        , rms_(rms)
        , strengths_(static_cast<std::size_t>(limits.maxWidth) + 1,
                     std::vector<double>(static_cast<std::size_t>(map.columns), 0.0)) {}

    /// Adds the scars in the rows from `first` to before `last`; once for each object.
    void run(int first, int last, std::vector<Segment>& scars) {
        for (int row = std::max(0, first - limits_.maxWidth);
             row + 1 < std::min(last, map_.rows - 1); ++row) {
            for (int column = 0; column < map_.columns; ++column) {
                searchBelow(row, column);
            }
            std::vector<double>& below = strengthOf(row + 1);  // no later row adds to it
            if (row + 1 >= first) {
                addSegments(below, row + 1, scars);
            }
            std::ranges::fill(below, 0.0);
        }
    }

private:
    [[nodiscard]] double height(int row, int column) const { return sign_ * map_.at(row, column); }
    std::vector<double>& strengthOf(int row) {
        return strengths_[static_cast<std::size_t>(row) % strengths_.size()];
    }

    /// The narrowest run of pixels below this one that stands out from it and from the pixel under
    /// the run.
    void searchBelow(int row, int column) {
        if (!counts(map_, row, column)) {
            return;
        }
        double top = std::numeric_limits<double>::infinity();
        for (int width = 1; width <= limits_.maxWidth; ++width) {
            const int under = row + width + 1;
            if (under >= map_.rows || !counts(map_, under - 1, column) ||
                !counts(map_, under, column)) {
                return;
            }
            top = std::min(top, height(under - 1, column));
            if (top - height(row, column) < limits_.soft * rms_) {
                return;  // a wider run stands out no more
            }
            const double bottom = std::max(height(row, column), height(under, column));
            if (top - bottom >= limits_.soft * rms_) {
                raise(row, width, column, bottom);
                return;
            }
        }
    }

    void raise(int row, int width, int column, double bottom) {
        for (int one = row + 1; one <= row + width; ++one) {
            double& strength = strengthOf(one)[static_cast<std::size_t>(column)];
            strength = std::max(strength, (height(one, column) - bottom) / rms_);
        }
    }

    /// Segments begin where a pixel stands out by the hard threshold and spread over neighbors that
    /// stand out by the soft one.
    void addSegments(std::vector<double>& strengths, int row, std::vector<Segment>& scars) const {
        for (std::size_t i = 1; i < strengths.size(); ++i) {
            spread(strengths[i - 1], strengths[i]);
        }
        for (std::size_t i = strengths.size() - 1; i > 0; --i) {
            spread(strengths[i], strengths[i - 1]);
        }
        std::size_t begin = 0;
        for (std::size_t i = 0; i <= strengths.size(); ++i) {
            if (i < strengths.size() && strengths[i] >= limits_.hard) {
                continue;
            }
            if (i - begin >= static_cast<std::size_t>(limits_.minLength)) {
                const auto start = static_cast<std::ptrdiff_t>(map_.index(row, 0));
                scars.push_back({start + static_cast<std::ptrdiff_t>(begin),
                                 start + static_cast<std::ptrdiff_t>(i)});
            }
            begin = i + 1;
        }
    }

    void spread(double from, double& to) const {
        if (from >= limits_.hard && to >= limits_.soft) {
            to = std::max(to, limits_.hard);
        }
    }

    const BasicHeightMap<Heights>& map_;
    ScarLimits limits_;
    double sign_;
    double rms_;  ///< [m]
    /// Of the rows that the search still reaches, by row number: how far each pixel stands out.
    std::vector<std::vector<double>> strengths_;
};

/// Bands of rows are searched on all cores; each searches the few rows before it again.
template <class Heights>
std::vector<std::vector<Segment>> scarSegments(const BasicHeightMap<Heights>& map,
                                               const ScarLimits& limits, double rms,
                                               Progress* progress) {
    constexpr int kRows = 64;  // of a band
    const int bands = (map.rows + kRows - 1) / kRows;
    return ofEachRow(bands, progress, [&](int band) {
        std::vector<Segment> found;
        for (const double sign : {1.0, -1.0}) {
            ScarSearch<Heights>(map, limits, sign, rms)
                .run(band * kRows, (band + 1) * kRows, found);
        }
        return found;
    });
}

/// The nearest pixel from `row` on in this direction that holds data and is no scar; -1: none.
template <class Heights>
int nextGood(const BasicHeightMap<Heights>& map, const PixelMask& scars, int row, int column,
             int direction) {
    for (; row >= 0 && row < map.rows; row += direction) {
        if (counts(map, row, column) && !scars[map.index(row, column)]) {
            return row;
        }
    }
    return -1;
}

/// There is a good pixel above and below each scar: it was found by them, or they are scars
/// themselves that end before the edge.
template <class Heights>
double interpolated(const BasicHeightMap<Heights>& map, const PixelMask& scars, int row,
                    int column) {
    const int above = nextGood(map, scars, row, column, -1);
    const int below = nextGood(map, scars, row, column, 1);
    if (above < 0 || below < 0) {
        const int only = std::max(above, below);
        return only < 0 ? map.at(row, column) : map.at(only, column);
    }
    const double share = static_cast<double>(row - above) / (below - above);
    return (1.0 - share) * map.at(above, column) + share * map.at(below, column);
}

template <class Heights>
bool holdsData(const BasicHeightMap<Heights>& map, int row) {
    for (int column = 0; column < map.columns; ++column) {
        if (counts(map, row, column)) {
            return true;
        }
    }
    return false;
}

template <class Heights>
std::vector<int> rowsWithData(const BasicHeightMap<Heights>& map) {
    std::vector<int> rows;
    for (int row = 0; row < map.rows; ++row) {
        if (holdsData(map, row)) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Median of value(column) where a row has one; 0 where it has none.
template <class Value>
double medianAlong(int columns, const Value& value) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(columns));
    for (int column = 0; column < columns; ++column) {
        if (const std::optional<double> one = value(column)) {
            values.push_back(*one);
        }
    }
    return values.empty() ? 0.0 : median(values);
}

/// Mean of the shifts of these rows, and of the rows' numbers.
struct Center {
    double row = 0.0;
    double shift = 0.0;  ///< [m]
};

Center centerOf(const RowShifts& shifts, const std::vector<int>& rows) {
    Center center;
    for (const int row : rows) {
        center.row += row;
        center.shift += shifts[static_cast<std::size_t>(row)];
    }
    const auto count = static_cast<double>(std::max<std::size_t>(rows.size(), 1));
    return {.row = center.row / count, .shift = center.shift / count};
}

void removeLine(RowShifts& shifts, const std::vector<int>& rows) {
    const Center center = centerOf(shifts, rows);
    double square = 0.0;
    double product = 0.0;
    for (const int row : rows) {
        const double position = row - center.row;
        square += position * position;
        product += position * (shifts[static_cast<std::size_t>(row)] - center.shift);
    }
    const double slope = square > 0.0 ? product / square : 0.0;
    for (std::size_t row = 0; row < shifts.size(); ++row) {
        shifts[row] -= center.shift + slope * (static_cast<double>(row) - center.row);
    }
}

}  // namespace

template <class Heights>
PixelMask scarsOf(const BasicHeightMap<Heights>& map, const ScarLimits& limits,
                  Progress* progress) {
    requireUsable(map);
    ProgressPart measuring(progress, 0.0, 0.2);
    const double rms = verticalRms(map, &measuring);
    if (!(rms > 0.0)) {
        return {};
    }
    ProgressPart searching(progress, 0.2, 1.0);
    PixelMask scars;
    for (const std::vector<Segment>& band : scarSegments(map, limits, rms, &searching)) {
        for (const Segment& segment : band) {
            scars.resize(map.heights.size(), false);
            std::fill(scars.begin() + segment.begin, scars.begin() + segment.end, true);
        }
    }
    return scars;
}

template <class Heights>
std::size_t removeScars(BasicHeightMap<Heights>& map, const ScarLimits& limits,
                        Progress* progress) {
    using Height = typename Heights::value_type;
    ProgressPart searching(progress, 0.0, 0.9);
    PixelMask scars = scarsOf(map, limits, &searching);
    if (scars.empty()) {
        return 0;
    }
    ProgressPart filling(progress, 0.9, 1.0);
    shareOut(map.rows, &filling, [&](int row, const CancelCheck& /*check*/) {
        for (int column = 0; column < map.columns; ++column) {
            const std::size_t pixel = map.index(row, column);
            if (scars[pixel]) {
                map.heights[pixel] = static_cast<Height>(interpolated(map, scars, row, column));
            }
        }
    });
    const auto removed = static_cast<std::size_t>(std::ranges::count(scars, true));
    if (!map.invalid.empty()) {
        std::transform(scars.begin(), scars.end(), map.invalid.begin(), scars.begin(),
                       std::logical_or());
    }
    map.invalid = std::move(scars);
    return removed;
}

#define ASPERITY_SCAR_REMOVAL(Heights)                                                             \
    template PixelMask scarsOf(const BasicHeightMap<Heights>&, const ScarLimits&, Progress*);      \
    template std::size_t removeScars(BasicHeightMap<Heights>&, const ScarLimits&, Progress*);
ASPERITY_SCAR_REMOVAL(std::vector<double>)
ASPERITY_SCAR_REMOVAL(PixelVector<float>)
#undef ASPERITY_SCAR_REMOVAL

template <class Heights>
RowShifts rowMedians(const BasicHeightMap<Heights>& map, Progress* progress) {
    return ofEachRow(map.rows, progress, [&](int row) {
        return medianAlong(map.columns, [&](int column) -> std::optional<double> {
            return counts(map, row, column) ? std::optional(map.at(row, column)) : std::nullopt;
        });
    });
}

template <class Heights>
RowShifts differenceShifts(const BasicHeightMap<Heights>& map, Progress* progress) {
    RowShifts shifts(static_cast<std::size_t>(map.rows), 0.0);
    const std::vector<int> rows = rowsWithData(map);
    if (rows.size() < 2) {
        return shifts;
    }
    shareOut(static_cast<int>(rows.size()) - 1, progress, [&](int i, const CancelCheck& /*check*/) {
        const int above = rows[static_cast<std::size_t>(i)];
        const int row = rows[static_cast<std::size_t>(i) + 1];
        shifts[static_cast<std::size_t>(row)] =
            medianAlong(map.columns, [&](int column) -> std::optional<double> {
                const bool both = counts(map, row, column) && counts(map, above, column);
                return both ? std::optional(map.at(row, column) - map.at(above, column))
                            : std::nullopt;
            });
    });
    for (std::size_t row = 1; row < shifts.size(); ++row) {
        shifts[row] += shifts[row - 1];
    }
    return shifts;
}

template <class Heights>
RowShifts detrendedDifferenceShifts(const BasicHeightMap<Heights>& map, Progress* progress) {
    RowShifts shifts = differenceShifts(map, progress);
    removeLine(shifts, rowsWithData(map));
    return shifts;
}

template <class Heights>
void subtractRows(BasicHeightMap<Heights>& map, const RowShifts& shifts, Progress* progress) {
    subtract(
        map, [&](int row, int) { return shifts[static_cast<std::size_t>(row)]; }, progress);
}

template <class Heights>
double spreadOf(const RowShifts& shifts, const BasicHeightMap<Heights>& map) {
    const std::vector<int> rows = rowsWithData(map);
    const double mean = centerOf(shifts, rows).shift;
    double square = 0.0;
    for (const int row : rows) {
        const double distance = shifts[static_cast<std::size_t>(row)] - mean;
        square += distance * distance;
    }
    return rows.empty() ? 0.0 : std::sqrt(square / static_cast<double>(rows.size()));
}

#define ASPERITY_ROW_ALIGNMENT(Heights)                                                            \
    template RowShifts rowMedians(const BasicHeightMap<Heights>&, Progress*);                      \
    template RowShifts differenceShifts(const BasicHeightMap<Heights>&, Progress*);                \
    template RowShifts detrendedDifferenceShifts(const BasicHeightMap<Heights>&, Progress*);       \
    template void subtractRows(BasicHeightMap<Heights>&, const RowShifts&, Progress*);             \
    template double spreadOf(const RowShifts&, const BasicHeightMap<Heights>&);
ASPERITY_ROW_ALIGNMENT(std::vector<double>)
ASPERITY_ROW_ALIGNMENT(PixelVector<float>)
#undef ASPERITY_ROW_ALIGNMENT

}  // namespace asperity
