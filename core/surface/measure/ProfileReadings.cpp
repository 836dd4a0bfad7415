#include "core/surface/measure/ProfileReadings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace asperity {

double heightAt(const Profile& profile, double distance) {
    constexpr double kNoData = std::numeric_limits<double>::quiet_NaN();
    const double length = profile.length();
    if (!(distance >= 0.0 && distance <= length)) {
        return kNoData;
    }
    const auto last = profile.heights.size() - 1;
    const double place = distance / length * static_cast<double>(last);
    const auto before = std::min(static_cast<std::size_t>(place), last - 1);
    const double share = place - static_cast<double>(before);
    if (share == 0.0) {
        return profile.heights[before];
    }
    if (share == 1.0) {
        return profile.heights[before + 1];
    }
    return (1.0 - share) * profile.heights[before] + share * profile.heights[before + 1];
}

std::optional<PointReading> readingBetween(const Profile& profile, double first, double second) {
    const auto [from, to] = std::minmax(first, second);
    const double rise = heightAt(profile, to) - heightAt(profile, from);
    if (!isFiniteHeight(rise) || !(to > from)) {
        return std::nullopt;
    }
    return PointReading{.distance = to - from, .rise = rise, .angle = std::atan2(rise, to - from)};
}

std::optional<double> fittedAngle(const Profile& profile, const Interval& stretch) {
    double count = 0.0;
    double meanDistance = 0.0;
    double meanHeight = 0.0;
    double square = 0.0;
    double product = 0.0;
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        const double distance = profile.distance(i);
        if (!stretch.contains(distance) || !isFiniteHeight(profile.heights[i])) {
            continue;
        }
        // Running means: an offset of the heights costs no digits.
        count += 1.0;
        const double step = distance - meanDistance;
        meanDistance += step / count;
        meanHeight += (profile.heights[i] - meanHeight) / count;
        square += step * (distance - meanDistance);
        product += step * (profile.heights[i] - meanHeight);
    }
    if (!(square > 0.0)) {
        return std::nullopt;
    }
    return std::atan(product / square);
}

}  // namespace asperity
