#pragma once

#include "bench/surface/SearchMethod.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/closest/ClosestPoint.h"

#include <memory>

namespace asperity {

/// The product, each query started from the closest point of the one before.
[[nodiscard]] std::unique_ptr<SearchMethod> ourMethod(const BSplineSurface& surface,
                                                      SearchEffort effort);

/// The paper's scheme: Newton's method from the closest point of the query before, and nothing
/// else.
[[nodiscard]] std::unique_ptr<SearchMethod> warmNewtonMethod(const BSplineSurface& surface);

}  // namespace asperity
