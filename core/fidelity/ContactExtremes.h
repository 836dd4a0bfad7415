#pragma once

#include "core/fidelity/ExtremesStudy.h"

namespace asperity {

/// All states of the grid at one reduced modulus [Pa].
///
/// The reference is Maugis-Dugdale on the exact sphere, which has every other law on a half-space
/// as a limit; of `split`, whose tail it does not have, the split law solved afresh while the
/// contact is not large; on a film `hertz_film`.
[[nodiscard]] ExtremesFindings contactExtremes(const ContactGrid& grid, double modulus);

}  // namespace asperity
