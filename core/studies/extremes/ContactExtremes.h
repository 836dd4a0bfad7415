#pragma once

#include "core/ShareOut.h"
#include "core/studies/extremes/ExtremesStudy.h"

namespace asperity {

/// A flat sample.
struct FlatSample {
    double modulus = 0.0;   ///< E* [Pa]
    double adhesion = 0.0;  ///< w [J/m^2]
    Film film = {};         ///< by default a half-space
};

/// All samples of the grid.
[[nodiscard]] std::vector<FlatSample> samplesOf(const ContactGrid& grid);

/// All states of the grid on one sample.
///
/// The reference is Maugis-Dugdale on the exact sphere, which has every other law on a half-space
/// as a limit, on a film `hertz_film`. Where a flag says that the reference does not hold, and
/// before contact for `split`, whose tail it lacks, nothing is known of a law's error.
/// @throw Canceled
[[nodiscard]] ExtremesFindings contactExtremes(const ContactGrid& grid, const FlatSample& sample,
                                               const CancelCheck& check);

}  // namespace asperity
