#pragma once

#include "bench/scaling/ScalingSweep.h"

namespace asperity {

/// For people, to stdout: a line for each work with its times, and the slope of each curve.
void printTable(const ScalingSweep& sweep);

}  // namespace asperity
