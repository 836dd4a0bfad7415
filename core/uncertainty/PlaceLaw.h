#pragma once

#include "core/scene/Scene.h"
#include "core/uncertainty/FitResponse.h"
#include "core/uncertainty/Landmarks.h"

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
    Relief relief = Relief::Zero();  ///< to be added to that of the place
    Vector2 turn = Vector2::Zero();  ///< of the normal about two axes along the surface [rad]
    std::optional<double> cohesiveRange = std::nullopt;  ///< none: the scene's
};

/// The contact law of one place as a function of what it depends on. The scene must outlive it.
class PlaceLaw {
public:
    /// @param state of the believed tip at the place
    /// @param force along the normal at the setpoint [N]; not above 0: there is none
    PlaceLaw(const Scene& scene, const TipState& state, double force);

    [[nodiscard]] Landmarks at(const PlaceNumbers& numbers) const;

    /// Whether the law has a range h0 of its own.
    [[nodiscard]] bool hasCohesiveRange() const noexcept;

private:
    [[nodiscard]] Relief reliefOf(const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] double radiusOf(const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] double complianceOf(const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] ContactModel modelOf(const PlaceNumbers& numbers) const;

    const Scene& scene_;
    TipState state_;
    double force_;
    Relief relief_ = Relief::Zero();  ///< of the scan; of a shape nothing
};

}  // namespace asperity
