// What ContactModel holds beside its parameters. For its sources alone: who computes contacts knows
// no single law, and a new one is compiled into these.

#pragma once

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
                 Sudden<SneddonLaw>, Sudden<SphereJkrLaw>, Sudden<SphereMaugisLaw>, Sudden<FilmLaw>,
                 Tailed<SplitLaw>, Tailed<SphereSplitLaw>>
        law;
};

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
