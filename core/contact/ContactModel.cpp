#include "core/contact/ContactModel.h"

#include "core/Error.h"
#include "core/contact/OnAlternative.h"
#include "core/contact/Within.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace asperity {

namespace {

/// sigma0 of the range that is taken where a scene names none [Pa]; 0, without overflow, where the
/// work of adhesion is none that a law takes.
double defaultStress(const ContactPair& pair) {
    return isWithin(pair.workOfAdhesion, 0.0, 1e3) ? pair.workOfAdhesion / kCohesiveRange : 0.0;
}

void checkMeniscus(const Meniscus& meniscus) {
    const bool ranged = meniscus.range == 0.0 || isWithin(meniscus.range, 1e-12, 1e-6);
    if (!ranged || !isWithin(meniscus.surfaceTension, 0.0, 10.0) ||
        !isWithin(meniscus.contactAngle, 0.0, std::numbers::pi / 2.0)) {
        throw Error("contact: a meniscus needs a surface tension of 0 to 10 N/m, a range of 0 or "
                    "1e-12 to 1e-6 m and a contact angle of 0 to a right angle");
    }
}

void checkFilm(ContactLaw law, double thickness) {
    const bool halfSpace = thickness == 0.0;
    if (!halfSpace && !isWithin(thickness, 1e-12, 1.0)) {
        throw Error("contact: the film's thickness must lie between 1e-12 and 1 m");
    }
    if (halfSpace && law == ContactLaw::HertzFilm) {
        throw Error("contact: the law hertz_film needs the film's thickness");
    }
}

/// A table for effective radii from a tenth to ten times the tip's, and, since the split law gives
/// its zone more of the adhesion where the tail snaps, for both its shares. Contacts wider than two
/// tip radii are left to the exact law.
std::shared_ptr<const MaugisTable> tableFor(ContactLaw law, const ContactPair& pair,
                                            const ContactOptions& options) {
    const bool cohesive = law == ContactLaw::Maugis || law == ContactLaw::Split;
    if (options.solver != SolverTier::Table || !cohesive ||
        pair.workOfAdhesion < kSmallestAdhesion) {
        return nullptr;
    }
    constexpr double kRadiusRange = 10.0;
    constexpr double kShareRange = 0.93;  // of lambda, by less work of adhesion
    const MaugisUnits units = maugisUnits(pair);
    const double stress =
        law == ContactLaw::Split ? pair.workOfAdhesion / kCohesiveRange : options.cohesiveStress;
    const double lambda = transitionParameter(units, stress);
    const double spread = std::cbrt(kRadiusRange);
    const double low = lambda / spread * (law == ContactLaw::Split ? kShareRange : 1.0);
    const double high = lambda * spread;
    if (low < MaugisTableRange::kSmallestLambda || low > MaugisTableRange::kLargestLambda) {
        return nullptr;
    }
    const double deepest =
        std::min(MaugisTableRange::kDeepest, 2.0 * pair.tipRadius / units.indentation);
    return std::make_shared<const MaugisTable>(MaugisTableRange{low, high, deepest});
}

}  // namespace

ContactModel::ContactModel(ContactLaw law, const ContactPair& pair, const ContactOptions& options)
    : ContactModel(checked(law, pair, options)) {}

ContactModel::ContactModel(const Checked& given) noexcept
    : given_(given), joined_(joinedLaw(given)) {}

ContactModel::Checked ContactModel::checked(ContactLaw law, const ContactPair& pair,
                                            ContactOptions options) {
    if (options.cohesiveStress == 0.0) {
        options.cohesiveStress = defaultStress(pair);
    }
    requirePair(pair, options.cohesiveStress);
    checkFilm(law, options.filmThickness);
    checkMeniscus(options.meniscus);
    return {law, pair, options, tableFor(law, pair, options)};
}

ContactModel::Joined ContactModel::joinedLaw(const Checked& given) noexcept {
    const ContactPair& pair = given.pair;
    const auto splitLaw = [](const ContactPair& of, const MaugisSolver& by) {
        const AttractiveTail tail = splitTail(of);
        return Split(WithTail(tail), SplitLaw(of, tail, by));
    };
    const auto sudden = [](const auto& bonded) {
        return Joined(JoinedLaw(NoTail(bonded.onset()), bonded));
    };
    if (given.law == ContactLaw::HertzFilm) {
        return sudden(FilmLaw(pair, given.options.filmThickness));
    }
    const MaugisSolver solver{given.options.solver, given.table};
    const bool adhesive = pair.workOfAdhesion >= kSmallestAdhesion;
    if (given.law == ContactLaw::Sneddon || (isSphere(given.law) && !adhesive)) {
        return sudden(SneddonLaw(pair));
    }
    if (!adhesive) {
        return sudden(HertzLaw(pair));
    }
    switch (given.law) {
    case ContactLaw::Dmt:
        return sudden(DmtLaw(pair));
    case ContactLaw::Jkr:
        return sudden(JkrLaw(pair));
    case ContactLaw::Maugis:
        return sudden(MaugisLaw(pair, given.options.cohesiveStress, solver));
    case ContactLaw::SphereJkr:
        return sudden(SphereJkrLaw(pair));
    case ContactLaw::SphereMaugis:
        return sudden(SphereMaugisLaw(pair, given.options.cohesiveStress));
    case ContactLaw::Split:
        return splitLaw(pair, solver);
    default:
        return sudden(HertzLaw(pair));
    }
}

ContactModel ContactModel::withTipRadius(double tipRadius) const noexcept {
    Checked given = given_;
    if (!std::isnan(tipRadius)) {
        given.pair.tipRadius = std::clamp(tipRadius, kSmallestTipRadius, kLargestTipRadius);
    }
    return ContactModel(given);
}

ContactState ContactModel::equilibrium(double approach, double compliance,
                                       const ContactMemory& memory) const noexcept {
    const ContactStatus status = checkRequest(approach, compliance);
    if (status != ContactStatus::Solved) {
        return {.coordinate = memory.coordinate, .branch = memory.branch, .status = status};
    }
    const double soft = nearestCompliance(compliance);
    return given_.options.meniscus.present() ? wettedEquilibrium(approach, soft, memory)
                                             : bare(approach, soft, memory);
}

ContactState ContactModel::bare(double approach, double compliance,
                                const ContactMemory& memory) const noexcept {
    return onAlternative(
        [&](const auto& joined) { return joined.equilibrium(approach, compliance, memory); },
        joined_);
}

double ContactModel::jumpInApproach(double compliance) const noexcept {
    const double soft = nearestCompliance(compliance);
    if (given_.options.meniscus.present()) {
        return wettedEnd(soft).approach;
    }
    return onAlternative([&](const auto& joined) { return joined.jumpInApproach(soft); }, joined_);
}

double ContactModel::pullOffApproach(double compliance) const noexcept {
    const double soft = nearestCompliance(compliance);
    const Meniscus& meniscus = given_.options.meniscus;
    const double pull = meniscus.present() ? meniscus.pull(given_.pair.tipRadius) : 0.0;
    return onAlternative([&](const auto& joined) { return joined.pullOffApproach(soft); },
                         joined_) -
           (soft * pull);
}

ContactState ContactModel::lastFar(double compliance) const noexcept {
    const double soft = nearestCompliance(compliance);
    if (given_.options.meniscus.present()) {
        return equilibrium(wettedEnd(soft).approach, soft, {});
    }
    return onAlternative([&](const auto& joined) { return joined.lastFar(soft); }, joined_);
}

ContactState ContactModel::lastBonded(double compliance) const noexcept {
    const double soft = nearestCompliance(compliance);
    const ContactState last =
        onAlternative([&](const auto& joined) { return joined.lastBonded(soft); }, joined_);
    return given_.options.meniscus.present() ? wetted(last) : last;
}

double ContactModel::cohesiveStress() const noexcept {
    return onAlternative(
        [](const auto& joined) {
            if constexpr (requires { joined.bonded().cohesiveStress(); }) {
                return joined.bonded().cohesiveStress();
            } else {
                return 0.0;
            }
        },
        joined_);
}

double ContactModel::lambda() const noexcept {
    return onAlternative(
        [](const auto& joined) {
            if constexpr (requires { joined.bonded().lambda(); }) {
                return joined.bonded().lambda();
            } else {
                return 0.0;
            }
        },
        joined_);
}

}  // namespace asperity
