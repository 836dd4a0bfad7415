#pragma once

#include "core/Vector.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/VirtualRun.h"
#include "core/haptics/ZFeedback.h"

#include <vector>

namespace asperity::test {

/// Ticks of lines under a z feedback.
struct HeldLine {
    std::vector<TickSample> all;                   ///< from the begin in contact on
    std::vector<TickSample> samples;               ///< of the lines alone
    FeedbackState state = FeedbackState::Holding;  ///< at the end
};

/// Runs lines from above a position (x, y) [m] at a setpoint [N]. The tip begins in contact.
[[nodiscard]] HeldLine heldLine(const Scene& scene, const Vector2& position, const LinesPlan& lines,
                                double setpoint);

}  // namespace asperity::test
