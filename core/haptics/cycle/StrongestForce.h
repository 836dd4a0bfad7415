#pragma once

#include "core/haptics/cycle/ContactCycle.h"
#include "core/haptics/cycle/ForceTrend.h"

#include <array>
#include <cstddef>
#include <optional>

namespace asperity {

/// How deep the tip is in a tick, by the same halves, and how steeply the force goes with that.
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
    /// Of a force that grows over many ticks: one of the first few is the strongest only where its
    /// noise alone cannot make it so, by three standard deviations.
    static constexpr double kGrowing = 3.0;
    /// Of a force that jumps to its strongest, such as a snap-in.
    static constexpr double kSudden = 0.0;

    /// @param caution standard deviations of the smooth force that count against it
    explicit StrongestForce(double caution) noexcept : caution_(caution) {}

    /// Takes the next tick. @param force of both halves together, see ForceTrend::pull() [N]
    /// @param depth of the tip in the same ticks
    /// @return whether that is the strongest so far: the place of the strongest force
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

/// Where a force was as strong as its strongest within its noise: on a plateau, as soft samples
/// have, noise alone picks the tick of the strongest force, and with it the place. O(1),
/// allocation-free.
class StrongestPlaces {
public:
    /// Takes the next tick. @param force [N] @param sigma its standard deviation [N]
    /// @param place of the tick along an axis [m]
    void take(double force, double sigma, double place) noexcept;
    /// Returns the standard deviation of one of these places, as the place where the force became
    /// as strong, or left off: that of a uniform distribution up to the farthest of them [m].
    [[nodiscard]] double sigmaOf(double place) const noexcept;

private:
    bool started_ = false;
    double first_ = 0.0;      ///< force at the first of them [N]
    double strongest_ = 0.0;  ///< [N]
    double lowest_ = 0.0;     ///< of the places [m]
    double highest_ = 0.0;    ///< of the places [m]
};

}  // namespace asperity
