#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

namespace asperity {

/// Limit of a result's validity, or a caution about it. The force stays on; users are told.
enum class Validity : std::uint64_t {
    LargeContact = 1U << 0U,  ///< contact radius > 0.3 effective radii: beyond linear elasticity
    OutsideScan = 1U << 1U,   ///< the closest point lies outside the scan
    FilledPixel = 1U << 2U,   ///< the pixel under the tip held no data
    ClosestPointNotFound = 1U << 3U,  ///< closest point did not converge
    NotInEquilibrium = 1U << 4U,      ///< the tip's equilibrium did not converge
    FrictionLock = 1U << 5U,          ///< friction would lock the lever
    ModelContradicted = 1U << 6U,     ///< the signals contradict the model's N by more than 3 sigma
    SingularGeometry = 1U << 7U,      ///< signals say little about one force direction
    Anisotropic = 1U << 8U,           ///< single effective radius is approximate
    NarrowValley = 1U << 9U,          ///< valley about as narrow as the tip, or narrower
    SeveralContactPoints =
        1U << 10U,             ///< the tip touches at several positions; their forces are summed
    TipNotHeld = 1U << 11U,    ///< no position of the base holds the tip where the device wants it
    ElasticLimit = 1U << 12U,  ///< peak pressure above the onset of yield, see yieldPressure()
    ThinFilm = 1U << 13U,      ///< contact too wide for the film and the law: see ContactValidity
    SnapInAhead = 1U << 14U,   ///< the lever is so soft that the tip will jump within 1 nm
    Implausible = 1U << 15U,   ///< the estimate breaks the friction law by more than 3 sigma
    UncertainPixel = 1U << 16U,  ///< the tip that recorded the scan may not have touched here
    SearchNotExhaustive =
        1U << 17U,  ///< other positions may bear as the contact points do, or more than are summed
    LawOutOfRange = 1U << 18U,  ///< the contact law leaves out what acts here, see LawRange
    EstimateInconsistent =
        1U << 19U,               ///< friction law or noise are not as stated: InnovationMonitor
    StaleSignals = 1U << 20U,    ///< measured so long ago that the lever may have bent since
    VariedMaterial = 1U << 21U,  ///< the sample's material varies within the contact
    OverlappingContacts = 1U << 22U,  ///< two contact circles overlap: they do not bear apart
    InteractingContacts =
        1U << 23U,  ///< contacts lower each other's surface by more than 5 % of the indentation
    UnresolvedCurvature = 1U << 24U,  ///< pixels or smoothing blur the curvature: AsperityValidity
    BeyondAsperity = 1U << 25U,       ///< the contact is wider than the asperity
    BodyAttraction = 1U << 26U,       ///< the sample beside the asperity attracts, too
    RetardedAttraction = 1U << 27U,   ///< van der Waals attraction is retarded across this gap
    LargeDeflection = 1U << 28U,      ///< the lever is bent so far that it is no longer linear
    StrengthLimited = 1U << 29U,      ///< JKR would misread w from pull-off: AttractionValidity
    BeyondSphere = 1U << 30U,  ///< contact as wide as a sphere whose shank the scene leaves out
    Extrapolated = 1U << 31U,  ///< a recorded instrument has no such motion in its record
    AsideOfRecord = std::uint64_t{1} << 32U,  ///< the recorded curve is of another place
};

/// Meaning of a flag for a result, the mildest first.
enum class Severity : std::uint8_t {
    Notice,       ///< announces what comes; the result holds
    Approximate,  ///< the result holds, less exactly
    Doubt,        ///< the result does not hold in full
    Invalid,      ///< there is no result to rely on
};

/// Basis on which a flag is found.
enum class FlagBasis : std::uint8_t {
    Tick,     ///< a single tick
    Contact,  ///< same, and it means nothing once the contact is gone
    Signals,  ///< noisy signals: a single tick says little, many ticks do
};

/// Traits of a flag; what logs, panels, files and summaries show is made from this.
struct ValidityTraits {
    Validity flag;
    const char* key;    ///< in logs and summaries
    const char* brief;  ///< for people in a hurry: 24 characters at most
    const char* words;  ///< for people
    Severity severity;
    FlagBasis basis;
};

/// Flags by bit.
inline constexpr std::array kValidityTraits{
    ValidityTraits{Validity::LargeContact, "large_contact", "contact > 0.3 eff. radii",
                   "contact radius above 0.3 effective radii: strain beyond linear elasticity",
                   Severity::Doubt, FlagBasis::Contact},
    ValidityTraits{Validity::OutsideScan, "outside_scan", "tip outside the scan",
                   "tip outside the scan", Severity::Invalid, FlagBasis::Tick},
    ValidityTraits{Validity::FilledPixel, "filled_pixel", "no data here: filled in",
                   "the scan holds no data here: height filled in", Severity::Doubt,
                   FlagBasis::Tick},
    ValidityTraits{Validity::ClosestPointNotFound, "closest_point_not_found",
                   "closest point not found", "closest point on the surface not found",
                   Severity::Invalid, FlagBasis::Tick},
    ValidityTraits{Validity::NotInEquilibrium, "not_in_equilibrium", "equilibrium not found",
                   "equilibrium of tip and cantilever not found", Severity::Invalid,
                   FlagBasis::Tick},
    ValidityTraits{Validity::FrictionLock, "friction_lock", "friction locks the lever",
                   "friction would lock the cantilever", Severity::Invalid, FlagBasis::Contact},
    ValidityTraits{Validity::ModelContradicted, "model_contradicted", "signals contradict model",
                   "signals contradict the contact model by more than 3 sigma", Severity::Doubt,
                   FlagBasis::Signals},
    ValidityTraits{Validity::SingularGeometry, "singular_geometry", "one direction uncertain",
                   "signals poorly determine one direction of the force", Severity::Approximate,
                   FlagBasis::Contact},
    ValidityTraits{Validity::Anisotropic, "curved_sample", "anisotropic curvature",
                   "anisotropic curvature: single effective radius is approximate",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::NarrowValley, "sharp_valley", "valley narrower than tip",
                   "valley narrower than the tip: contact law not valid", Severity::Doubt,
                   FlagBasis::Contact},
    ValidityTraits{Validity::SeveralContactPoints, "several_contact_points",
                   "several contact points", "several contact points: forces summed",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::TipNotHeld, "tip_not_held", "tip cannot be held here",
                   "the cantilever cannot hold the tip at the commanded position", Severity::Doubt,
                   FlagBasis::Tick},
    ValidityTraits{Validity::ElasticLimit, "elastic_limit", "pressure above yield",
                   "peak pressure exceeds onset of yield (about 0.6 hardness)", Severity::Doubt,
                   FlagBasis::Contact},
    ValidityTraits{Validity::ThinFilm, "thin_film", "contact wide for film",
                   "contact too wide for the film's thickness and the contact law", Severity::Doubt,
                   FlagBasis::Contact},
    ValidityTraits{Validity::SnapInAhead, "snap_in_ahead", "snap-in ahead",
                   "the tip is about to snap in", Severity::Notice, FlagBasis::Tick},
    ValidityTraits{Validity::Implausible, "implausible_estimate", "friction law violated",
                   "estimated force violates the friction law", Severity::Doubt,
                   FlagBasis::Signals},
    ValidityTraits{Validity::UncertainPixel, "uncertain_pixel", "height uncertain here",
                   "height uncertain: the imaging tip may not have touched here",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::SearchNotExhaustive, "search_not_exhaustive", "search not exhaustive",
                   "another contact point may exist (search not exhaustive)", Severity::Approximate,
                   FlagBasis::Tick},
    ValidityTraits{Validity::LawOutOfRange, "law_out_of_range", "adhesion beyond the law",
                   "adhesion beyond the range of the contact law", Severity::Doubt,
                   FlagBasis::Contact},
    ValidityTraits{Validity::EstimateInconsistent, "estimate_inconsistent", "error bars widened",
                   "signals contradict friction law or noise: error bars widened",
                   Severity::Approximate, FlagBasis::Signals},
    ValidityTraits{Validity::StaleSignals, "stale_signals", "instrument signals late",
                   "instrument signals late: weighted less", Severity::Approximate,
                   FlagBasis::Tick},
    ValidityTraits{Validity::VariedMaterial, "varied_material", "two materials in contact",
                   "the material varies by more than a tenth within the contact",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::OverlappingContacts, "overlapping_contacts", "contacts overlap",
                   "contact circles overlap: sum of forces not valid", Severity::Doubt,
                   FlagBasis::Contact},
    ValidityTraits{Validity::InteractingContacts, "interacting_contacts", "contacts interact",
                   "contacts lower each other by over 5 % of the indentation",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::UnresolvedCurvature, "unresolved_curvature", "curvature unresolved",
                   "pixels and smoothing blur the curvature here: radius over a tenth off",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::BeyondAsperity, "beyond_asperity", "contact > asperity",
                   "contact wider than the asperity: radius over a tenth off",
                   Severity::Approximate, FlagBasis::Contact},
    ValidityTraits{Validity::BodyAttraction, "body_attraction", "sample beside attracts",
                   "attraction of the sample beside the asperity is left out",
                   Severity::Approximate, FlagBasis::Tick},
    ValidityTraits{Validity::RetardedAttraction, "retarded_attraction", "attraction retarded",
                   "van der Waals attraction is retarded across this gap: weaker than modeled",
                   Severity::Approximate, FlagBasis::Tick},
    ValidityTraits{Validity::LargeDeflection, "large_deflection", "lever bent too far",
                   "lever bent by over a fifth of its length: no longer linear", Severity::Doubt,
                   FlagBasis::Tick},
    ValidityTraits{Validity::StrengthLimited, "strength_limited", "strength sets pull-off",
                   "strength limits adhesion: JKR misreads pull-off by over 5 %", Severity::Notice,
                   FlagBasis::Contact},
    ValidityTraits{Validity::BeyondSphere, "beyond_sphere", "contact beyond sphere",
                   "contact reaches the tip's shank, which has no cone_half_angle_rad",
                   Severity::Doubt, FlagBasis::Contact},
    ValidityTraits{Validity::Extrapolated, "extrapolated", "not in the record",
                   "the recorded curve has no such motion: its retract, shifted",
                   Severity::Approximate, FlagBasis::Tick},
    ValidityTraits{Validity::AsideOfRecord, "aside_of_record", "aside of the record",
                   "the recorded curve is of another place on the sample", Severity::Doubt,
                   FlagBasis::Tick},
};

inline constexpr std::size_t kValidityFlagCount = kValidityTraits.size();

/// A set of validity flags.
class ValidityFlags {
public:
    ValidityFlags() = default;
    explicit ValidityFlags(std::uint64_t bits) noexcept : bits_(bits) {}

    void set(Validity flag, bool on) noexcept {
        if (on) {
            bits_ |= static_cast<std::uint64_t>(flag);
        }
    }
    void add(ValidityFlags others) noexcept { bits_ |= others.bits_; }
    [[nodiscard]] bool has(Validity flag) const noexcept {
        return (bits_ & static_cast<std::uint64_t>(flag)) != 0;
    }
    [[nodiscard]] std::uint64_t bits() const noexcept { return bits_; }

private:
    std::uint64_t bits_ = 0;
};

/// Returns whether one of the flags says that there is no result to rely on.
[[nodiscard]] inline bool isInvalid(ValidityFlags flags) noexcept {
    for (const ValidityTraits& traits : kValidityTraits) {
        if (traits.severity == Severity::Invalid && flags.has(traits.flag)) {
            return true;
        }
    }
    return false;
}

/// Keys joined by '|', or "-" when none is set.
[[nodiscard]] std::string validityText(ValidityFlags flags);

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
    // The force is that of another position, or off by some ten per cent.
    Validity::AsideOfRecord, Validity::TipNotHeld, Validity::LargeDeflection,
    Validity::LargeContact,
    // Approximate. By a tenth or more; by some per cent; error bars alone.
    Validity::Extrapolated, Validity::UnresolvedCurvature, Validity::BeyondAsperity,
    Validity::VariedMaterial, Validity::UncertainPixel, Validity::SearchNotExhaustive,
    Validity::BodyAttraction, Validity::InteractingContacts, Validity::RetardedAttraction,
    Validity::Anisotropic, Validity::SeveralContactPoints, Validity::SingularGeometry,
    Validity::StaleSignals, Validity::EstimateInconsistent,
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
