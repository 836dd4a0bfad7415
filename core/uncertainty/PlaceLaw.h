#pragma once

#include "core/probe/TipEquilibrium.h"
#include "core/uncertainty/Landmarks.h"
#include "core/uncertainty/PlaceNumbers.h"
#include "core/uncertainty/RecordedScan.h"

namespace asperity {

struct Scene;

/// The contact law of one place as a function of what it depends on. The scene must outlive it.
class PlaceLaw {
public:
    /// @param state of the believed tip at the place
    /// @param scan as it was recorded; a shape has none that counts
    /// @param places of the state in the scan
    /// @param force along the normal at the setpoint [N]; not above 0: there is none
    PlaceLaw(const Scene& scene, const TipState& state, const RecordedScan& scan,
             const RecordedPlaces& places, double force);

    /// Returns the landmarks on the surface without its imaging tip.
    [[nodiscard]] Landmarks at(const PlaceNumbers& numbers) const;
    /// Returns the landmarks on the surface that the scene shows: of a scan that is not eroded,
    /// with its imaging tip's shape.
    [[nodiscard]] Landmarks shown() const;

private:
    [[nodiscard]] double radiusOf(const Relief& relief, const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] double complianceOf(const Relief& relief,
                                      const PlaceNumbers& numbers) const noexcept;
    /// The attraction beside the contact goes as the half-space's, H R / (6 g^2).
    [[nodiscard]] BodyPull bodyWith(const PlaceNumbers& numbers) const noexcept;
    [[nodiscard]] Landmarks at(const Relief& relief, const PlaceNumbers& numbers) const;

    const Scene& scene_;
    TipState state_;
    Relief shown_;    ///< of the recorded scan
    Relief touched_;  ///< of it where the tip touches the surface without its imaging tip
    double force_;
};

}  // namespace asperity
