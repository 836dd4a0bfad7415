#pragma once

#include "core/map/JumpSearch.h"

#include <optional>

namespace asperity {

/// An approach of the tip to the sample.
struct Engagement {
    FoundJump snapIn;
    TipAtHeight atSetpoint;
};

/// Lowers the base at the path's place, from out of the sample's reach, until the force along z is
/// the setpoint [N]; where the tip pushes harder from its snap-in on, until there.
/// None: it does not engage.
[[nodiscard]] std::optional<Engagement> engage(VerticalPath& path, double setpoint);

}  // namespace asperity
