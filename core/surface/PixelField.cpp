#include "core/surface/PixelField.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity {

namespace {

/// The pixel before a place, and the share of the way to the next one.
struct Between {
    int first;
    double part;
};

Between between(double place, int count) noexcept {
    const double inside = std::clamp(place, 0.0, count - 1.0);
    const int first = std::min(static_cast<int>(inside), std::max(count - 2, 0));
    return {first, inside - first};
}

/// A weight of zero takes nothing from a value that is no number.
double mixed(double from, double to, double part) noexcept {
    if (part == 0.0) {
        return from;
    }
    return part == 1.0 ? to : from + part * (to - from);
}

}  // namespace

template <class Heights>
PixelField::PixelField(const BasicHeightMap<Heights>& map, std::string unit)
    : columns_(map.columns)
    , rows_(map.rows)
    , pitchX_(map.pitchX)
    , pitchY_(map.pitchY)
    , unit_(std::move(unit)) {
    requireUsable(map);
    values_.reserve(map.heights.size());
    for (int row = 0; row < rows_; ++row) {
        for (int column = 0; column < columns_; ++column) {
            values_.push_back(map.isValid(row, column) ? static_cast<float>(map.at(row, column))
                                                       : std::numeric_limits<float>::quiet_NaN());
        }
    }
    for (const float value : values_) {
        lowest_ = std::fmin(lowest_, value);
        highest_ = std::fmax(highest_, value);
    }
}

template PixelField::PixelField(const BasicHeightMap<std::vector<double>>& map, std::string unit);
template PixelField::PixelField(const BasicHeightMap<PixelVector<float>>& map, std::string unit);

double PixelField::at(double x, double y) const noexcept {
    const Between across = between(x / pitchX_ - 0.5, columns_);
    const Between down = between(rows_ - 0.5 - y / pitchY_, rows_);
    const int nextColumn = std::min(across.first + 1, columns_ - 1);
    const int nextRow = std::min(down.first + 1, rows_ - 1);
    return mixed(mixed(pixel(down.first, across.first), pixel(down.first, nextColumn), across.part),
                 mixed(pixel(nextRow, across.first), pixel(nextRow, nextColumn), across.part),
                 down.part);
}

}  // namespace asperity
