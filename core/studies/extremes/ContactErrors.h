#pragma once

#include "core/contact/maugis/MaugisUnits.h"
#include "core/studies/extremes/ContactStops.h"
#include "core/studies/extremes/ExtremesRegion.h"

#include <cstddef>

namespace asperity {

/// How far one state is from another, relative to the larger of both and `units`.
[[nodiscard]] StateErrors stateErrors(const ContactState& state, const ContactState& reference,
                                      const MaugisUnits& units) noexcept;

/// How far the state of a course at one stop is from another course's. Where one has jumped and the
/// other has not, their forces say nothing of how far off the law is: then the places of the two
/// jumps are compared, relative to the farther one.
[[nodiscard]] StateErrors contactErrors(const ContactCourse& course, const ContactCourse& other,
                                        const std::vector<ContactStop>& stops, std::size_t index,
                                        const MaugisUnits& units) noexcept;

}  // namespace asperity
