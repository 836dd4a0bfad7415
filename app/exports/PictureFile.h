#pragma once

#include "app/exports/ExportFormat.h"
#include "vtkplugins/pictures/RasterImage.h"

#include <filesystem>

namespace asperity {

/// Writes pixels as PNG or TIFF, whole or not at all; without alpha where all of it is opaque.
/// @param dpi resolution that the file says [dots an inch]: pHYs of PNG, XResolution of TIFF
/// @throw Error when the file cannot be written
void writePicture(const std::filesystem::path& path, const RasterImage& image, ExportFormat format,
                  double dpi);

}  // namespace asperity
