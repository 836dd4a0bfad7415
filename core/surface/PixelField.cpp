#include "core/surface/PixelField.h"

#include "core/surface/BetweenPixels.h"

#include <cmath>
#include <limits>
#include <utility>

namespace asperity {

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
    return bilinear(betweenPixels(rows_ - 0.5 - y / pitchY_, rows_),
                    betweenPixels(x / pitchX_ - 0.5, columns_),
                    [this](int row, int column) noexcept { return double{pixel(row, column)}; });
}

}  // namespace asperity
