#pragma once

#include <cmath>
#include <vector>

namespace asperity {

/// A film on a rigid base.
struct Film {
    double thickness = 0.0;  ///< [m]; 0: a half-space
    double poissonRatio = 0.5;
};

/// States of the contact laws: all of these with each other, each at every position of the way in
/// and out. All values within the laws' ranges, tip radii rising.
struct ContactGrid {
    std::vector<double> tipRadii;          ///< [m]
    std::vector<double> moduli;            ///< E* [Pa]
    std::vector<double> adhesions;         ///< w on a half-space [J/m^2]; 0: none
    std::vector<Film> films;               ///< without adhesion
    std::vector<double> leverStiffnesses;  ///< [N/m]; infinite: displacement control
    int stops = 0;                         ///< of the tip, one way; >= 4

    [[nodiscard]] long ways() const noexcept;  ///< in and out: how many there are
};

/// Runs of the whole tick: all of these with each other, on every material of tickExtremes().
struct TickGrid {
    std::vector<double> tipRadii;          ///< [m]
    std::vector<double> roughnesses;       ///< rms height over tip radius
    std::vector<double> leverStiffnesses;  ///< [N/m]
    std::vector<double> depths;            ///< of the base below first touch, over tip radius
    int ticks = 0;                         ///< of one run

    [[nodiscard]] long runs() const noexcept;
};

/// Operators at a device: all of these with each other, on every sample of holdMaterials() and with
/// every grip, or every `stride`-th of them; each with and without a coupling.
struct CouplingGrid {
    std::vector<double> leverStiffnesses;  ///< [N/m]
    std::vector<double> tickRates;         ///< [Hz]
    std::vector<double> delays;            ///< from a motion to its force, without the hold [s]
    std::vector<double> positionGains;     ///< displacement at the tip per that of the device
    std::vector<double> forceGains;        ///< device force per force at the tip
    long stride = 1;

    [[nodiscard]] long settings() const noexcept;  ///< without the stride
    [[nodiscard]] long holds() const noexcept;     ///< that are evaluated
};

/// All states that are evaluated, each once: with every law and solver, or every closest point
/// search; on the bench.
struct ExtremesGrid {
    ContactGrid contact;
    TickGrid tick;
    CouplingGrid coupling;

    /// The ends of the ranges of docs/extremes.md with steps such that there are this many states
    /// to within some 5 %. @param states >= 1e4
    [[nodiscard]] static ExtremesGrid ofAbout(double states);

    [[nodiscard]] long states() const noexcept;
};

/// `count` >= 2 values of one sign from first to last, each the same factor apart.
[[nodiscard]] inline std::vector<double> logSpaced(double first, double last, int count) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
        values.push_back(first * std::pow(last / first, static_cast<double>(i) / (count - 1)));
    }
    return values;
}

}  // namespace asperity
