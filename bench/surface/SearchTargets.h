#pragma once

#include "bench/surface/BenchReport.h"

namespace asperity {

/// Prints what the closest point is to reach on the paths that targets were set for, each figure
/// with its target beside it; a peer that did not run has none. For people, to stdout.
void printPointTargets(const WorkResult& work);

}  // namespace asperity
