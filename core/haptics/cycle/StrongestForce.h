#pragma once

#include "core/haptics/cycle/ContactCycle.h"
#include "core/haptics/cycle/ForceTrend.h"

#include <array>
#include <cstddef>
#include <optional>

namespace asperity {

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
    /// @param beside another signal of the same ticks, by the same halves
    /// @return whether that is the strongest so far: the place of the strongest force
    bool take(const std::array<HalfForce, 2>& halves, double force,
              const std::array<HalfForce, 2>& beside = {}) noexcept;
    /// None: nothing was taken. [N]
    [[nodiscard]] const std::optional<Reading>& reading() const noexcept { return reading_; }
    /// Returns the other signal at the same ticks; it has no such bias, either.
    [[nodiscard]] Reading readingBeside() const noexcept { return meanOf(measuredBeside_); }

private:
    [[nodiscard]] static Reading meanOf(const std::array<HalfForce, 2>& halves) noexcept;

    double caution_;
    double strongestForce_ = 0.0;          ///< of both halves together [N]
    std::array<double, 2> strongest_{};    ///< by each half, less caution [N]
    std::array<HalfForce, 2> measured_{};  ///< by the other half at the same tick [N]
    std::array<HalfForce, 2> measuredBeside_{};
    std::optional<Reading> reading_;
};

}  // namespace asperity
