#pragma once

#include "core/curves/MeasuredForceCurve.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace asperity {

/// Place on a branch: a share of the way from a sample to the next one.
struct BranchPlace {
    std::size_t sample = 0;
    double share = 0.0;  ///< 0 to 1, without 1

    auto operator<=>(const BranchPlace&) const = default;
};

/// One branch of a curve, its samples in the order in which they were measured; at least one. The
/// distance is that of the base above the recorded contact, < 0 below it. No allocation, no throw.
struct PlayedBranch {
    std::vector<double> distance;  ///< [m]
    std::vector<double> force;     ///< along z, > 0: up [N]
    double slack = 0.0;            ///< so near, a base is at a sample [m]

    [[nodiscard]] BranchPlace end() const noexcept { return {distance.size() - 1, 0.0}; }
    [[nodiscard]] double distanceAt(const BranchPlace& place) const noexcept;
    /// A sample's own bits at the sample, linear in between.
    [[nodiscard]] double forceAt(const BranchPlace& place) const noexcept;

    /// The first place of a distance at all.
    [[nodiscard]] std::optional<BranchPlace> first(double wanted) const noexcept;
    /// The place of a distance no farther than the next sample.
    [[nodiscard]] std::optional<BranchPlace> next(const BranchPlace& from,
                                                  double wanted) const noexcept;
    /// The first place of a distance from here on.
    [[nodiscard]] std::optional<BranchPlace> ahead(const BranchPlace& from,
                                                   double wanted) const noexcept;
    /// The last place of a distance up to here.
    [[nodiscard]] std::optional<BranchPlace> behind(const BranchPlace& from,
                                                    double wanted) const noexcept;
    /// The first place of a force.
    [[nodiscard]] std::optional<BranchPlace> withForce(double wanted) const noexcept;
};

/// A measured curve as RecordedAfm plays it: approach and retract above one baseline, with the
/// recorded noise. They part at the deepest sample, which ends the one and begins the other.
/// What was measured while the base paused is left out.
struct PlayedCurve {
    PlayedBranch approach;
    PlayedBranch retract;
    double touch = 0.0;      ///< distance from which on the tip holds to the sample, >= 0 [m]
    double free = 0.0;       ///< of the retract, beyond which nothing holds the tip, >= 0 [m]
    double stiffness = 0.0;  ///< of the lever that measured it [N/m]
};

/// The approach that pushes most and the retract after it, aligned by alignedCurve(): the contact
/// is where its force last passes zero before its maximum, the baseline that of the approach. Where
/// the curve says no force, it is stiffness times deflection.
/// @param stiffness of the lever where the curve does not say it [N/m]; 0: it must
/// @throw Error where it has no approach with a contact, no retract, one that does not come free,
/// or no stiffness
[[nodiscard]] std::shared_ptr<const PlayedCurve> playedCurve(MeasuredForceCurve curve,
                                                             double stiffness);

}  // namespace asperity
