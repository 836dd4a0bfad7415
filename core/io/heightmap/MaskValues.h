#pragma once

#include "core/io/heightmap/HeightMapFormat.h"

namespace asperity {

/// Finds whether a channel is a mask, and notes it there. Values of a mask have no unit; they are
/// shares from 0 to 1, at least half of them 0 or 1, or all of them 0 or the highest number of 8 or
/// 16 bits. Of heights without unit, few are exactly the lowest or the highest one.
void noteMask(StoredChannel& stored);

}  // namespace asperity
