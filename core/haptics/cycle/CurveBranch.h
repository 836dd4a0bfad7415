#pragma once

#include "core/EnumTable.h"
#include "core/scene/TickInput.h"
#include "core/scene/TickOutput.h"

#include <cstdint>

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

}  // namespace asperity
