#pragma once

#include "core/contact/ContactState.h"
#include "core/contact/laws/AttractiveTail.h"
#include "core/contact/laws/ConeMaugisLaw.h"
#include "core/contact/laws/ContactLaw.h"
#include "core/contact/laws/ContactModel.h"
#include "core/contact/laws/FilmTable.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/contact/laws/SphereJkrLaw.h"
#include "core/contact/laws/SphereMaugisLaw.h"
#include "core/contact/laws/SplitLaw.h"

#include <algorithm>
#include <cstddef>
#include <new>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace asperity {

/// Separate bodies that do not attract each other until the bonded law begins to act.
class NoTail {
public:
    explicit NoTail(double onset) noexcept : onset_(onset) {}

    /// Largest approach at which the bodies stay separate [m].
    [[nodiscard]] double endApproach(double /*compliance*/) const noexcept { return onset_; }
    /// None beyond endApproach().
    [[nodiscard]] std::optional<ContactState> stable(double approach,
                                                     double compliance) const noexcept {
        return approach > onset_ ? std::nullopt : std::optional(state(approach, compliance));
    }
    [[nodiscard]] ContactState state(double approach, double /*compliance*/) const noexcept {
        return {.indentation = approach};
    }
    /// The state at endApproach().
    [[nodiscard]] ContactState last(double /*compliance*/) const noexcept {
        return {.indentation = onset_};
    }
    /// Work done on the bodies from infinite separation to this state [J].
    [[nodiscard]] static double energy(const ContactState& /*state*/) noexcept { return 0.0; }

private:
    double onset_;
};

/// Energy of a bent lever [J].
[[nodiscard]] inline double leverEnergy(double force, double compliance) noexcept {
    return 0.5 * compliance * force * force;
}

/// Separate bodies that attract each other by van der Waals forces.
class WithTail {
public:
    explicit WithTail(const AttractiveTail& tail) noexcept : tail_(tail) {}

    [[nodiscard]] const AttractiveTail& tail() const noexcept { return tail_; }

    [[nodiscard]] double endApproach(double compliance) const noexcept {
        return tail_.approach(tail_.endSeparation(compliance), compliance);
    }
    /// None beyond endApproach().
    [[nodiscard]] std::optional<ContactState> stable(double approach,
                                                     double compliance) const noexcept {
        const auto separation = tail_.stableSeparation(approach, compliance);
        return separation ? std::optional(stateAt(*separation)) : std::nullopt;
    }
    [[nodiscard]] ContactState state(double approach, double compliance) const noexcept {
        return stateAt(tail_.separationAt(approach, compliance, tail_.endSeparation(compliance)));
    }
    /// The state at endApproach(): near a fold the approach hardly differs between neighbors.
    [[nodiscard]] ContactState last(double compliance) const noexcept {
        return stateAt(tail_.endSeparation(compliance));
    }
    [[nodiscard]] double energy(const ContactState& state) const noexcept {
        return tail_.energy(tail_.attraction().separationAt(state.force));
    }

private:
    [[nodiscard]] ContactState stateAt(double separation) const noexcept {
        return {.force = tail_.attraction().force(separation),
                .indentation = tail_.indentation(separation),
                .stiffness = tail_.stiffness(separation)};
    }

    AttractiveTail tail_;
};

/// A law for bonded bodies joined to one for separate ones, with the jumps between them at the
/// folds for the present lever. `Bonded` is a class as ContactLaw.h describes.
/// Source: docs/theory.md 2.5, 3.4, 7.1.
template <class Separate, class Bonded>
class JoinedLaw {
public:
    JoinedLaw(Separate separate, Bonded bonded) noexcept
        : separate_(std::move(separate)), bonded_(std::move(bonded)) {}

    [[nodiscard]] const Separate& separate() const noexcept { return separate_; }
    [[nodiscard]] const Bonded& bonded() const noexcept { return bonded_; }

    /// As ContactModel::equilibrium().
    [[nodiscard]] ContactState equilibrium(double approach, double compliance,
                                           const ContactMemory& memory) const noexcept {
        if (memory.branch == ContactBranch::Far) {
            const auto separate = separate_.stable(approach, compliance);
            return separate ? *separate : snapIn(approach, compliance);
        }
        const auto point = stable(approach, compliance, memory.coordinate);
        return point ? stateOf(*point) : pullOff(approach, compliance);
    }

    /// Approach of the undeflected tip at which separate bodies snap in [m].
    [[nodiscard]] double jumpInApproach(double compliance) const noexcept {
        return separate_.endApproach(compliance);
    }
    /// Approach of the undeflected tip at which the bond breaks [m].
    [[nodiscard]] double pullOffApproach(double compliance) const noexcept {
        return approachOf(bonded_.fold(compliance), compliance);
    }

    /// Work done on the bodies from infinite separation to this state [J].
    [[nodiscard]] double bodyEnergy(const ContactState& state) const noexcept {
        if (state.branch == ContactBranch::Far) {
            return separate_.energy(state);
        }
        return bonded_.energy({.force = state.force,
                               .indentation = state.indentation,
                               .contactRadius = state.contactRadius,
                               .cohesiveRadius = state.cohesiveRadius,
                               .stiffness = state.stiffness,
                               .coordinate = state.coordinate});
    }
    /// The last stable state before snap-in on a lever of this compliance.
    [[nodiscard]] ContactState lastFar(double compliance) const noexcept {
        return separate_.last(compliance);
    }
    /// The last stable bonded state on a lever of this compliance.
    [[nodiscard]] ContactState lastBonded(double compliance) const noexcept {
        return stateOf(bonded_.fold(compliance));
    }

private:
    [[nodiscard]] static double approachOf(const LawPoint& point, double compliance) noexcept {
        return point.indentation + (compliance * point.force);
    }

    [[nodiscard]] std::optional<LawPoint> stable(double approach, double compliance,
                                                 double coordinate) const noexcept {
        if constexpr (requires { bonded_.stable(approach, compliance, coordinate); }) {
            return bonded_.stable(approach, compliance, coordinate);
        } else {
            return bonded_.stable(approach, compliance);
        }
    }

    /// The bonded state at an approach where one must exist; rounding may put it on the fold.
    [[nodiscard]] LawPoint bondedAt(double approach, double compliance) const noexcept {
        const auto point = bonded_.stable(approach, compliance);
        return point ? *point : bonded_.fold(compliance);
    }

    [[nodiscard]] static ContactState stateOf(const LawPoint& point) noexcept {
        return {.force = point.force,
                .indentation = point.indentation,
                .contactRadius = point.contactRadius,
                .cohesiveRadius = point.cohesiveRadius,
                .stiffness = point.stiffness,
                .coordinate = point.coordinate,
                .branch = ContactBranch::Bonded};
    }

    [[nodiscard]] ContactState snapIn(double approach, double compliance) const noexcept {
        ContactState state = stateOf(bondedAt(approach, compliance));
        const double end = jumpInApproach(compliance);
        const ContactState before = separate_.last(compliance);
        const ContactState landing = stateOf(bondedAt(end, compliance));
        state.jumped = landing.force < before.force;
        state.energyLost = std::max(0.0, energy(before, compliance) - energy(landing, compliance));
        return state;
    }

    [[nodiscard]] ContactState pullOff(double approach, double compliance) const noexcept {
        ContactState state = separate_.state(approach, compliance);
        const LawPoint fold = bonded_.fold(compliance);
        const ContactState last = stateOf(fold);
        const ContactState landing = separate_.state(approachOf(fold, compliance), compliance);
        state.jumped = last.force < landing.force;
        state.energyLost = std::max(0.0, energy(last, compliance) - energy(landing, compliance));
        return state;
    }

    [[nodiscard]] double energy(const ContactState& state, double compliance) const noexcept {
        return bodyEnergy(state) + leverEnergy(state.force, compliance);
    }

    Separate separate_;
    Bonded bonded_;
};

// Contents of ContactModel beside its parameters: the laws, and which one a name means. For
// its sources alone: callers know no single law, and a new one is compiled into these.

/// Calls `visitor` with what a variant holds, as std::visit does, but can never throw: a variant of
/// types that copy without throwing always holds something.
template <std::size_t First = 0, class Visitor, class... Alternatives>
auto onAlternative(const Visitor& visitor, const std::variant<Alternatives...>& variant) noexcept {
    if constexpr (First + 1 < sizeof...(Alternatives)) {
        if (variant.index() != First) {
            return onAlternative<First + 1>(visitor, variant);
        }
    }
    return visitor(*std::get_if<First>(&variant));
}

struct ContactModel::Joined {
    template <class Bonded>
    using LawWithOnset = JoinedLaw<NoTail, Bonded>;
    template <class Bonded>
    using Tailed = JoinedLaw<WithTail, Bonded>;

    std::variant<LawWithOnset<HertzLaw>, LawWithOnset<DmtLaw>, LawWithOnset<JkrLaw>,
                 LawWithOnset<MaugisLaw>, LawWithOnset<SneddonLaw>, LawWithOnset<SphereJkrLaw>,
                 LawWithOnset<SphereMaugisLaw>, LawWithOnset<ConeMaugisLaw>, LawWithOnset<FilmLaw>,
                 Tailed<SplitLaw>, Tailed<SphereSplitLaw>, Tailed<ConeSplitLaw>>
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
