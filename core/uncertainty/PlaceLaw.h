#pragma once

#include "core/probe/TipEquilibrium.h"
#include "core/uncertainty/Landmarks.h"
#include "core/uncertainty/PlaceNumbers.h"

namespace asperity {

struct Scene;

/// The contact law of one place as a function of what it depends on. The scene must outlive it.
class PlaceLaw {
public:
    /// @param state of the believed tip at the place
    /// @param force along the normal at the setpoint [N]; not above 0: there is none
    PlaceLaw(const Scene& scene, const TipState& state, double force);

    [[nodiscard]] Landmarks at(const PlaceNumbers& numbers) const;

private:
    [[nodiscard]] Relief reliefOf(const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] double radiusOf(const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] double complianceOf(const PlaceNumbers& numbers) const noexcept;

    const Scene& scene_;
    TipState state_;
    double force_;
    Relief relief_ = Relief::Zero();  ///< of the scan; of a shape nothing
};

}  // namespace asperity
