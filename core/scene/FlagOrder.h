#pragma once

#include "core/scene/Validity.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace asperity {

/// All flags in the order in which people are told: by severity, within it by how much the force
/// that is shown may be off, the worst first; docs/physics.md, "What a result does not hold for".
inline constexpr std::array kFlagsByEffect{
    // Invalid: there is no force of a tip on this sample.
    Validity::NotInEquilibrium, Validity::ClosestPointNotFound, Validity::OutsideScan,
    Validity::FrictionLock,
    // Doubt. Shape or law are not those of the contact: the force may be off by several times.
    Validity::FilledPixel, Validity::BeyondSphere, Validity::NarrowValley,
    Validity::OverlappingContacts, Validity::LawOutOfRange, Validity::ThinFilm,
    Validity::ElasticLimit,
    // The signals say that model or estimate are off by more than 3 sigma.
    Validity::ModelContradicted, Validity::Implausible,
    // The force is that of another place, or off by some ten per cent.
    Validity::TipNotHeld, Validity::LargeDeflection, Validity::LargeContact,
    // Approximate. By a tenth or more; by some per cent; error bars alone.
    Validity::UnresolvedCurvature, Validity::BeyondAsperity, Validity::VariedMaterial,
    Validity::UncertainPixel, Validity::SearchNotExhaustive, Validity::BodyAttraction,
    Validity::InteractingContacts, Validity::RetardedAttraction, Validity::Anisotropic,
    Validity::SeveralContactPoints, Validity::SingularGeometry, Validity::StaleSignals,
    Validity::EstimateInconsistent,
    // Notices.
    Validity::SnapInAhead, Validity::StrengthLimited};

static_assert(kFlagsByEffect.size() == kValidityFlagCount);

/// Returns the index of a flag into kValidityTraits.
[[nodiscard]] constexpr std::size_t indexOf(Validity flag) noexcept {
    const auto* const found = std::ranges::find(kValidityTraits, flag, &ValidityTraits::flag);
    return static_cast<std::size_t>(found - kValidityTraits.begin());
}

/// Returns the traits of a flag.
[[nodiscard]] constexpr const ValidityTraits& traitsOf(Validity flag) noexcept {
    return kValidityTraits.at(indexOf(flag));
}

static_assert(std::ranges::is_sorted(kFlagsByEffect, std::ranges::greater(),
                                     [](Validity flag) { return traitsOf(flag).severity; }));

}  // namespace asperity
