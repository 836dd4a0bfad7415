#include "core/contact/ContactModel.h"

#include "core/Error.h"

#include <algorithm>
#include <string>

namespace asperity {

namespace {

const char* expectation(ContactStatus status) {
    switch (status) {
    case ContactStatus::TipRadiusOutOfRange:
        return "the tip radius must lie between 1e-12 and 1 m";
    case ContactStatus::ModulusOutOfRange:
        return "the reduced modulus must lie between 0.1 and 1e15 Pa";
    case ContactStatus::AdhesionOutOfRange:
        return "the work of adhesion must lie between 0 and 1000 J/m^2";
    default:
        return "the range of the cohesive stress, w / sigma0, must lie between 1e-15 and 1 m";
    }
}

ContactPair checked(const ContactPair& pair, double cohesiveStress) {
    const ContactStatus status = checkPair(pair, cohesiveStress);
    if (status != ContactStatus::Solved) {
        throw Error(std::string("contact: ") + expectation(status));
    }
    return pair;
}

}  // namespace

ContactModel::ContactModel(ContactLaw law, const ContactPair& pair, double cohesiveStress)
    : ContactModel(Unchecked{}, law, checked(pair, cohesiveStress), cohesiveStress) {}

ContactModel::ContactModel(ContactLaw law, const ContactPair& pair)
    : ContactModel(law, pair, pair.workOfAdhesion / kCohesiveRange) {}

ContactModel::ContactModel(Unchecked /*tag*/, ContactLaw law, const ContactPair& pair,
                           double cohesiveStress) noexcept
    : law_(law)
    , pair_(pair)
    , givenStress_(cohesiveStress)
    , joined_(joinedLaw(law, pair, cohesiveStress)) {}

ContactModel::Joined ContactModel::joinedLaw(ContactLaw law, const ContactPair& pair,
                                             double cohesiveStress) noexcept {
    const auto sudden = [](const auto& bonded) {
        return Joined(JoinedLaw(NoTail(bonded.onset()), bonded));
    };
    if (pair.workOfAdhesion < kSmallestAdhesion) {
        return sudden(HertzLaw(pair));
    }
    switch (law) {
    case ContactLaw::Dmt:
        return sudden(DmtLaw(pair));
    case ContactLaw::Jkr:
        return sudden(JkrLaw(pair));
    case ContactLaw::Maugis:
        return sudden(MaugisLaw(pair, cohesiveStress));
    case ContactLaw::Split:
        return Split(WithTail(splitTail(pair)), SplitLaw(pair));
    default:
        return sudden(HertzLaw(pair));
    }
}

ContactModel ContactModel::withTipRadius(double tipRadius) const noexcept {
    ContactPair pair = pair_;
    pair.tipRadius = std::clamp(tipRadius, kSmallestTipRadius, kLargestTipRadius);
    return {Unchecked{}, law_, pair, givenStress_};
}

ContactState ContactModel::equilibrium(double approach, double compliance,
                                       const ContactMemory& memory) const noexcept {
    const ContactStatus status = checkRequest(approach, compliance);
    if (status != ContactStatus::Solved) {
        return {.coordinate = memory.coordinate, .branch = memory.branch, .status = status};
    }
    return std::visit(
        [&](const auto& joined) { return joined.equilibrium(approach, compliance, memory); },
        joined_);
}

double ContactModel::jumpInApproach(double compliance) const noexcept {
    return std::visit([&](const auto& joined) { return joined.jumpInApproach(compliance); },
                      joined_);
}

double ContactModel::pullOffApproach(double compliance) const noexcept {
    return std::visit([&](const auto& joined) { return joined.pullOffApproach(compliance); },
                      joined_);
}

double ContactModel::cohesiveStress() const noexcept {
    return std::visit(
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
    return std::visit(
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
