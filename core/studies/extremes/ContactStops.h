#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/studies/extremes/ContactSetting.h"

#include <vector>

namespace asperity {

/// One place of the undeflected tip on its approach or retraction.
struct ContactStop {
    double approach = 0.0;  ///< [m]
    bool retract = false;
};

/// From beyond both jumps of the reference to three tip radii of indentation and back; inwards of
/// the first touch the lever's base is moved as far as Hertz' force bends the lever.
/// @param places one way, >= 4
[[nodiscard]] std::vector<ContactStop> contactStops(const ContactModel& reference,
                                                    const ContactSetting& setting, int places);

/// The states of a law at all stops.
struct ContactCourse {
    std::vector<ContactState> states;  ///< each with the memory of the one before, as in a run
    double jumpIn = 0.0;               ///< approach of the undeflected tip [m]
    double pullOff = 0.0;              ///< likewise [m]
};

[[nodiscard]] ContactCourse contactCourse(const ContactModel& model,
                                          const std::vector<ContactStop>& stops, double compliance);

}  // namespace asperity
