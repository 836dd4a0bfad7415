#pragma once

#include "core/probe/recorded/PlayedCurve.h"

#include <cstdint>

namespace asperity {

/// What a recorded curve says of a base.
struct PlayedForce {
    double force = 0.0;         ///< along z [N]
    bool extrapolated = false;  ///< the record has no such motion
    bool beyond = false;        ///< deeper than the record goes: there is no force
};

/// Plays a recorded curve to a base that moves as it likes, one step after another.
///
/// The approach is played down to the deepest base that was reached. Before the tip touches it is
/// played both ways, since nothing but the baseline is lost. Where the base turns at the deepest
/// sample, the retract follows.
///
/// Where it turns before, the record has no answer. It is then the retract, shifted along the base
/// so that it begins with the force at which the base turned: the same contact lets go of the same
/// load, from another depth. Down again it goes back the same way, so that a small motion to and
/// fro loses nothing, and from the depth where it turned on the approach goes on. So it is with a
/// base that turns down within the recorded retract. All of this is `extrapolated`.
/// Where the tip came free the next step down begins a new approach. If the force is another one
/// there (the drag's, or noise), the difference fades linearly until the tip touches, so that no
/// step of the force comes from a turn.
/// Above the record there is the baseline, no force. No allocation, no throw.
class CurvePlayer {
public:
    /// The curve must outlive the player.
    explicit CurvePlayer(const PlayedCurve& curve) noexcept : curve_(curve) {}

    /// @param distance of the base above the recorded contact, finite [m]
    [[nodiscard]] PlayedForce moveTo(double distance) noexcept;

    /// Returns whether the tip holds to the sample, or has not come free since.
    [[nodiscard]] bool touches() const noexcept;

private:
    /// A difference of force that fades along the base.
    struct Fading {
        double force = 0.0;  ///< at `from` and before [N]
        double from = 0.0;   ///< [m]
        double to = 0.0;     ///< where nothing is left [m]

        [[nodiscard]] double at(double distance) const noexcept;
    };
    enum class Branch : std::uint8_t { Approach, Retract };

    [[nodiscard]] PlayedForce approach(double distance) noexcept;
    [[nodiscard]] std::optional<BranchPlace> approached(double distance) const noexcept;
    [[nodiscard]] PlayedForce retract(double distance) noexcept;
    [[nodiscard]] PlayedForce retrace(double distance) noexcept;
    [[nodiscard]] PlayedForce retracted(double distance) const noexcept;
    void turn() noexcept;
    void beginAgain() noexcept;
    [[nodiscard]] bool isFree() const noexcept;

    const PlayedCurve& curve_;
    Branch branch_ = Branch::Approach;
    bool isAbove_ = true;     ///< of the approach's record: it has not begun
    BranchPlace down_;        ///< on the approach, where it has begun
    BranchPlace up_;          ///< on the retract
    BranchPlace highest_;     ///< on the retract that the base has reached
    double shift_ = 0.0;      ///< of the retract away from the sample [m]
    bool asRecorded_ = true;  ///< the base turned where the record does
    Fading fading_;
};

}  // namespace asperity
