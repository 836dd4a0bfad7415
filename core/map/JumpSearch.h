#pragma once

#include "core/contact/laws/ForceCurve.h"
#include "core/scene/Scene.h"
#include "core/scene/TipValidity.h"

#include <optional>
#include <utility>
#include <vector>

namespace asperity {

/// One side of a scene that a map is made of: what is believed, or what is simulated to be true.
/// The scene must outlive it.
class MapInstrument {
public:
    MapInstrument(const Scene& scene, bool truth)
        : scene_(scene)
        , truth_(truth)
        , surface_(truth ? scene.trueSurface() : scene.believedSurface()) {}

    [[nodiscard]] const Scene& scene() const noexcept { return scene_; }
    [[nodiscard]] const SampleSurface& surface() const noexcept { return surface_; }
    [[nodiscard]] const ProbeSystem& system() const noexcept {
        return truth_ ? scene_.truth : scene_.belief;
    }
    /// Returns what the state does not hold for.
    [[nodiscard]] ValidityFlags validity(const TipState& state) const noexcept {
        const SceneDescription& description = scene_.description;
        return tipValidity(scene_, system(),
                           truth_ ? description.truth.material : description.sample.material,
                           state);
    }

private:
    const Scene& scene_;
    bool truth_;
    SampleSurface surface_;
};

/// The least z of a normal that says how far to go along z.
inline constexpr double kMinNormalZ = 0.1;

/// The tip with the base at one height.
struct TipAtHeight {
    double base = 0.0;  ///< height of the base [m]
    TipState state;
    EquilibriumMemory memory;  ///< for the next equilibrium

    /// Force along z [N].
    [[nodiscard]] double force() const noexcept { return state.force.z(); }
    /// Returns whether any contact point has snapped in.
    [[nodiscard]] bool isBonded() const noexcept;
};

/// The heights of the base above one position of the scan. The same heights from the same memory
/// give the same states, whatever was asked before.
class VerticalPath {
public:
    /// Fast enough that friction has its full direction, see kRestSpeed [m/s].
    static constexpr double kSpeed = 1e-6;

    /// @param position world x, y [m]
    VerticalPath(const MapInstrument& instrument, Vector2 position)
        : instrument_(instrument), position_(std::move(position)) {}

    /// Sets the velocity of the base in a requested state, on which friction depends [m/s].
    void setVelocity(const Vector3& velocity) noexcept { velocity_ = velocity; }
    void goDown() noexcept { velocity_ = -kSpeed * Vector3::UnitZ(); }
    void goUp() noexcept { velocity_ = kSpeed * Vector3::UnitZ(); }
    /// Stops: there is no friction any more.
    void stop() noexcept { velocity_ = Vector3::Zero(); }

    /// The equilibrium at a height of the base [m].
    [[nodiscard]] TipAtHeight at(double base, const EquilibriumMemory& memory);

    [[nodiscard]] const MapInstrument& instrument() const noexcept { return instrument_; }
    [[nodiscard]] const Vector2& position() const noexcept { return position_; }
    /// Equilibria so far.
    [[nodiscard]] int solved() const noexcept { return solved_; }
    /// Returns the compliance of the lever along the normal of a state [m/N].
    [[nodiscard]] double compliance(const TipState& state) const noexcept;
    /// Returns the compliance of the lever along z [m/N].
    [[nodiscard]] double complianceZ() const noexcept;
    /// Height of the tip as the instrument computes it from base and force along z [m].
    [[nodiscard]] double recordedHeight(const TipAtHeight& tip) const noexcept {
        return tip.base + (complianceZ() * tip.force());
    }

private:
    const MapInstrument& instrument_;
    Vector2 position_;
    Vector3 velocity_ = Vector3::Zero();
    ClosestPointTracker tracker_;
    int solved_ = 0;
};

/// Change of the tip between free and bonded. On one contact point the contact law knows the jump:
/// `before` is a 64th of the base's displacement between both jumps away from it, or half of the
/// shortest sampled step. On several, or where a lever that bends to the side loses the equilibrium
/// first, they lie 1e-4 of that displacement apart: the last equilibrium, and the state beyond it.
/// `before` is none where the search began from no equilibrium, and found none.
struct FoundJump {
    TipAtHeight before;
    TipAtHeight after;
    double base = 0.0;       ///< height of the base where it jumps [m]
    bool ofOnePoint = true;  ///< and its law has the jump
    /// On one contact point the contact law's own jump at this position, without the error of the
    /// search; none: the force does not jump.
    std::optional<TipJump> exact;

    /// Returns whether the force jumps.
    [[nodiscard]] bool jumps() const noexcept { return exact || !ofOnePoint; }
    [[nodiscard]] double energyLost() const noexcept;  ///< [J]
    /// Forces along z on both sides of it [N].
    [[nodiscard]] double forceBefore() const noexcept;
    [[nodiscard]] double forceAfter() const noexcept;
};

/// Lowers the base from a free tip until it snaps in. The law says how far that is; where the
/// surface makes it wrong, the change itself is searched.
/// None: the tip does not snap in.
[[nodiscard]] std::optional<FoundJump> findSnapIn(VerticalPath& path, TipAtHeight from);

/// Raises the base from a bonded tip until it is free, as the path goes: up, or without friction.
/// None: it stays bonded.
/// @param maxStep of the base [m]
/// @param passed gets each state on the way, the first and the last bonded one among them
[[nodiscard]] std::optional<FoundJump>
findPullOff(VerticalPath& path, TipAtHeight from, double maxStep, std::vector<TipAtHeight>& passed);

/// Returns how far the base must rise until the tip pulls off, by the law at its position [m].
[[nodiscard]] double heightToPullOff(const VerticalPath& path, const TipAtHeight& from);

/// Force that a search ends at: a component, or what the bending shows of it.
struct SoughtForce {
    double value = 0.0;               ///< [N]
    Vector3 axis = Vector3::UnitZ();  ///< its product with the force on the tip is the value

    [[nodiscard]] double of(const TipAtHeight& tip) const noexcept {
        return axis.dot(tip.state.force);
    }
};

/// Finds the height where the force is as sought, from a bonded tip: down where it pushes less than
/// that, else up. To 1e-12 of the force, or as near as the rounding of the base's height lets it.
/// None: no such height is found, such as on a wall so steep that friction jams the tip: the lower
/// the base, the less it pushes along z.
[[nodiscard]] std::optional<TipAtHeight> findForce(VerticalPath& path, TipAtHeight from,
                                                   const SoughtForce& force);

/// An approach of the tip to the sample.
struct Engagement {
    FoundJump snapIn;
    TipAtHeight atSetpoint;
};

/// Lowers the base at the path's position, from out of the sample's reach, until the force along z
/// is the setpoint [N]; where the tip pushes harder from its snap-in on, until there. None: it does
/// not engage.
[[nodiscard]] std::optional<Engagement> engage(VerticalPath& path, double setpoint);

}  // namespace asperity
