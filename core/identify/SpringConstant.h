#pragma once

#include <vector>

namespace asperity {

/// A lever's fundamental mode as a harmonic oscillator, fitted to its thermal motion. Standard
/// deviations by the scatter of the spectrum alone.
struct ThermalOscillator {
    double resonance = 0.0;     ///< f0 [Hz]
    double resonanceStd = 0.0;  ///< [Hz]
    double quality = 0.0;       ///< Q
    double qualityStd = 0.0;
    double stiffness = 0.0;     ///< k_B T over the mean square of the motion [N/m]
    double stiffnessStd = 0.0;  ///< [N/m]
    double background = 0.0;    ///< white [m^2/Hz]
    double misfit = 0.0;        ///< rms of measured less fitted power, over that of the peak
};

/// Fits P(f) = background + P0 f0^4 / ((f^2 - f0^2)^2 + (f f0 / Q)^2) around the highest peak. All
/// samples count alike, so that the peak decides, which has nearly all of the motion, and not its
/// skirts: those of real levers are not symmetric. The mean square of the motion is the
/// oscillator's, pi/2 P0 f0 Q. Source: Hutter, Bechhoefer (1993).
/// @param frequency rising, > 0 [Hz]  @param power one-sided power density [m^2/Hz]
/// @param temperature [K]
/// @throw Error where there is no peak, or fewer than 20 samples around it
[[nodiscard]] ThermalOscillator fitThermalSpectrum(const std::vector<double>& frequency,
                                                   const std::vector<double>& power,
                                                   double temperature);

/// The fluid around a lever.
struct LeverFluid {
    double density = 1.18;       ///< [kg/m^3]; air at 25 degrees
    double viscosity = 1.86e-5;  ///< [Pa s]
};

/// Stiffness [N/m] of a rectangular lever by its plan view, resonance and quality factor in a
/// fluid: 0.1906 rho b^2 L Q w^2 Im Gamma(w). Source: Sader, Chon, Mulvaney (1999).
/// @param length, width [m]  @param resonance [Hz]
/// @throw Error where a number is not above 0
[[nodiscard]] double saderStiffness(double length, double width, double resonance, double quality,
                                    const LeverFluid& fluid = {});

}  // namespace asperity
