#pragma once

#include "core/EnumTable.h"

#include <cstdint>
#include <string>
#include <vector>

namespace asperity {

enum class CurveSegmentKind : std::uint8_t { Approach, Pause, Retract, Modulation };

template <>
inline constexpr auto kEnumTable<CurveSegmentKind> =
    std::to_array<EnumRow<CurveSegmentKind>>({{CurveSegmentKind::Approach, "approach"},
                                              {CurveSegmentKind::Pause, "pause"},
                                              {CurveSegmentKind::Retract, "retract"},
                                              {CurveSegmentKind::Modulation, "modulation"}});

/// One segment of a measured curve, in the order of time, as it was stored: no baseline is taken
/// off. Arrays have one value a sample, or are empty: then the file does not say them. Finite.
struct CurveSegment {
    CurveSegmentKind kind = CurveSegmentKind::Approach;
    std::vector<double> time;        ///< from the begin of the curve [s]
    std::vector<double> base;        ///< of the lever, growing towards the sample, any zero [m]
    std::vector<double> separation;  ///< of tip and sample, growing away from it, any zero [m]
    std::vector<double> signal;      ///< of the lever, > 0: pushed up [V]
    std::vector<double> deflection;  ///< of the lever, > 0: pushed up [m]
    std::vector<double> force;       ///< on the tip, > 0: repulsive [N]
};

/// A force-distance curve as an instrument measured it; each segment has a base or a separation,
/// and a signal, a deflection or a force. A curve that lacks its calibration has no force.
struct MeasuredForceCurve {
    std::vector<CurveSegment> segments;
    double stiffness = 0.0;  ///< of the lever [N/m]; 0: the file does not say it
    double invols = 0.0;     ///< inverse optical lever sensitivity [m/V]; 0: the same
};

}  // namespace asperity
