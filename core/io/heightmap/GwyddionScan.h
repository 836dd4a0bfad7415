#pragma once

#include "core/io/ByteReader.h"
#include "core/io/heightmap/Gwyddion.h"
#include "core/io/heightmap/HeightMapFormat.h"

#include <string>

namespace asperity {

/// Content as Gwyddion converts it.
struct GwyddionScan {
    std::string format;  ///< for people: "Nearly raw raster data (NRRD) files (.nrrd), through
                         ///< Gwyddion 2.62"
    StoredScan scan;     ///< needs nothing else
};

/// Lets Gwyddion identify the content and convert it to .gwy, which is read as any other. Gwyddion
/// gets a copy in a folder of its own under the system's temporary one, which is removed before
/// this returns.
/// @param gwyddion its program is not empty
/// @param unknown start of a refusal when Gwyddion does not recognize the content, either
/// @throw InputError then, and when Gwyddion only guesses (a score below 50), takes it for a
///        picture, fails, writes too much or does not end in time; Error when there is no room for
///        the copy or the program cannot be started
[[nodiscard]] GwyddionScan readThroughGwyddion(const ByteSource& bytes, const Gwyddion& gwyddion,
                                               const std::string& unknown);

}  // namespace asperity
