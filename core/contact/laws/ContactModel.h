#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/ContactOptions.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

namespace asperity {

/// A force on the tip beside that of the contact law, as a straight line of the indentation: the
/// attraction by the sample around the contact, see BodySum.h.
///
/// On a lever it is what a meniscus is: each equilibrium is one of the bare law on a lever that is
/// moved, and softened or stiffened. With a(d) = d + c F(d) the law's approach at an indentation d,
/// F + p + g d instead of F is a law's approach (a - c p) / (1 + c g) on a lever of compliance
/// c / (1 + c g), and energies at a given approach differ by the same. Source: docs/theory.md 3.8.
struct BodyPull {
    double force = 0.0;  ///< p, at an indentation of 0, > 0 repulsive [N]
    double slope = 0.0;  ///< g, d(force)/d(indentation) [N/m]; for an approach 1 + c g must be > 0

    bool operator==(const BodyPull&) const = default;

    [[nodiscard]] bool present() const noexcept { return force != 0.0 || slope != 0.0; }
    [[nodiscard]] double at(double indentation) const noexcept {  ///< [N]
        return force + (slope * indentation);
    }
    /// Compliance of the lever that the bare law is asked for [m/N]; the softest where this force
    /// outruns the lever. @param compliance its own
    [[nodiscard]] double compliance(double compliance) const noexcept {
        const double left = 1.0 + (compliance * slope);
        return left > 0.0 ? compliance / left : std::numeric_limits<double>::infinity();
    }
    /// Approach that the bare law is asked for [m], and back. @param compliance of the lever itself
    [[nodiscard]] double bareApproach(double approach, double compliance) const noexcept {
        return (approach - (compliance * force)) / (1.0 + (compliance * slope));
    }
    [[nodiscard]] double approach(double bareApproach, double compliance) const noexcept {
        return (bareApproach * (1.0 + (compliance * slope))) + (compliance * force);
    }
};

class AttractiveTail;
class FilmTable;
class MaugisTable;
struct AdhesionSplit;

/// One contact law by name for one material pair, in SI units: constant after construction (about a
/// microsecond; the first of a film some 40 ms, see sharedFilmTable(), of a table some 0.2 s, see
/// sharedMaugisTable()), no allocation, never throws after construction.
class ContactModel {
public:
    /// @throw Error when a parameter is outside its range, see ContactStatus, or the film's law
    ///        has no film
    ContactModel(ContactLaw law, const ContactPair& pair, const ContactOptions& options = {});

    /// The same law and materials under a tip of another effective radius [m], which counts as the
    /// nearest end of its range where it lies outside, as its own where it is no number. A table
    /// covers a tenth of the first radius to ten times that; beyond, the exact law answers.
    [[nodiscard]] ContactModel withTipRadius(double tipRadius) const noexcept;

    /// The same law for another pair that the constructor would take, its radius as in
    /// withTipRadius(). The range of the cohesive zone stays, its stress goes with the adhesion.
    [[nodiscard]] ContactModel withPair(const ContactPair& pair) const noexcept;

    /// Adds a force beside the law's to every force below, instead of the one before. Of a model
    /// that is made from this one there is none again.
    void setBodyPull(const BodyPull& pull) noexcept { body_ = pull; }
    [[nodiscard]] const BodyPull& bodyPull() const noexcept { return body_; }

    /// Stable equilibrium at `approach` = indentation + compliance x force [m], the approach of the
    /// undeflected tip; `compliance` is the lever's along the normal [m/N] (0: displacement
    /// control). `memory` is of the previous state: its branch is kept while it is stable.
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           const ContactMemory& memory) const noexcept;

    /// Approach of the undeflected tip at which it snaps in, [m]; 0 without adhesion. Here and
    /// below a compliance outside its range counts as nearestCompliance().
    [[nodiscard]] double jumpInApproach(double compliance) const noexcept;
    /// Approach of the undeflected tip at which it pulls off [m]; 0 without adhesion.
    [[nodiscard]] double pullOffApproach(double compliance) const noexcept;

    /// Gap across which separate bodies act on each other [m]: up to it the tip may snap in, the
    /// meniscus holds or the van der Waals tail pulls with a four-hundredth of the largest pull of
    /// a rigid tip, 2 pi w R, or more. 0 without attraction.
    [[nodiscard]] double attractionRange() const noexcept;

    /// The last stable state on the way in, before snap-in.
    [[nodiscard]] ContactState lastFar(double compliance) const noexcept;
    /// The last stable bonded state on the way out.
    [[nodiscard]] ContactState lastBonded(double compliance) const noexcept;

    [[nodiscard]] ContactLaw law() const noexcept { return given_.law; }
    [[nodiscard]] const ContactPair& pair() const noexcept { return given_.pair; }
    /// sigma0 as the law uses it [Pa]; 0 where it has no cohesive zone.
    [[nodiscard]] double cohesiveStress() const noexcept;
    /// Range h0 of the pair's attraction across a gap [m]: that of the law's cohesive zone, or,
    /// where the law has none, that of the stress asked for; 0 without adhesion.
    [[nodiscard]] double cohesiveRange() const noexcept;
    /// Pull of the meniscus on bonded bodies [N], >= 0; 0 without one.
    [[nodiscard]] double meniscusPull() const noexcept;
    /// Transition parameter of the cohesive zone; 0 where the law has none.
    [[nodiscard]] double lambda() const noexcept;

    /// The table that states come from; null where the setting or the law has none.
    [[nodiscard]] const MaugisTable* table() const noexcept { return given_.table.get(); }

    /// Effect of a film of the sample on a contact, whatever the law; null on a half-space.
    [[nodiscard]] const FilmTable* film() const noexcept { return given_.film.get(); }
    /// Contact radius beyond which the law does not hold on the sample's film [m]: where a law on a
    /// half-space gives 1 / 1.05 of its force, where `hertz_film` is no longer held to a reference;
    /// infinite on a half-space.
    [[nodiscard]] double widestFilmContact() const noexcept;
    /// Half angle of the cone that the law takes the tip's sphere to go on as [rad]; 0: none.
    [[nodiscard]] double coneHalfAngle() const noexcept {
        return leavesOutCone(given_.law) ? 0.0 : given_.options.coneHalfAngle;
    }
    /// Work of adhesion while a contact shrinks over that while it grows; 1: one work for both.
    [[nodiscard]] double adhesionRatio() const noexcept { return given_.options.adhesionRatio; }
    /// The law by which the contact grows, and that by which it shrinks; each has one work.
    [[nodiscard]] ContactModel growing() const noexcept { return withWork(1.0); }
    [[nodiscard]] ContactModel shrinking() const noexcept { return withWork(adhesionRatio()); }

    /// Thickness of the sample's film [m]; 0: a half-space.
    [[nodiscard]] double filmThickness() const noexcept { return given_.options.filmThickness; }

    /// The van der Waals tail of the split laws; null where the law has none.
    [[nodiscard]] const AttractiveTail* tail() const noexcept;
    /// Shares of tail and cohesive zone of the split laws; null where the law has no tail.
    [[nodiscard]] const AdhesionSplit* split() const noexcept;

private:
    friend class WettedContact;

    struct Checked {
        ContactLaw law;
        ContactPair pair;
        ContactOptions options;
        std::shared_ptr<const MaugisTable> table;
        std::shared_ptr<const FilmTable> film;
    };
    explicit ContactModel(const Checked& given) noexcept;

    [[nodiscard]] bool hasTwoWorks() const noexcept { return adhesionRatio() > 1.0; }
    /// The same law with one work of adhesion. @param factor of the work
    [[nodiscard]] ContactModel withWork(double factor) const noexcept;

    [[nodiscard]] static Checked checked(ContactLaw law, const ContactPair& pair,
                                         ContactOptions options);
    /// The law joined to its tail, see JoinedLaw.h: this header does not know the laws.
    struct Joined;
    [[nodiscard]] static Joined joinedLaw(const Checked& given) noexcept;
    [[nodiscard]] const Joined& joined() const noexcept;
    /// Calls a visitor with the JoinedLaw.
    template <class Visitor>
    auto onJoined(const Visitor& visitor) const noexcept;

    [[nodiscard]] ContactState bare(double approach, double compliance,
                                    const ContactMemory& memory) const noexcept;
    // These three are of law and meniscus, without the body's pull. The compliance is in range.
    [[nodiscard]] ContactState wetEquilibrium(double approach, double compliance,
                                              const ContactMemory& memory) const noexcept;
    [[nodiscard]] double wetJumpInApproach(double compliance) const noexcept;
    [[nodiscard]] double wetPullOffApproach(double compliance) const noexcept;
    [[nodiscard]] ContactState wetLastBonded(double compliance) const noexcept;
    [[nodiscard]] ContactState withBodyPull(ContactState state) const noexcept;
    /// Compliance that law and meniscus are asked for [m/N].
    [[nodiscard]] double wetCompliance(double compliance) const noexcept;

    static constexpr std::size_t kJoinedSize = 640;  ///< [bytes]

    Checked given_;
    BodyPull body_;
    alignas(double) std::array<std::byte, kJoinedSize> joined_;
};

/// Returns whether a contact is too wide for linear elasticity to be credible, above 0.3 of the
/// effective radius of tip and sample, whichever law. Source: docs/theory.md 2.10.
[[nodiscard]] bool isLargeContact(double contactRadius, double effectiveRadius) noexcept;

/// Reason for a contact law.
enum class LawReason : std::uint8_t {
    AskedFor,
    TermsOfScene,  ///< of the force, on which the scene decides one by one
    NoAdhesion,
    FilmWithoutAdhesion,
    TwoWorks,        ///< of adhesion, which need a contact with an edge
    NoAdhesionCone,  ///< and a tip whose cone the load may press in
    NarrowContact,   ///< without load: the paraboloid holds
    WideContact,     ///< without load: only the exact sphere does
};

/// A contact law and why it was taken.
struct LawChoice {
    ContactLaw law = ContactLaw::Split;
    LawReason reason = LawReason::AskedFor;
    double unloadedRatio = 0.0;  ///< contact radius over tip radius, where the width decided
};

/// The law that was asked for, or where none was (`auto`): Maugis-Dugdale, which is exact from DMT
/// to JKR, with its van der Waals tail; the same on the exact sphere where the contact is wider
/// than 0.3 R already without load. Without adhesion Hertz, on a film that of the film; Sneddon's
/// under a tip with a cone, since a paraboloid has none. Source:
/// docs/theory.md 2.9, 2.10, 4.4, 4.8.
/// @param filmThickness of the sample [m]; 0: a half-space
/// @param coneHalfAngle of the tip [rad]; 0: no cone
/// @throw Error where none was asked for and the pair is outside the laws' range, see ContactStatus
[[nodiscard]] LawChoice chooseLaw(std::optional<ContactLaw> wanted, const ContactPair& pair,
                                  double filmThickness = 0.0, double coneHalfAngle = 0.0);

}  // namespace asperity
