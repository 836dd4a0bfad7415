#pragma once

#include "core/EnumTable.h"
#include "core/Vector.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"

#include <cstdint>
#include <optional>

namespace asperity {

/// The two branches of a force-distance curve: which way the tip was sent last.
enum class CurveBranch : std::uint8_t {
    Approach,  ///< down, or held after that
    Retract,   ///< up, or held after that
};

template <>
inline constexpr auto kEnumTable<CurveBranch> = std::to_array<EnumRow<CurveBranch>>(
    {{CurveBranch::Approach, "approach"}, {CurveBranch::Retract, "retract"}});

/// Follows the commanded height. A branch ends when the height has turned back by more than the
/// jitter of a device; a tip at rest stays on its branch. O(1), allocation-free.
class BranchTracker {
public:
    static constexpr double kTurn = 0.05e-9;  ///< by which a new branch must have gone [m]

    /// The branch of the next tick; a run begins with an approach.
    CurveBranch take(const TickInput& input, const TickOutput& out) noexcept;
    /// The branch of the latest tick.
    [[nodiscard]] CurveBranch branch() const noexcept { return branch_; }

private:
    double farthest_ = 0.0;  ///< height that the branch has reached so far [m]
    bool started_ = false;
    CurveBranch branch_ = CurveBranch::Approach;
};

/// One tick as a point of a force-distance curve: all along the normal at the contact. Distances
/// are to the undeformed surface that the model believes in.
struct ForceDistancePoint {
    double force = 0.0;         ///< estimated, on the tip, > 0 repulsive [N]
    double sigma = 0.0;         ///< standard deviation of `force` [N]
    double separation = 0.0;    ///< of the tip as the estimate has it, < 0: indented [m]
    double baseDistance = 0.0;  ///< of the undeflected tip: what the piezo sets, without noise [m]
};

/// Returns whether a tick has such a point: its model state is solved and all of it is finite.
[[nodiscard]] bool hasPoint(const TickOutput& out) noexcept;

/// The point of a tick that has one.
[[nodiscard]] ForceDistancePoint forceDistancePoint(const TickOutput& out) noexcept;

/// Progress of a cycle.
enum class CyclePhase : std::uint8_t {
    Apart,     ///< the tip has not touched yet
    Contact,   ///< it has, and has not come off
    Complete,  ///< it has come off
};

/// A value read from a curve with its standard deviation, in the unit of the value.
struct Reading {
    double value = 0.0;
    double sigma = 0.0;
};

/// Readings of one cycle's force-distance curve: approach, contact, retract, off. Forces are
/// estimates along the normal. Areas are those between curve and axis; the distance may be the
/// separation or the base's: the deflection of an elastic lever adds no area to a closed curve.
/// They are exact for a tip that moves along the normal: over a rough sample a slide changes both
/// distances, too.
struct ContactCycle {
    CyclePhase phase = CyclePhase::Apart;
    double touchTime = 0.0;              ///< first tick in contact [s]
    Vector2 position = Vector2::Zero();  ///< of the tip in that tick, world x, y [m]
    double offTime = 0.0;                ///< first tick after it [s]
    /// The tip was in contact when the run began: there is no approach, and its touch is not seen.
    bool fromStart = false;
    std::optional<Reading> maxForce;  ///< > 0; none: the sample never pushed beyond the noise [N]
    std::optional<Reading> maxIndentation;  ///< of the undeformed surface at that force [m]
    /// Strongest pull of the first approach, > 0; none: no pull beyond the noise [N]
    std::optional<Reading> snapIn;
    Reading snapInBaseDistance;  ///< gap that the undeflected tip had there [m]
    /// Strongest pull of the last retract branch so far, > 0; none: no pull beyond the noise [N]
    std::optional<Reading> pullOff;
    double pullOffSeparation = 0.0;    ///< where that was [m]
    double pullOffBaseDistance = 0.0;  ///< [m]
    int contacts = 0;                  ///< most that the model had at once
    /// In contact the model had no state for some ticks, which are left out: areas and the
    /// strongest forces are of the rest.
    bool interrupted = false;
    /// Work of adhesion: area between the last retract branch and zero force, where it pulls [J]
    double adhesionWork = 0.0;
    double hysteresis = 0.0;  ///< area between approach and retract so far [J]
    /// Standard deviation of both areas: noise of the force, and ticks too few for its jumps [J]
    double areaSigma = 0.0;
    bool slid = false;  ///< tip or base slid in contact: the curves are not of one position
    /// Contact stiffness at the beginning of unloading; none: no such branch, or the contact is
    /// stiffer than the lever can tell [N/m]
    std::optional<Reading> stiffness;

    [[nodiscard]] bool touched() const noexcept { return phase != CyclePhase::Apart; }
    [[nodiscard]] bool complete() const noexcept { return phase == CyclePhase::Complete; }
    /// The energy dissipated. None where approach and retract are no closed loop at one position:
    /// the tip has not come off, slid, or was in contact from the start, or a part is missing [J]
    [[nodiscard]] std::optional<Reading> closedHysteresis() const noexcept {
        const bool isClosed = complete() && !slid && !fromStart && !interrupted;
        return isClosed ? std::optional(Reading{hysteresis, areaSigma}) : std::nullopt;
    }
    /// None: the tip has not come off, or the retract did not pull beyond the noise [N]
    [[nodiscard]] std::optional<Reading> pullOffForce() const noexcept {
        return complete() ? pullOff : std::nullopt;
    }
    /// None where there is no pull-off force [J]
    [[nodiscard]] std::optional<Reading> workOfAdhesion() const noexcept {
        return pullOffForce() ? std::optional(Reading{adhesionWork, areaSigma}) : std::nullopt;
    }
};

}  // namespace asperity
