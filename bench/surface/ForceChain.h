#pragma once

#include "bench/surface/BenchReport.h"

namespace asperity {

/// Times what a tick with a stiff lever needs: the closest point of the tip's center, the contact
/// force along its normal, and the force that the lever's signals tell. Best of `passes` for each
/// tip.
[[nodiscard]] ChainResult timeChain(const BSplineSurface& surface, std::span<const Vector3> tips,
                                    int passes);

}  // namespace asperity
