#pragma once

#include "core/io/heightmap/HeightMapFormat.h"
#include "core/surface/GivenScale.h"

namespace asperity {

/// Puts a size in place of a file's, and heights in place of the numbers without unit of its
/// channels; other units stay. Notes and provenance of each channel say so.
/// @param file for messages
/// @throw InputError when heights are given and all channels have a unit: one of both is wrong
void applyScale(StoredScan& scan, const GivenScale& given, const std::string& file);

}  // namespace asperity
