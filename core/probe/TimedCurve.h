#pragma once

#include "core/contact/laws/ForceCurve.h"
#include "core/probe/TimedContact.h"

#include <optional>

namespace asperity {

/// Motion of the base for a curve that depends on time: to the deepest place of the plan and back.
struct TimedCurvePlan {
    ForceCurvePlan way;
    double speed = 0.0;              ///< of the base, > 0 [m/s]
    std::optional<double> setpoint;  ///< force that ends the approach before that [N]
};

/// The curve of a law on a lever whose base moves at a constant speed, with what relaxes and drags;
/// at both ends it turns at once. Points are equally far apart; a jump is between two of them.
/// @param model of the relaxed sample @param compliance of the lever along the normal [m/N]
[[nodiscard]] ForceCurve timedCurve(const ContactModel& model, const TimeTerms& terms,
                                    double compliance, const TimedCurvePlan& plan);

}  // namespace asperity
