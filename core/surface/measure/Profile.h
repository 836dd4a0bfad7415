#pragma once

#include "core/Error.h"
#include "core/Vector.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/HeightMap.h"

#include <cstddef>
#include <vector>

namespace asperity {

/// Heights along a straight line between two places, world frame.
struct Profile {
    Vector2 from = Vector2::Zero();  ///< [m]
    Vector2 to = Vector2::Zero();    ///< [m]
    std::vector<double> heights;     ///< at even distances, both ends included [m]; NaN: no data

    [[nodiscard]] double length() const { return (to - from).norm(); }  ///< [m]
    /// Of a sample from the start, along the line [m].
    [[nodiscard]] double distance(std::size_t sample) const {
        return length() * static_cast<double>(sample) / static_cast<double>(heights.size() - 1);
    }
    /// Place of a sample [m].
    [[nodiscard]] Vector2 place(std::size_t sample) const {
        const double share = static_cast<double>(sample) / static_cast<double>(heights.size() - 1);
        return (1.0 - share) * from + share * to;
    }
};

/// @throw Error when there are fewer than two samples, or both places are one, or not finite
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
        const Vector2 place = profile.place(i);
        profile.heights[i] = heightAt(place.x(), place.y());
    }
    return profile;
}

/// Of a surface; NaN outside the scan and where it held no data. @throw Error as requireLine()
[[nodiscard]] Profile profileOf(const BSplineSurface& surface, const Vector2& from,
                                const Vector2& to, int samples);

/// The height of a map at a place, bilinear between pixel centers and level beyond the outermost
/// ones: NaN outside the scan, and where one of the pixels used holds no data [m].
[[nodiscard]] double bilinearHeight(const HeightMap& map, double x, double y);

/// The number of samples that leaves out no pixel: one a pitch along the line, and both ends.
[[nodiscard]] int usualSamples(double pitchX, double pitchY, const Vector2& from,
                               const Vector2& to);

}  // namespace asperity
