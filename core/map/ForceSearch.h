#pragma once

#include "core/map/VerticalPath.h"

#include <optional>

namespace asperity {

/// Where the force along z is `force` [N], from a bonded tip: down where it pushes less than that,
/// else up. To 1e-12 of the force, or as near as the rounding of the base's height lets it.
/// None: no such height is found, such as on a wall so steep that friction jams the tip: the lower
/// the base, the less it pushes along z.
[[nodiscard]] std::optional<TipAtHeight> findForce(VerticalPath& path, TipAtHeight from,
                                                   double force);

}  // namespace asperity
