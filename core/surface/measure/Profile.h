#pragma once

#include "core/Error.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace asperity {

/// Heights along a straight line between two positions, world frame.
struct Profile {
    Vector2 from = Vector2::Zero();  ///< [m]
    Vector2 to = Vector2::Zero();    ///< [m]
    std::vector<double> heights;     ///< at even distances, both ends included [m]; NaN: no data

    [[nodiscard]] double length() const { return (to - from).norm(); }  ///< [m]
    /// Distance of a sample from the start, along the line [m].
    [[nodiscard]] double distance(std::size_t sample) const {
        return length() * static_cast<double>(sample) / static_cast<double>(heights.size() - 1);
    }
    /// Position of a sample [m].
    [[nodiscard]] Vector2 position(std::size_t sample) const {
        const double share = static_cast<double>(sample) / static_cast<double>(heights.size() - 1);
        return (1.0 - share) * from + share * to;
    }
};

/// @throw Error when there are fewer than two samples, or both positions are one, or not finite
void requireLine(const Vector2& from, const Vector2& to, int samples);

/// The profile of heightAt(x, y) [m].
/// @throw Error as requireLine()
template <class HeightAt>
[[nodiscard]] Profile profileOf(const HeightAt& heightAt, const Vector2& from, const Vector2& to,
                                int samples) {
    requireLine(from, to, samples);
    Profile profile{
        .from = from, .to = to, .heights = std::vector<double>(static_cast<std::size_t>(samples))};
    for (std::size_t i = 0; i < profile.heights.size(); ++i) {
        const Vector2 position = profile.position(i);
        profile.heights[i] = heightAt(position.x(), position.y());
    }
    return profile;
}

/// Heights at any position of a scan, world frame.
struct HeightField {
    double pitchX = 0.0;  ///< pixel width [m]
    double pitchY = 0.0;  ///< pixel height [m]
    /// Returns the height at a position; NaN outside the scan and where it held no data [m].
    std::function<double(double x, double y)> at;
};

/// Heights of a surface, which must outlive them.
[[nodiscard]] HeightField fieldOf(const BSplineSurface& surface);

/// Heights of a map, which must outlive them, bilinear between pixel centers and level beyond the
/// outermost ones; NaN too where one of the pixels used holds no data.
[[nodiscard]] HeightField bilinearField(const HeightMap& map);
[[nodiscard]] HeightField bilinearField(const ScanMap& map);
/// The same between the heights of a surface at its pixel centers.
[[nodiscard]] HeightField bilinearField(const BSplineSurface& surface);

/// The number of samples that leaves out no pixel: one a pitch along the line, and both ends.
[[nodiscard]] int usualSamples(double pitchX, double pitchY, const Vector2& from,
                               const Vector2& to);

/// A stretch of a profile, by distances from its start [m].
struct Interval {
    double from = 0.0;
    double to = 0.0;

    [[nodiscard]] bool contains(double distance) const {
        return distance >= std::min(from, to) && distance <= std::max(from, to);
    }
};

/// Reading between two points of a profile.
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

/// Height of one level of a profile above another.
struct StepHeight {
    double height = 0.0;  ///< [m]
    /// Standard deviation of the heights about the two levels [m].
    double deviation = 0.0;
    std::size_t samples = 0;   ///< of both levels
    std::size_t plateaus = 0;  ///< stretches that the levels are made of
};

/// Mean height of the samples of one stretch above that of another; the deviation is the root of
/// the sum of both variances. None where a stretch has no sample with data.
[[nodiscard]] std::optional<StepHeight> stepHeight(const Profile& profile, const Interval& low,
                                                   const Interval& high);

/// Depth of a whole grating, by the rule of ISO 5436-1 on all its plateaus at once.
///
/// The heights are split in two where the variance between both parts is largest (Otsu). Of each
/// run of samples of one part, but for those cut off by the ends, the middle third is taken, and
/// through all of them go two parallel lines by least squares: z = a + b x +- h / 2. The height is
/// h, so that a tilt that is left does not count. The deviation is that of the residuals.
/// None where there are not at least one ridge and one groove with three samples each.
[[nodiscard]] std::optional<StepHeight> gratingHeight(const Profile& profile);

}  // namespace asperity
