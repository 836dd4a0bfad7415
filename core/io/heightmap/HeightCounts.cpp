#include "core/io/heightmap/HeightCounts.h"

#include "core/io/TextValue.h"
#include "core/surface/HeightMap.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kLargest = 65535.0;

}  // namespace

HeightCounts::HeightCounts(const HeightRange& range)
    : zero_(range.lowest), full_(range.highest), marksMissing_(range.missing > 0) {
    if (marksMissing_) {
        zero_ -= (range.highest - range.lowest) / (kLargest - 1.0);
    }
}

std::uint16_t HeightCounts::countOf(double height) const {
    if (!isFiniteHeight(height)) {
        return 0;
    }
    const double share = full_ > zero_ ? (height - zero_) / (full_ - zero_) : 0.0;
    const double count = std::round(kLargest * share);
    return static_cast<std::uint16_t>(std::clamp(count, marksMissing_ ? 1.0 : 0.0, kLargest));
}

std::vector<std::pair<std::string, std::string>> HeightCounts::keys(const std::string& unit) const {
    ImageKeys keys = {
        {"Gwy::ZMin", exactText(zero_)}, {"Gwy::ZMax", exactText(full_)}, {"Gwy::ZUnit", unit}};
    if (marksMissing_) {
        keys.emplace_back(kNoDataKey, "0");
    }
    return keys;
}

}  // namespace asperity
