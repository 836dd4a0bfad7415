#pragma once

#include "core/EnumTable.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

enum class CurveSegmentKind : std::uint8_t { Approach, Pause, Retract };

template <>
inline constexpr auto kEnumTable<CurveSegmentKind> =
    std::to_array<EnumRow<CurveSegmentKind>>({{CurveSegmentKind::Approach, "approach"},
                                              {CurveSegmentKind::Pause, "pause"},
                                              {CurveSegmentKind::Retract, "retract"}});

/// One segment of a measured curve, in the order of time, as it was stored: no baseline is taken
/// off. Arrays are as long as `force`, or empty.
struct CurveSegment {
    CurveSegmentKind kind = CurveSegmentKind::Approach;
    std::vector<double> base;        ///< of the lever, growing towards the sample, any zero [m]
    std::vector<double> separation;  ///< of tip and sample, growing away from it, any zero [m]
    std::vector<double> deflection;  ///< of the lever, > 0: pushed up [m]
    std::vector<double> force;       ///< on the tip, > 0: repulsive [N]
};

/// A force-distance curve as an instrument measured it; each segment has a base or a separation.
struct MeasuredForceCurve {
    std::vector<CurveSegment> segments;
    double stiffness = 0.0;  ///< of the lever [N/m]; 0: the file does not say it
};

}  // namespace asperity
