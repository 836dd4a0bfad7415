#include "core/surface/RegionField.h"

#include "core/Error.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace asperity {

namespace {

/// Which of `count` entries a share of their whole lies in.
std::size_t entryAt(double share, int count) noexcept {
    return static_cast<std::size_t>(std::clamp(static_cast<int>(share * count), 0, count - 1));
}

}  // namespace

RegionField::RegionField(const Place& place, int columns, int rows, std::vector<float> values,
                         std::string unit)
    : place_(place)
    , columns_(columns)
    , rows_(rows)
    , values_(std::move(values))
    , unit_(std::move(unit)) {
    if (columns < 1 || rows < 1 || !(place.width > 0.0) || !(place.height > 0.0) ||
        values_.size() != static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows)) {
        throw Error("a field of a region needs an area and one value for each of its pixels");
    }
}

bool RegionField::covers(double x, double y) const noexcept {
    return x >= place_.left && x <= place_.left + place_.width && y >= place_.bottom &&
           y <= place_.bottom + place_.height;
}

double RegionField::at(double x, double y) const noexcept {
    if (!covers(x, y)) {
        return std::numeric_limits<double>::quiet_NaN();
    }
    const std::size_t column = entryAt((x - place_.left) / place_.width, columns_);
    const std::size_t row = entryAt(1.0 - ((y - place_.bottom) / place_.height), rows_);
    return values_[(row * static_cast<std::size_t>(columns_)) + column];
}

bool RegionField::hasGaps() const noexcept {
    return std::ranges::any_of(values_, [](float value) { return std::isnan(value); });
}

}  // namespace asperity
