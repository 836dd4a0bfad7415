#pragma once

#include "core/EnumTable.h"
#include "core/surface/HeightMap.h"

#include <cstdint>

namespace asperity {

enum class Leveling : std::uint8_t {
    None,
    Plane,  ///< least-squares plane removed
    Rows,   ///< median of each row removed, then the mean of all
};

template <>
inline constexpr auto kEnumTable<Leveling> = std::to_array<EnumRow<Leveling>>(
    {{Leveling::Plane, "plane"}, {Leveling::Rows, "rows"}, {Leveling::None, "none"}});

/// The least-squares plane through the valid pixels of a map.
struct PlaneFit {
    double slopeX = 0.0;   ///< along world x
    double slopeY = 0.0;   ///< along world y (up in the image)
    double mean = 0.0;     ///< of the valid heights [m]
    double centerX = 0.0;  ///< where the plane's height is `mean`: the valid pixels' center [m]
    double centerY = 0.0;  ///< [m]

    [[nodiscard]] double at(double x, double y) const {
        return mean + slopeX * (x - centerX) + slopeY * (y - centerY);
    }
};

/// Where the valid pixels do not span a plane (one line of them), it is level across that line.
/// @throw Error when the map is unusable or no pixel is valid
[[nodiscard]] PlaneFit fitPlane(const HeightMap& map);
[[nodiscard]] PlaneFit fitPlane(const ScanMap& map);

/// The map after leveling; invalid pixels take no part in it and stay what they are. A ScanMap's
/// datum is 0 after its plane or rows were removed.
/// @throw Error when the map is unusable or no pixel is valid
[[nodiscard]] HeightMap leveled(HeightMap map, Leveling leveling);
[[nodiscard]] ScanMap leveled(ScanMap map, Leveling leveling);

}  // namespace asperity
