#pragma once

#include <vector>

namespace asperity {

/// A lever's thermal motion over the frequency, as an instrument measured it, with what its program
/// fitted to it: a single harmonic oscillator. The calibration of the lever from it is compared
/// with that fit. Source: docs/formats.md 21.
struct ThermalSpectrum {
    std::vector<double> frequency;    ///< [Hz], rising
    std::vector<double> power;        ///< one-sided power density [m^2/Hz]
    std::vector<double> fittedPower;  ///< of the program's fit [m^2/Hz]; empty: the file has none
    // Of the program's fit; 0: the file does not say it.
    double resonance = 0.0;    ///< [Hz]
    double quality = 0.0;      ///< quality factor
    double stiffness = 0.0;    ///< [N/m]
    double peakDensity = 0.0;  ///< amplitude density at the resonance [m/sqrt(Hz)]
    double lowest = 0.0;       ///< frequency that the fit began at [Hz]
    double highest = 0.0;      ///< frequency that the fit ended at [Hz]
    double averages = 0.0;     ///< spectra that this one is the mean of
    double temperature = 0.0;  ///< as the file says it, of unknown unit
};

}  // namespace asperity
