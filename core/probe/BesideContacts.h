#pragma once

#include "core/probe/BodySum.h"
#include "core/probe/ProbeSystem.h"
#include "core/probe/TipContactPoint.h"

#include <optional>
#include <span>

namespace asperity {

/// Attraction of a tip by the sample beside its contacts while its equilibrium is sought: summed
/// where the tip is, and from there on a straight line, see BodyForce. Nothing where the sample
/// does not attract. Source: docs/theory.md 3.8.
class BesideContacts {
public:
    explicit BesideContacts(const ProbeSystem& system) noexcept
        : system_(system), attracts_(system.attractsBeside()) {}

    [[nodiscard]] bool attracts() const noexcept { return attracts_; }

    /// Sums for contact points, the main one first, and an apex [m].
    void sum(std::span<const TipContactPoint> points, const Vector3& tip) noexcept;
    /// Sums again where the last sum is off at another place; whether it did.
    bool follow(std::span<const TipContactPoint> points, const Vector3& tip) noexcept;
    /// Makes the next follow() sum: the last sum was for other points.
    void forget() noexcept { error_ = 0.0; }

    /// Where the tip is likely to end that begins here: as long as a contact holds it, its
    /// indentation changes little. @param before apex where the main point was left [m]
    [[nodiscard]] Vector3 likelyTip(const TipContactPoint& main, const Vector3& tip,
                                    const Vector3& before) const noexcept;

    /// Gives the main point the attraction at a place of the apex.
    /// @param compliance of the lever along the normal [m/N]
    void pull(std::span<TipContactPoint> points, const Vector3& tip, double compliance) noexcept;

private:
    const ProbeSystem& system_;
    bool attracts_;
    std::optional<BodyForce> force_;
    double error_ = 0.0;  ///< that its gradient may have [N]
};

}  // namespace asperity
