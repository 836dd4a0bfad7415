#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/scene/SceneDescription.h"
#include "core/uncertainty/Relief.h"

#include <optional>

namespace asperity {

/// What the landmarks of a place depend on, relative to what the scene says.
struct PlaceNumbers {
    double stiffness = 1.0;
    double force = 1.0;  ///< normal force at the setpoint per force that the signals show
    double tipRadius = 1.0;
    double modulus = 1.0;
    double workOfAdhesion = 1.0;
    double heightScale = 1.0;
    double lateralScale = 1.0;
    /// Radius of the imaging tip that is taken out of the scan, where the scene says one; 0: the
    /// scan as it was recorded.
    double imagingTip = 1.0;
    Relief relief = Relief::Zero();  ///< to be added to that of the recorded scan at the place
    Vector2 turn = Vector2::Zero();  ///< of the normal about two axes along the surface [rad]
    std::optional<double> cohesiveRange = std::nullopt;  ///< none: the scene's
};

/// Whether a law has a range h0 of its own.
[[nodiscard]] bool hasCohesiveRange(const ContactModel& model) noexcept;

/// The law of a contact with other numbers of its material; the pair's radius is taken as it is.
/// @param model law and options @param pair of the contact, as the scene says
[[nodiscard]] ContactModel withNumbers(const SceneDescription& scene, const ContactModel& model,
                                       ContactPair pair, const PlaceNumbers& numbers);

}  // namespace asperity
