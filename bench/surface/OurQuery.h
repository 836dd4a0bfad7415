#pragma once

#include "bench/surface/FootMethod.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/foot/SurfaceFoot.h"

#include <memory>

namespace asperity {

/// The product, each query started from the foot of the one before.
[[nodiscard]] std::unique_ptr<FootMethod> ourMethod(const BSplineSurface& surface,
                                                    FootEffort effort);

/// The paper's scheme: Newton's method from the foot of the query before, and nothing else.
[[nodiscard]] std::unique_ptr<FootMethod> warmNewtonMethod(const BSplineSurface& surface);

}  // namespace asperity
