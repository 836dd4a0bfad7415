#pragma once

#include "core/surface/measure/ProfileReadings.h"

#include <cstddef>
#include <optional>

namespace asperity {

/// How far one level of a profile lies above another.
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
