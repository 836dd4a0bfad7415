#pragma once

#include "core/contact/ContactLaw.h"
#include "core/contact/ContactState.h"
#include "core/contact/DmtLaw.h"
#include "core/contact/HertzLaw.h"
#include "core/contact/JkrLaw.h"
#include "core/contact/JoinedLaw.h"
#include "core/contact/Material.h"
#include "core/contact/MaugisLaw.h"
#include "core/contact/SplitLaw.h"

#include <variant>

namespace asperity {

/// Range of the cohesive stress that is taken where a scene names none, h0 = D0 (sqrt(10) - 1) [m].
/// Source: docs/physics.md 1, 3.4.
inline constexpr double kCohesiveRange = 0.35677581392798259e-9;

/// One contact law by name for one material pair, in SI units: constant after construction (about a
/// microsecond), no allocation, never throws after construction.
class ContactModel {
public:
    /// @param cohesiveStress sigma0 of the Maugis laws [Pa]; the split law has its own
    /// @throw Error when a parameter is outside its range, see ContactStatus
    ContactModel(ContactLaw law, const ContactPair& pair, double cohesiveStress);
    /// With the cohesive range kCohesiveRange. @throw Error as above
    ContactModel(ContactLaw law, const ContactPair& pair);

    /// The same law and materials under a tip of another effective radius [m], which counts as the
    /// nearest end of its range where it lies outside.
    [[nodiscard]] ContactModel withTipRadius(double tipRadius) const noexcept;

    /// Stable equilibrium at `approach` = indentation + compliance x force [m], the approach of the
    /// undeflected tip; `compliance` is the lever's along the normal [m/N] (0: displacement
    /// control). `memory` is of the previous state: its branch is kept while it is stable.
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           const ContactMemory& memory) const noexcept;

    /// Approach of the undeflected tip at which it snaps in, for a compliance within its range [m];
    /// 0 without adhesion.
    [[nodiscard]] double jumpInApproach(double compliance) const noexcept;
    /// Approach of the undeflected tip at which it pulls off [m]; 0 without adhesion.
    [[nodiscard]] double pullOffApproach(double compliance) const noexcept;

    [[nodiscard]] ContactLaw law() const noexcept { return law_; }
    [[nodiscard]] const ContactPair& pair() const noexcept { return pair_; }
    /// sigma0 as the law uses it [Pa]; 0 where it has no cohesive zone.
    [[nodiscard]] double cohesiveStress() const noexcept;
    /// Transition parameter of the cohesive zone; 0 where the law has none.
    [[nodiscard]] double lambda() const noexcept;

    using Split = JoinedLaw<WithTail, SplitLaw>;
    /// The split law where it is the one; null otherwise.
    [[nodiscard]] const Split* split() const noexcept { return std::get_if<Split>(&joined_); }

private:
    template <class Bonded>
    using Sudden = JoinedLaw<NoTail, Bonded>;
    using Joined =
        std::variant<Sudden<HertzLaw>, Sudden<DmtLaw>, Sudden<JkrLaw>, Sudden<MaugisLaw>, Split>;

    struct Unchecked {};
    ContactModel(Unchecked, ContactLaw law, const ContactPair& pair,
                 double cohesiveStress) noexcept;

    [[nodiscard]] static Joined joinedLaw(ContactLaw law, const ContactPair& pair,
                                          double cohesiveStress) noexcept;

    ContactLaw law_;
    ContactPair pair_;
    double givenStress_;  ///< [Pa]
    Joined joined_;
};

}  // namespace asperity
