#pragma once

#include "core/io/ByteReader.h"

#include <filesystem>
#include <vector>

// Files of thermal spectra, which calibrate a lever and hold no curve; they are told by their
// content, as files of curves are. Source: docs/formats.md 21.

namespace asperity {

/// A lever's thermal motion over the frequency, as an instrument measured it, with what its program
/// fitted to it: a single harmonic oscillator. The calibration of the lever from it is compared
/// with that fit. Source: docs/formats.md 21.
struct ThermalSpectrum {
    std::vector<double> frequency;    ///< [Hz], rising
    std::vector<double> power;        ///< one-sided power density [m^2/Hz]
    std::vector<double> fittedPower;  ///< of the program's fit [m^2/Hz]; empty: the file has none
    // Results of that fit; 0: not in the file.
    double resonance = 0.0;    ///< [Hz]
    double quality = 0.0;      ///< quality factor
    double stiffness = 0.0;    ///< [N/m]
    double peakDensity = 0.0;  ///< amplitude density at the resonance [m/sqrt(Hz)]
    double lowest = 0.0;       ///< frequency that the fit began at [Hz]
    double highest = 0.0;      ///< frequency that the fit ended at [Hz]
    double averages = 0.0;     ///< spectra that this one is the mean of
    double temperature = 0.0;  ///< as the file says it, of unknown unit
};

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
