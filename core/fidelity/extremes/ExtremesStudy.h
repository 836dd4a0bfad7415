#pragma once

#include "core/Progress.h"
#include "core/fidelity/extremes/ExtremesRegion.h"

#include <string>
#include <vector>

namespace asperity {

/// States of the contact laws: all of these with each other, each at every place of the way in and
/// out, with every law and solver. All values within the laws' ranges, tip radii rising.
struct ContactGrid {
    std::vector<double> tipRadii;          ///< [m]
    std::vector<double> moduli;            ///< E* [Pa]
    std::vector<double> adhesions;         ///< w on a half-space [J/m^2]; 0: none
    std::vector<double> filmThicknesses;   ///< of films without adhesion [m]
    std::vector<double> leverStiffnesses;  ///< [N/m]; infinite: displacement control
    int places = 0;                        ///< of the tip, one way
};

/// Runs of the whole tick: all of these with each other, on three materials, with every effort of
/// the foot search.
struct TickGrid {
    std::vector<double> tipRadii;          ///< [m]
    std::vector<double> roughnesses;       ///< rms height over tip radius
    std::vector<double> leverStiffnesses;  ///< [N/m]
    std::vector<double> rates;             ///< of the loop [Hz]
    std::vector<double> gainShares;        ///< force gain over largestForceGain()
    int ticks = 0;                         ///< of one run
};

struct ExtremesGrid {
    ContactGrid contact;
    TickGrid tick;

    /// The ends of the ranges of docs/extremes.md with steps such that there are roughly this many
    /// states, at least some ten thousand.
    [[nodiscard]] static ExtremesGrid ofAbout(double states);
};

/// What a part of the study found.
struct ExtremesFindings {
    std::vector<ExtremesRegion> regions;
    long defects = 0;  ///< states that no answer may have: a value that is not finite, no balance
    /// The first of them in each place of the grid, one sentence each, so that it can be repeated.
    std::vector<std::string> examples;

    /// Counts one more of them. @param sentence says what state it is and what is wrong
    void addDefect(const std::string& sentence);

    void add(ExtremesFindings&& other);
    [[nodiscard]] long states() const noexcept;
};

/// Evaluates every state of the grid on the virtual clock, on as many threads as there are cores;
/// the same grid gives the same findings. @param progress may be null @throw Cancelled
[[nodiscard]] ExtremesFindings studyExtremes(const ExtremesGrid& grid,
                                             Progress* progress = nullptr);

}  // namespace asperity
