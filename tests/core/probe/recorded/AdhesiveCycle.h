#pragma once

#include "core/Random.h"
#include "core/curves/MeasuredForceCurve.h"

namespace asperity::test {

inline constexpr double kCycleDeepest = 20e-9;  ///< below the contact [m]
inline constexpr double kCycleSnapIn = 4e-9;    ///< above it [m]
inline constexpr double kCyclePullOff = 30e-9;  ///< above it [m]
inline constexpr double kCycleStiffness = 0.2;  ///< of lever and contact together [N/m]
inline constexpr double kCycleLever = 0.5;      ///< [N/m]

/// An adhesive cycle over 320 nm in steps of 0.5 nm, with an offset, noise, and a base that jitters
/// and at times repeats itself.
[[nodiscard]] inline MeasuredForceCurve adhesiveCycle() {
    constexpr double kStep = 0.5e-9;
    constexpr double kContact = 5.43e-6;  // base, as the file has it
    Random random(7);
    MeasuredForceCurve curve{
        .segments = {{.kind = CurveSegmentKind::Approach}, {.kind = CurveSegmentKind::Retract}},
        .stiffness = kCycleLever};
    const auto add = [&](CurveSegment& segment, double depth, double hold) {
        const bool holds = depth > -hold;
        const double drag = hold == kCycleSnapIn ? 20e-12 : -20e-12;
        segment.base.push_back(kContact + depth);
        segment.force.push_back((holds ? kCycleStiffness * depth : 0.0) + drag - 1e-9 +
                                5e-12 * random.normal());
    };
    for (int i = 0; i <= 640; ++i) {
        const double depth = -300e-9 + kStep * i + (i < 640 ? 0.3e-9 * random.normal() : 0.0);
        const double held = depth < kCycleDeepest ? depth : kCycleDeepest - kStep;
        add(curve.segments[0], i == 640 ? kCycleDeepest : held, kCycleSnapIn);
        if (i % 100 == 0) {
            add(curve.segments[0], i == 640 ? kCycleDeepest : held, kCycleSnapIn);
        }
    }
    for (int i = 1; i <= 640; ++i) {
        const double depth = kCycleDeepest - kStep * i + 0.3e-9 * random.normal();
        add(curve.segments[1], depth < kCycleDeepest ? depth : kCycleDeepest, kCyclePullOff);
    }
    return curve;
}

}  // namespace asperity::test
