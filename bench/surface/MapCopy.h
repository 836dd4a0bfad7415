#pragma once

#include "bench/surface/BenchReport.h"

namespace asperity {

/// Copies a map of `pixels` x `pixels` float heights: no pass over one is faster.
[[nodiscard]] CopyResult timeCopy(int pixels);

}  // namespace asperity
