#pragma once

#include "core/curves/ThermalSpectrum.h"
#include "core/io/ByteReader.h"

#include <filesystem>

// Files of thermal spectra, which calibrate a lever and hold no curve; they are told by their
// content, as files of curves are. Source: docs/formats.md 21.

namespace asperity {

/// Returns whether a content is a Nanosurf file with a thermal spectrum, by a look at its header;
/// damaged or not. Such a file is no file of force curves, and holds no image.
[[nodiscard]] bool holdsThermalSpectrum(const ByteSource& bytes);

/// Reads the thermal spectrum of a Nanosurf .nid file, which stores an amplitude density: its
/// square is the power density. The curve that the program fitted lies beside it in the file, its
/// parameters in the section DataSet-Info.
/// @throw InputError where it holds none, or anything is missing or does not fit together
[[nodiscard]] ThermalSpectrum readThermalSpectrum(const ByteSource& bytes);
/// The same of a file. @throw InputError as above, and where it cannot be read
[[nodiscard]] ThermalSpectrum readThermalSpectrum(const std::filesystem::path& path);

}  // namespace asperity
