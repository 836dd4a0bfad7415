// What ContactModel holds beside its parameters: the laws, and which one a name stands for. For its
// sources alone: who computes contacts knows no single law, and a new one is compiled into these.

#pragma once

#include "core/contact/laws/ConeMaugisLaw.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/DmtLaw.h"
#include "core/contact/laws/FilmLaw.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/JkrLaw.h"
#include "core/contact/laws/JoinedLaw.h"
#include "core/contact/laws/MaugisLaw.h"
#include "core/contact/laws/OnAlternative.h"
#include "core/contact/laws/SneddonLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "core/contact/laws/SplitLaw.h"

#include <new>
#include <type_traits>
#include <variant>

namespace asperity {

struct ContactModel::Joined {
    template <class Bonded>
    using Sudden = JoinedLaw<NoTail, Bonded>;
    template <class Bonded>
    using Tailed = JoinedLaw<WithTail, Bonded>;

    std::variant<Sudden<HertzLaw>, Sudden<DmtLaw>, Sudden<JkrLaw>, Sudden<MaugisLaw>,
                 Sudden<SneddonLaw>, Sudden<SphereJkrLaw>, Sudden<SphereMaugisLaw>,
                 Sudden<ConeMaugisLaw>, Sudden<FilmLaw>, Tailed<SplitLaw>, Tailed<SphereSplitLaw>,
                 Tailed<ConeSplitLaw>>
        law;
};

inline ContactModel::Joined ContactModel::joinedLaw(const Checked& given) noexcept {
    const ContactLaw law = given.law;
    const ContactPair& pair = given.pair;
    const ContactOptions& options = given.options;
    const double cone = options.coneHalfAngle;
    const auto sudden = [](const auto& bonded) {
        return Joined{JoinedLaw(NoTail(bonded.onset()), bonded)};
    };
    const auto tailed = [&given](const auto& bondedBehind) {
        const AttractiveTail tail = splitTail(given.pair);
        return Joined{JoinedLaw(WithTail(tail), bondedBehind(tail))};
    };
    const MaugisSolver solver{options.solver, given.table.get()};
    if (isAdhesive(law) && pair.workOfAdhesion < kMinAdhesion) {
        return isSphere(law) ? sudden(SneddonLaw(pair, cone)) : sudden(HertzLaw(pair));
    }
    switch (law) {  // no default: the compiler names a law that is missing here
    case ContactLaw::Hertz:
        break;
    case ContactLaw::Dmt:
        return sudden(DmtLaw(pair));
    case ContactLaw::Jkr:
        return sudden(JkrLaw(pair));
    case ContactLaw::Maugis:
        return sudden(MaugisLaw(pair, options.cohesiveStress, solver));
    case ContactLaw::Sneddon:
        return sudden(SneddonLaw(pair, cone));
    case ContactLaw::SphereJkr:
        return sudden(SphereJkrLaw(pair, cone));
    case ContactLaw::SphereMaugis:
        return cone > 0.0 ? sudden(ConeMaugisLaw(pair, options.cohesiveStress, cone))
                          : sudden(SphereMaugisLaw(pair, options.cohesiveStress));
    case ContactLaw::Split:
        return tailed([&](const AttractiveTail& tail) { return splitLaw(pair, tail, solver); });
    case ContactLaw::SphereSplit:
        return cone > 0.0
                   ? tailed(
                         [&](const AttractiveTail& tail) { return coneSplitLaw(pair, tail, cone); })
                   : tailed([&](const AttractiveTail& tail) { return sphereSplitLaw(pair, tail); });
    case ContactLaw::HertzFilm:
        return sudden(FilmLaw(pair, options.filmThickness, *given.film));
    }
    return sudden(HertzLaw(pair));
}

inline const ContactModel::Joined& ContactModel::joined() const noexcept {
    // A copy of the bytes is a copy of the law.
    static_assert(std::is_trivially_copyable_v<Joined>);
    static_assert(sizeof(Joined) <= kJoinedSize && alignof(Joined) <= alignof(double));
    return *std::launder(reinterpret_cast<const Joined*>(joined_.data()));
}

template <class Visitor>
auto ContactModel::onJoined(const Visitor& visitor) const noexcept {
    return onAlternative(visitor, joined().law);
}

}  // namespace asperity
