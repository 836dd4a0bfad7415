#pragma once

#include "bench/surface/FootMethod.h"
#include "core/surface/BSplineSurface.h"

#include <memory>

namespace asperity {

/// The product, each query started from the foot of the one before.
[[nodiscard]] std::unique_ptr<FootMethod> ourMethod(const BSplineSurface& surface);

/// The part of it that seeks no proof: a local minimum.
[[nodiscard]] std::unique_ptr<FootMethod> ourLocalMethod(const BSplineSurface& surface);

/// The paper's scheme: Newton's method from the foot of the query before, and nothing else.
[[nodiscard]] std::unique_ptr<FootMethod> warmNewtonMethod(const BSplineSurface& surface);

}  // namespace asperity
