#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace asperity {

/// One branch of a cycle in the order of time, its baseline taken off. Arrays have one value a
/// sample.
struct CycleBranch {
    std::vector<double> time;   ///< [s]; empty: not known
    std::vector<double> base;   ///< of the lever, growing towards the sample [m]
    std::vector<double> force;  ///< on the tip by the lever's calibration, > 0 repulsive [N]

    [[nodiscard]] std::size_t size() const noexcept { return base.size(); }
};

/// A measured cycle, ready to be identified.
struct MeasuredCycle {
    CycleBranch approach;
    CycleBranch dwell;  ///< between both, often empty
    CycleBranch retract;
    double stiffness = 0.0;  ///< of the lever by its calibration [N/m]
    double noise = 0.0;      ///< standard deviation of the force about the baseline [N]

    /// Largest force less smallest force of approach and retract [N].
    [[nodiscard]] double forceRange() const noexcept;
};

/// A jump of the tip in a measured branch.
struct MeasuredJump {
    std::size_t before = 0;  ///< last sample before it
    std::size_t after = 0;   ///< first sample after it
    double base = 0.0;       ///< in the middle of it [m]
};

/// The samples in contact and the jumps at their ends. Nothing here is an absolute length or force:
/// six times the noise and shares of the measured forces decide.
struct CycleEvents {
    std::optional<MeasuredJump> snapIn;   ///< none: not attracted before contact
    std::optional<MeasuredJump> pullOff;  ///< none: not attracted on the way out
    std::size_t contactBegin = 0;         ///< first sample of the approach in contact
    std::size_t contactEnd = 0;           ///< first sample of the retract beyond contact
    double lowestForce = 0.0;             ///< of the retract [N]
    bool attracts = false;                ///< the lowest force is more than noise
};

/// Finds where a cycle is in contact. @throw Error where it never is, or a branch is missing
[[nodiscard]] CycleEvents cycleEvents(const MeasuredCycle& cycle);

/// Averages the samples [from, to) of a branch into at most `bins` about equal groups.
[[nodiscard]] CycleBranch binned(const CycleBranch& branch, std::size_t from, std::size_t to,
                                 std::size_t bins);

/// Slope of the force over the base in the upper half of the forces [N/m].
[[nodiscard]] double contactSlope(const CycleBranch& samples);

}  // namespace asperity
