#pragma once

#include "core/map/MapInstrument.h"

#include <utility>

namespace asperity {

/// The least z of a normal that says how far to go along z.
inline constexpr double kMinNormalZ = 0.1;

/// The tip where the base stands at one height.
struct TipAtHeight {
    double base = 0.0;  ///< height of the base [m]
    TipState state;
    EquilibriumMemory memory;  ///< for the next equilibrium

    /// Force along z [N].
    [[nodiscard]] double force() const noexcept { return state.force.z(); }
    /// Whether any contact point has snapped in.
    [[nodiscard]] bool isBonded() const noexcept;
};

/// The heights of the base above one place of the scan. The same heights from the same memory give
/// the same states, whatever was asked before.
class VerticalPath {
public:
    /// Fast enough that friction has its full direction, see kRestSpeed [m/s].
    static constexpr double kSpeed = 1e-6;

    /// @param place world x, y [m]
    VerticalPath(const MapInstrument& instrument, Vector2 place)
        : instrument_(instrument), place_(std::move(place)) {}

    /// How the base moves where a state is asked for, which friction depends on [m/s].
    void setVelocity(const Vector3& velocity) noexcept { velocity_ = velocity; }
    void goDown() noexcept { velocity_ = -kSpeed * Vector3::UnitZ(); }
    void goUp() noexcept { velocity_ = kSpeed * Vector3::UnitZ(); }
    /// From now on there is no friction.
    void stop() noexcept { velocity_ = Vector3::Zero(); }

    /// The equilibrium at a height of the base [m].
    [[nodiscard]] TipAtHeight at(double base, const EquilibriumMemory& memory);

    [[nodiscard]] const MapInstrument& instrument() const noexcept { return instrument_; }
    [[nodiscard]] const Vector2& place() const noexcept { return place_; }
    /// Equilibria so far.
    [[nodiscard]] int solved() const noexcept { return solved_; }
    /// Of the lever along the normal of a state [m/N].
    [[nodiscard]] double compliance(const TipState& state) const noexcept;
    /// Of the lever along z [m/N].
    [[nodiscard]] double complianceZ() const noexcept;
    /// Height of the tip as the instrument computes it from base and force along z [m].
    [[nodiscard]] double recordedHeight(const TipAtHeight& tip) const noexcept {
        return tip.base + (complianceZ() * tip.force());
    }

private:
    const MapInstrument& instrument_;
    Vector2 place_;
    Vector3 velocity_ = Vector3::Zero();
    ClosestPointTracker tracker_;
    int solved_ = 0;
};

}  // namespace asperity
