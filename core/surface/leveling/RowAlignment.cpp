#include "core/surface/leveling/RowAlignment.h"

#include "core/ShareOut.h"
#include "core/surface/leveling/CountedPixels.h"

#include <cmath>
#include <optional>

namespace asperity {

namespace {

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

/// Of value(column) where a row has one; 0 where it has none.
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
        const double place = row - center.row;
        square += place * place;
        product += place * (shifts[static_cast<std::size_t>(row)] - center.shift);
    }
    const double slope = square > 0.0 ? product / square : 0.0;
    for (std::size_t row = 0; row < shifts.size(); ++row) {
        shifts[row] -= center.shift + slope * (static_cast<double>(row) - center.row);
    }
}

}  // namespace

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
