#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/Material.h"
#include "core/contact/SplitLaw.h"

#include <cstdint>
#include <optional>

namespace asperity {

enum class ContactLaw : std::uint8_t {
    Hertz,  ///< elastic, no adhesion
    Split,  ///< van der Waals tail joined to Maugis-Dugdale (the default)
};

/// Normal contact law of one material pair in SI units: constant after construction (about a
/// microsecond), no allocation, never throws after construction.
/// Source: docs/physics.md 2.3-2.5, 3.1, 3.4, 7.1.
class ContactModel {
public:
    /// @throw Error when a parameter is outside its range: radius 1e-12 .. 1 m, reduced modulus
    ///        1 .. 1e15 Pa, work of adhesion 0 .. 1e3 J/m^2 (below 1e-12 it counts as 0)
    ContactModel(ContactLaw law, const ContactPair& pair);

    /// Stable equilibrium at `approach` = indentation + compliance x force [m], the approach of the
    /// undeflected tip; `compliance` is the lever's along the normal [m/N] (0: displacement
    /// control). `branch` is the branch of the previous state: it is kept while it is stable. An
    /// approach beyond +-1e3 m or a compliance outside 0 .. 1e6 m/N, or not finite, is not solved.
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           ContactBranch branch) const noexcept;

    /// Approach of the undeflected tip at which it snaps in, for a compliance in the range above
    /// [m]; 0 without adhesion.
    [[nodiscard]] double jumpInApproach(double compliance) const noexcept;
    /// Approach of the undeflected tip at which it pulls off [m]; 0 without adhesion.
    [[nodiscard]] double pullOffApproach(double compliance) const noexcept;

    [[nodiscard]] ContactLaw law() const noexcept { return law_; }
    [[nodiscard]] const ContactPair& pair() const noexcept { return pair_; }
    /// The adhesive part; none for Hertz or without adhesion.
    [[nodiscard]] const std::optional<SplitLaw>& adhesion() const noexcept { return adhesion_; }

private:
    [[nodiscard]] ContactState hertz(double approach, double compliance) const noexcept;

    ContactLaw law_;
    ContactPair pair_;
    std::optional<SplitLaw> adhesion_;
};

}  // namespace asperity
