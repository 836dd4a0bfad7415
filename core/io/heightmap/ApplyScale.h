#pragma once

#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/GivenScale.h"

namespace asperity {

/// Puts a size in place of a file's, and heights in place of the numbers without unit of its
/// channels; where all of them have one, in place of lengths. Other units stay. Notes and
/// provenance of each channel say so.
void applyScale(StoredScan& scan, const GivenScale& given);

}  // namespace asperity
