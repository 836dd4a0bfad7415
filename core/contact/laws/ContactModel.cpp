#include "core/contact/laws/ContactModel.h"

#include "core/Error.h"
#include "core/contact/Within.h"
#include "core/contact/laws/JoinedLaw.h"
#include "core/contact/laws/SplitLaw.h"
#include "core/contact/laws/TwoWorkContact.h"
#include "core/contact/laws/WettedContact.h"
#include "core/contact/maugis/MaugisDugdale.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>

namespace asperity {

namespace {

/// sigma0 of the range that is taken where a scene names none [Pa]; 0, without overflow, where the
/// work of adhesion is none that a law accepts.
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

/// Null on a half-space.
std::shared_ptr<const FilmTable> filmFor(ContactLaw law, const ContactOptions& options) {
    const ContactStatus status = checkFilm(options.filmThickness, options.film.poissonRatio);
    if (status != ContactStatus::Solved) {
        throw Error(std::string("contact: ") + nameOf(status));
    }
    if (options.filmThickness > 0.0) {
        return sharedFilmTable(options.film);
    }
    if (isFilm(law)) {
        throw Error("contact: the law hertz_film needs the film's thickness");
    }
    return nullptr;
}

/// A table for effective radii from a tenth to ten times the tip's, and, since the split law gives
/// its zone more of the adhesion where the tail snaps, for both its shares. Contacts wider than two
/// tip radii are left to the exact law.
std::shared_ptr<const MaugisTable> tableFor(ContactLaw law, const ContactPair& pair,
                                            const ContactOptions& options) {
    const bool cohesive = traitsOf(law).table;
    if (options.solver != SolverSetting::Table || !cohesive || pair.workOfAdhesion < kMinAdhesion) {
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
    if (low < MaugisTableRange::kMinLambda || low > MaugisTableRange::kMaxLambda) {
        return nullptr;
    }
    const double deepest =
        std::min(MaugisTableRange::kMaxIndentation, 2.0 * pair.tipRadius / units.indentation);
    return sharedMaugisTable({low, high, deepest});
}

constexpr double kMaxAdhesionRatio = 1e6;
constexpr double kLargeContact = 0.3;  // a/R beyond which the paraboloid errs by some 3 %

/// Contact radius over tip radius without load, by Maugis-Dugdale on the paraboloid.
double unloadedRatio(const ContactPair& pair) {
    const MaugisUnits units = maugisUnits(pair);
    const MaugisLaw law(pair, pair.workOfAdhesion / kCohesiveRange);
    const auto point = MaugisDugdale(law.lambda()).stable(MaugisControl::load(), 0.0);
    return point ? point->contactRadius * units.radius / pair.tipRadius : 0.0;
}

}  // namespace

ContactModel::ContactModel(ContactLaw law, const ContactPair& pair, const ContactOptions& options)
    : ContactModel(checked(law, pair, options)) {}

ContactModel::ContactModel(const Checked& given) noexcept : given_(given) {
    new (joined_.data()) Joined(joinedLaw(given));
}

ContactModel::Checked ContactModel::checked(ContactLaw law, const ContactPair& pair,
                                            ContactOptions options) {
    if (options.cohesiveStress == 0.0) {
        options.cohesiveStress = defaultStress(pair);
    }
    requirePair(pair, options.cohesiveStress);
    checkMeniscus(options.meniscus);
    if (!(options.adhesionRatio >= 1.0) || options.adhesionRatio > kMaxAdhesionRatio) {
        throw Error("contact: the work of adhesion on retract must be 1 to 1e6 times that on "
                    "approach");
    }
    if (!isJkr(law) || pair.workOfAdhesion < kMinAdhesion) {
        options.adhesionRatio = 1.0;
    } else if (options.adhesionRatio > 1.0 && options.meniscus.present()) {
        throw Error("contact: two works of adhesion do not go with a meniscus");
    }
    const ContactStatus cone = checkCone(options.coneHalfAngle);
    if (cone != ContactStatus::Solved) {
        throw Error(std::string("contact: ") + nameOf(cone));
    }
    return {law, pair, options, tableFor(law, pair, options), filmFor(law, options)};
}

ContactModel ContactModel::withTipRadius(double tipRadius) const noexcept {
    ContactPair pair = given_.pair;
    pair.tipRadius = tipRadius;
    return withPair(pair);
}

ContactModel ContactModel::withPair(const ContactPair& pair) const noexcept {
    if (pair == given_.pair) {
        return *this;  // a law may take long to make, see ConeMaugisLaw
    }
    Checked given = given_;
    given.pair = pair;
    given.pair.tipRadius = std::isnan(pair.tipRadius)
                               ? given_.pair.tipRadius
                               : std::clamp(pair.tipRadius, kMinTipRadius, kMaxTipRadius);
    const double adhesion = given_.pair.workOfAdhesion;
    if (pair.workOfAdhesion != adhesion) {
        given.options.cohesiveStress =
            adhesion >= kMinAdhesion
                ? given_.options.cohesiveStress * (pair.workOfAdhesion / adhesion)
                : defaultStress(pair);
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
    if (!body_.present()) {
        return wetEquilibrium(approach, soft, memory);
    }
    return withBodyPull(
        wetEquilibrium(body_.bareApproach(approach, soft), wetCompliance(soft), memory));
}

ContactState ContactModel::withBodyPull(ContactState state) const noexcept {
    state.force += body_.at(state.indentation);
    state.stiffness += body_.slope;
    return state;
}

double ContactModel::wetCompliance(double compliance) const noexcept {
    return nearestCompliance(body_.compliance(compliance));
}

ContactState ContactModel::wetEquilibrium(double approach, double compliance,
                                          const ContactMemory& memory) const noexcept {
    return given_.options.meniscus.present()
               ? WettedContact(*this).equilibrium(approach, compliance, memory)
               : bare(approach, compliance, memory);
}

ContactModel ContactModel::withWork(double factor) const noexcept {
    if (!hasTwoWorks()) {
        return *this;
    }
    Checked given = given_;
    given.options.adhesionRatio = 1.0;
    given.pair.workOfAdhesion *= factor;
    return ContactModel(given);
}

ContactState ContactModel::bare(double approach, double compliance,
                                const ContactMemory& memory) const noexcept {
    if (hasTwoWorks()) {
        return TwoWorkContact(*this).equilibrium(approach, compliance, memory);
    }
    return onJoined(
        [&](const auto& joined) { return joined.equilibrium(approach, compliance, memory); });
}

double ContactModel::wetJumpInApproach(double compliance) const noexcept {
    if (given_.options.meniscus.present()) {
        return WettedContact(*this).jumpInApproach(compliance);
    }
    return onJoined([&](const auto& joined) { return joined.jumpInApproach(compliance); });
}

double ContactModel::wetPullOffApproach(double compliance) const noexcept {
    if (hasTwoWorks()) {
        return shrinking().wetPullOffApproach(compliance);
    }
    return onJoined([&](const auto& joined) { return joined.pullOffApproach(compliance); }) -
           (compliance * meniscusPull());
}

double ContactModel::jumpInApproach(double compliance) const noexcept {
    const double soft = nearestCompliance(compliance);
    return body_.approach(wetJumpInApproach(wetCompliance(soft)), soft);
}

double ContactModel::pullOffApproach(double compliance) const noexcept {
    const double soft = nearestCompliance(compliance);
    return body_.approach(wetPullOffApproach(wetCompliance(soft)), soft);
}

double ContactModel::attractionRange() const noexcept {
    // Four contact points just out of range pull with a hundredth of the strongest pull together.
    constexpr double kFaint = 1.0 / 400.0;
    double range = std::max(-wetJumpInApproach(0.0), 0.0);
    if (given_.options.meniscus.present()) {
        range = std::max(range, given_.options.meniscus.range);
    }
    if (const AttractiveTail* const pull = tail()) {
        const double strongest =
            2.0 * std::numbers::pi * given_.pair.workOfAdhesion * given_.pair.tipRadius;
        const double separation = pull->attraction().separationAt(-kFaint * strongest);
        range = std::max(range, separation - kContactSeparation);
    }
    return range;
}

ContactState ContactModel::lastFar(double compliance) const noexcept {
    const double soft = wetCompliance(nearestCompliance(compliance));
    if (given_.options.meniscus.present()) {
        return withBodyPull(wetEquilibrium(wetJumpInApproach(soft), soft, {}));
    }
    return withBodyPull(onJoined([&](const auto& joined) { return joined.lastFar(soft); }));
}

ContactState ContactModel::wetLastBonded(double compliance) const noexcept {
    if (hasTwoWorks()) {
        return shrinking().wetLastBonded(compliance);
    }
    const ContactState last =
        onJoined([&](const auto& joined) { return joined.lastBonded(compliance); });
    return given_.options.meniscus.present() ? WettedContact(*this).wetted(last) : last;
}

ContactState ContactModel::lastBonded(double compliance) const noexcept {
    return withBodyPull(wetLastBonded(wetCompliance(nearestCompliance(compliance))));
}

double ContactModel::widestFilmContact() const noexcept {
    if (film() == nullptr) {
        return std::numeric_limits<double>::infinity();
    }
    return filmThickness() * (isFilm(law()) ? kMaxFilmContact : film()->halfSpaceLimit());
}

double ContactModel::cohesiveStress() const noexcept {
    return onJoined([](const auto& joined) {
        if constexpr (requires { joined.bonded().cohesiveStress(); }) {
            return joined.bonded().cohesiveStress();
        } else {
            return 0.0;
        }
    });
}

double ContactModel::cohesiveRange() const noexcept {
    const double work = given_.pair.workOfAdhesion;
    if (work < kMinAdhesion) {
        return 0.0;
    }
    const AdhesionSplit* shares = split();
    return shares != nullptr ? shares->cohesiveWork / shares->cohesiveStress
                             : work / given_.options.cohesiveStress;
}

double ContactModel::meniscusPull() const noexcept {
    const Meniscus& meniscus = given_.options.meniscus;
    return meniscus.present() ? meniscus.pull(given_.pair.tipRadius) : 0.0;
}

const AttractiveTail* ContactModel::tail() const noexcept {
    return onJoined([](const auto& joined) -> const AttractiveTail* {
        if constexpr (requires { joined.separate().tail(); }) {
            return &joined.separate().tail();
        } else {
            return nullptr;
        }
    });
}

const AdhesionSplit* ContactModel::split() const noexcept {
    return onJoined([](const auto& joined) -> const AdhesionSplit* {
        if constexpr (requires { joined.bonded().split(); }) {
            return &joined.bonded().split();
        } else {
            return nullptr;
        }
    });
}

double ContactModel::lambda() const noexcept {
    return onJoined([](const auto& joined) {
        if constexpr (requires { joined.bonded().lambda(); }) {
            return joined.bonded().lambda();
        } else {
            return 0.0;
        }
    });
}

bool isLargeContact(double contactRadius, double effectiveRadius) noexcept {
    return contactRadius > kLargeContact * effectiveRadius;
}

LawChoice chooseLaw(std::optional<ContactLaw> wanted, const ContactPair& pair, double filmThickness,
                    double coneHalfAngle) {
    if (wanted) {
        return {.law = *wanted, .reason = LawReason::AskedFor};
    }
    requirePair(pair, pair.workOfAdhesion);  // any stress will do to look at the pair
    if (pair.workOfAdhesion < kMinAdhesion) {
        if (filmThickness > 0.0) {
            return {ContactLaw::HertzFilm, LawReason::FilmWithoutAdhesion};
        }
        return coneHalfAngle > 0.0 ? LawChoice{ContactLaw::Sneddon, LawReason::NoAdhesionCone}
                                   : LawChoice{ContactLaw::Hertz, LawReason::NoAdhesion};
    }
    const double ratio = unloadedRatio(pair);
    return ratio > kLargeContact ? LawChoice{ContactLaw::SphereSplit, LawReason::WideContact, ratio}
                                 : LawChoice{ContactLaw::Split, LawReason::NarrowContact, ratio};
}

}  // namespace asperity
