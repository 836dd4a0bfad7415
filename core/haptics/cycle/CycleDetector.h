#pragma once

#include "core/haptics/cycle/ContactCycle.h"
#include "core/haptics/cycle/CurveBranch.h"
#include "core/haptics/cycle/ForceDistancePoint.h"
#include "core/haptics/cycle/ForceTrend.h"
#include "core/haptics/cycle/StrongestForce.h"
#include "core/haptics/cycle/UnloadingFit.h"

#include <cstdint>

namespace asperity {

/// Finds the cycles of a run, tick by tick: approach, contact, retract, off.
///
/// The tip touches when the estimate pushes beyond its noise, or pulls while the contact model has
/// snapped in. It is off when neither is so: the model has let go, and the estimate shows no more
/// than half of the strongest pull. An instrument and its model seldom come off in the same tick;
/// the later of the two ends the cycle, and a pull that comes only then reopens it. A cycle begins
/// when the tip turns to the sample in free air. However often it turns or rests in contact, the
/// cycle goes on, and what it says of the retract is of the last one, of the approach of the first.
/// O(1) a tick, allocation-free.
class CycleDetector {
public:
    /// A tick without a point (no state of the model, values that are not finite) is left out.
    void take(double time, const TickInput& input, const TickOutput& out) noexcept;

    /// The present cycle, or the last one as long as the tip does not approach anew.
    [[nodiscard]] const ContactCycle& cycle() const noexcept { return cycle_; }
    /// How many cycles have begun before it.
    [[nodiscard]] std::int64_t number() const noexcept { return number_; }
    /// Of the latest tick.
    [[nodiscard]] CurveBranch branch() const noexcept { return branch_.branch(); }
    [[nodiscard]] const ForceDistancePoint& point() const noexcept { return point_; }

private:
    void takeTrends() noexcept;
    /// Returns the compliance of the lever along the normal [m/N].
    [[nodiscard]] double compliance() const noexcept;
    void takeApart(double time, bool turned, bool touches) noexcept;
    void takeContact(double time, bool turned, bool held) noexcept;
    void takeSnapIn() noexcept;
    void takePullOff() noexcept;
    void takeAreas(double forceBefore) noexcept;
    /// Returns how much stronger a force was before a jump, or after it, than the tick beside
    /// shows: root mean square [N].
    [[nodiscard]] double missedByStep() const noexcept;
    void takeUnloading() noexcept;
    void begin() noexcept;

    ContactCycle cycle_;
    std::int64_t number_ = 0;
    BranchTracker branch_;
    ForceTrend trend_;
    ForceTrend depth_;  ///< of the indentation, in meters for newtons
    /// Sums over all ticks, of deflection times force and of the force's square: see compliance().
    double deflectionTimesForce_ = 0.0;
    double forceSquares_ = 0.0;
    ForceDistancePoint point_;
    double step_ = 0.0;              ///< of its base distance, since the tick before [m]
    double contactStiffness_ = 0.0;  ///< of the contact model there [N/m]
    double snapInMissed_ = 0.0;      ///< of the snap-in, see missedByStep() [N]
    double snapInPlaceNoise_ = 0.0;  ///< of its place, by step and lever alone [m]
    double pullOffMissed_ = 0.0;     ///< of the pull-off [N]
    UnloadingFit unloading_;
    StrongestForce push_{StrongestForce::kGrowing};         ///< in contact
    StrongestForce snapInPull_{StrongestForce::kSudden};    ///< of the first approach
    StrongestForce pullOffPull_{StrongestForce::kGrowing};  ///< of the last retract
    StrongestPlaces snapInPlaces_;          ///< base distances at which snapInPull_ was as strong
    double deepest_ = 0.0;                  ///< base distance [m]
    Vector2 place_ = Vector2::Zero();       ///< of the base [m]
    Vector2 tip_ = Vector2::Zero();         ///< of the tip [m]
    Vector2 touched_ = Vector2::Zero();     ///< the base's place when the tip touched [m]
    Vector2 tipTouched_ = Vector2::Zero();  ///< and the tip's [m]
    double areaVariance_ = 0.0;             ///< [J^2]
    int ticksOff_ = 0;                      ///< without a sign of contact, in a row
    bool slides_ = false;
    bool retracted_ = false;  ///< the cycle's first approach is over
    bool started_ = false;
};

}  // namespace asperity
