#pragma once

#include "core/haptics/cycle/CurveBranch.h"
#include "core/haptics/cycle/ForceTrend.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace asperity {

/// Contact stiffness dF/d(indentation) at the beginning of unloading: from the deepest position
/// until the force has fallen to three quarters. Force and separation are each fitted with a line
/// over the base distance, which has no noise, so that their ratio is not biased as a fit of two
/// noisy quantities to each other is. O(1), allocation-free. Source: initial unloading stiffness,
/// Oliver and Pharr (1992).
class UnloadingFit {
public:
    /// Begins at the deepest position so far.
    /// @param force the trend there [N]
    void restart(const ForceDistancePoint& deepest, double force) noexcept;
    /// Takes a tick after that; what comes below three quarters of the force is left out.
    /// @param force the trend [N]
    void take(const ForceDistancePoint& point, double force) noexcept;

    /// None where there is no unloading yet, or a slope is less than ten times its standard
    /// deviation: then the contact is stiffer, or softer, than the lever can tell [N/m].
    [[nodiscard]] std::optional<Reading> stiffness() const noexcept;

private:
    void add(const ForceDistancePoint& point) noexcept;
    /// Slope of a quantity over the base distance, from its sums. There is some spread.
    [[nodiscard]] Reading slopeOf(double sum, double sumOfSquares,
                                  double sumOfProducts) const noexcept;

    bool open_ = false;
    double endForce_ = 0.0;  ///< below which unloading counts no more [N]
    ForceDistancePoint first_;
    // Sums of differences from the first point.
    double count_ = 0.0;
    double base_ = 0.0;            ///< of base distances [m]
    double force_ = 0.0;           ///< [N]
    double separation_ = 0.0;      ///< [m]
    double baseBase_ = 0.0;        ///< [m^2]
    double baseForce_ = 0.0;       ///< [N m]
    double baseSeparation_ = 0.0;  ///< [m^2]
    double separation2_ = 0.0;     ///< [m^2]
    double force2_ = 0.0;          ///< [N^2]
};

/// Depth of the tip in a tick, by the same halves, and the slope of the force over it.
struct DepthBeside {
    std::array<HalfForce, 2> halves{};  ///< [m]
    double stiffness = 0.0;             ///< of the contact; 0 or less: unknown [N/m]
};

/// The strongest force of a branch, without the bias that the largest of noisy values has: each
/// half of the ticks says when the force was strongest, the other one how strong it was, and the
/// mean of both is the result. Where the force falls off at once after the strongest tick, as at a
/// fast pull-off, it is up to 0.3 standard deviations of a tick too small. O(1), allocation-free.
class StrongestForce {
public:
    /// Caution for a force that grows over many ticks: one of the first few is the strongest only
    /// where its noise alone cannot make it so, by three standard deviations.
    static constexpr double kGrowing = 3.0;
    /// Caution for a force that jumps to its strongest, such as a snap-in.
    static constexpr double kSudden = 0.0;

    /// @param caution standard deviations of the smooth force that count against it
    explicit StrongestForce(double caution) noexcept : caution_(caution) {}

    /// Takes the next tick. @param force of both halves together, see ForceTrend::pull() [N]
    /// @param depth of the tip in the same ticks
    /// @return whether that is the strongest so far: the position of the strongest force
    bool take(const std::array<HalfForce, 2>& halves, double force,
              const DepthBeside& depth = {}) noexcept;
    /// None: nothing was taken. [N]
    [[nodiscard]] const std::optional<Reading>& reading() const noexcept { return reading_; }
    /// Returns the depth at the same ticks [m]; it has no such bias, either. Noise picks among
    /// ticks whose forces differ by its deviation, and so do their depths.
    [[nodiscard]] Reading readingBeside() const noexcept;

private:
    [[nodiscard]] static Reading meanOf(const std::array<HalfForce, 2>& halves) noexcept;

    double caution_;
    double strongestForce_ = 0.0;          ///< of both halves together [N]
    std::array<double, 2> strongest_{};    ///< by each half, less caution [N]
    std::array<HalfForce, 2> measured_{};  ///< by the other half at the same tick [N]
    std::array<HalfForce, 2> measuredDepth_{};
    std::array<double, 2> pickSigma_{};  ///< of the depth, by the force that picked the tick [m]
    std::optional<Reading> reading_;
};

/// Positions where a force was as strong as its strongest within its noise: on a plateau, as soft
/// samples have, noise alone picks the tick of the strongest force, and with it the position. O(1),
/// allocation-free.
class StrongestPositions {
public:
    /// Takes the next tick. @param force [N] @param sigma its standard deviation [N]
    /// @param position of the tick along an axis [m]
    void take(double force, double sigma, double position) noexcept;
    /// Returns the standard deviation of one of these positions for where the force became as
    /// strong, or left off: that of a uniform distribution up to the farthest of them [m].
    [[nodiscard]] double sigmaOf(double position) const noexcept;

private:
    bool started_ = false;
    double first_ = 0.0;      ///< force at the first of them [N]
    double strongest_ = 0.0;  ///< [N]
    double lowest_ = 0.0;     ///< of the positions [m]
    double highest_ = 0.0;    ///< of the positions [m]
};

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

    /// The present cycle, or the last one as long as the tip does not approach again.
    [[nodiscard]] const ContactCycle& cycle() const noexcept { return cycle_; }
    /// Number of cycles that began before it.
    [[nodiscard]] std::int64_t number() const noexcept { return number_; }
    /// Branch of the latest tick.
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
    double step_ = 0.0;                 ///< of its base distance, since the tick before [m]
    double contactStiffness_ = 0.0;     ///< of the contact model there [N/m]
    double snapInMissed_ = 0.0;         ///< of the snap-in, see missedByStep() [N]
    double snapInPositionNoise_ = 0.0;  ///< of its position, by step and lever alone [m]
    double pullOffMissed_ = 0.0;        ///< of the pull-off [N]
    UnloadingFit unloading_;
    StrongestForce push_{StrongestForce::kGrowing};         ///< in contact
    StrongestForce snapInPull_{StrongestForce::kSudden};    ///< of the first approach
    StrongestForce pullOffPull_{StrongestForce::kGrowing};  ///< of the last retract
    StrongestPositions snapInPositions_;    ///< base distances at which snapInPull_ was as strong
    double deepest_ = 0.0;                  ///< base distance [m]
    Vector2 base_ = Vector2::Zero();        ///< of the base [m]
    Vector2 tip_ = Vector2::Zero();         ///< of the tip [m]
    Vector2 touched_ = Vector2::Zero();     ///< the base's position when the tip touched [m]
    Vector2 tipTouched_ = Vector2::Zero();  ///< and the tip's [m]
    double areaVariance_ = 0.0;             ///< [J^2]
    int ticksOff_ = 0;                      ///< without a sign of contact, in a row
    bool slides_ = false;
    bool retracted_ = false;  ///< the cycle's first approach is over
    bool started_ = false;
};

}  // namespace asperity
