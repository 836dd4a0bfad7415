#pragma once

#include "core/Progress.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/scene/SceneDescription.h"
#include "core/surface/BSplineSurface.h"
#include "core/surface/PixelField.h"

#include <string>
#include <vector>

namespace asperity {

/// Names of the images of a file that have the pixels of its channel of this name, each once; that
/// one left out.
[[nodiscard]] std::vector<std::string> imagesBeside(const HeightMapFile& file,
                                                    const std::string& channel);

/// The image of this name in the file of a sample, over the pixels of its surface, in the file's
/// unit. @throw InputError when it cannot be read or has other pixels; Canceled
[[nodiscard]] PixelField imageBeside(const SampleDescription& sample, const BSplineSurface& surface,
                                     const std::string& name, Progress* progress = nullptr);

/// What a surface leaves out of its scan, leveled as the sample says: data minus surface [m].
/// @param surface of this sample
/// @throw InputError when the file cannot be read, Error when the surface has another size;
/// Canceled
[[nodiscard]] PixelField residualImage(const SampleDescription& sample,
                                       const BSplineSurface& surface, Progress* progress = nullptr);

}  // namespace asperity
