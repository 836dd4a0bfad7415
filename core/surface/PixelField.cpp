#include "core/surface/PixelField.h"

#include "core/Error.h"

#include <utility>

namespace asperity {

namespace {

/// Which of `count` entries a share of their whole lies in.
std::size_t entryAt(double share, int count) noexcept {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(share * count), 0, count - 1));
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
    return bilinear(betweenPixels(rows_ - 0.5 - y / pitchY_, rows_),
                    betweenPixels(x / pitchX_ - 0.5, columns_),
                    [this](int row, int column) noexcept { return double{pixel(row, column)}; });
}

RegionField::RegionField(const Area& area, int columns, int rows, std::vector<float> values,
                         std::string unit)
    : area_(area)
    , columns_(columns)
    , rows_(rows)
    , values_(std::move(values))
    , unit_(std::move(unit)) {
    if (columns < 1 || rows < 1 || !(area.width > 0.0) || !(area.height > 0.0) ||
        values_.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
        throw Error("a field of a region needs an area and one value for each of its pixels");
    }
}

bool RegionField::covers(double x, double y) const noexcept {
    return x >= area_.left && x <= area_.left + area_.width && y >= area_.bottom &&
           y <= area_.bottom + area_.height;
}

double RegionField::at(double x, double y) const noexcept {
    if (!covers(x, y)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const std::size_t column = entryAt((x - area_.left) / area_.width, columns_);
    const std::size_t row = entryAt(1.0 - ((y - area_.bottom) / area_.height), rows_);
    return values_[(row * static_cast<std::size_t>(columns_)) + column];
}

bool RegionField::hasGaps() const noexcept {
    return std::ranges::any_of(values_, [](float value) { return std::isnan(value); });
}

}  // namespace asperity
