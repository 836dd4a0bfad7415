#include "core/studies/extremes/ContactErrors.h"

namespace asperity {

StateErrors stateErrors(const ContactState& state, const ContactState& reference,
                        const MaugisUnits& units) noexcept {
    return {.force = relativeError(state.force, reference.force, units.force),
            .contactRadius =
                relativeError(state.contactRadius, reference.contactRadius, units.radius)};
}

StateErrors contactErrors(const ContactCourse& course, const ContactCourse& other,
                          const std::vector<ContactStop>& stops, std::size_t index,
                          const MaugisUnits& units) noexcept {
    const ContactState& state = course.states[index];
    const ContactState& reference = other.states[index];
    if (state.branch == reference.branch) {
        return stateErrors(state, reference, units);
    }
    return {.jump = stops[index].retract ? relativeError(course.pullOff, other.pullOff, 0.0)
                                         : relativeError(course.jumpIn, other.jumpIn, 0.0)};
}

}  // namespace asperity
