#pragma once

#include "core/surface/measure/Profile.h"

#include <optional>

namespace asperity {

/// A stretch of a profile, by distances from its start [m].
struct Interval {
    double from = 0.0;
    double to = 0.0;

    [[nodiscard]] bool contains(double distance) const {
        return distance >= std::min(from, to) && distance <= std::max(from, to);
    }
};

/// What lies between two points of a profile.
struct PointReading {
    double distance = 0.0;  ///< along the line, seen from above [m]
    double rise = 0.0;      ///< of the second point over the first [m]
    double angle = 0.0;     ///< of the straight line through both, up along the profile [rad]
};

/// Height at a distance, linear between the samples; NaN outside the profile or beside a sample
/// without data [m].
[[nodiscard]] double heightAt(const Profile& profile, double distance);

/// Between the points at two distances, in the order in which they lie along the profile; none
/// where a height is missing or both are the same.
[[nodiscard]] std::optional<PointReading> readingBetween(const Profile& profile, double first,
                                                         double second);

/// Angle of the least-squares line through the samples of a stretch, up along the profile [rad];
/// none where fewer than two of them hold data.
[[nodiscard]] std::optional<double> fittedAngle(const Profile& profile, const Interval& stretch);

}  // namespace asperity
