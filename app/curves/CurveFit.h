#pragma once

#include "app/curves/FitFiles.h"
#include "app/runs/OutputFolder.h"
#include "core/io/curves/ForceCurveFile.h"

#include <cstddef>
#include <filesystem>
#include <string>

namespace asperity {

/// Fits a curve of an open file; its checksum is left out. @param path as the user gave it
/// @throw InputError where it is damaged
[[nodiscard]] FittedCurve fittedCurve(const std::string& path, const ForceCurveFile& file,
                                      std::size_t index, const CycleFitOptions& options);

/// Opens a file and fits a curve of it. @throw InputError where the file cannot be read
[[nodiscard]] FittedCurve fittedCurve(const std::string& path, std::size_t index,
                                      const CurveReadOptions& read, const CycleFitOptions& options);

/// Files of one curve in its folder. A refused one leaves no tables.
[[nodiscard]] FolderContent fitFolder();

/// Writes all files of a curve, and of its scene where there is one; needs a QGuiApplication.
void writeFitFiles(const std::filesystem::path& folder, const FittedCurve& curve);

}  // namespace asperity
