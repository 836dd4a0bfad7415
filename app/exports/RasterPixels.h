#pragma once

#include "vtkplugins/pictures/RasterImage.h"

class QImage;

namespace asperity {

/// Pixels of Qt as files are written from them. @param image not null
[[nodiscard]] RasterImage rasterOf(const QImage& image);
/// Pixels as Qt shows them; a copy.
[[nodiscard]] QImage imageOf(const RasterImage& raster);

}  // namespace asperity
