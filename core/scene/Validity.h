#pragma once

#include <cstdint>
#include <string>

namespace asperity {

/// What a result does not hold for, or what to mind about it. The force goes on; people are told.
enum class Validity : std::uint32_t {
    LargeContact = 1U << 0U,       ///< contact radius over tip radius > 0.3: beyond the half-space
    OutsideScan = 1U << 1U,        ///< the foot lies outside the scan
    FilledPixel = 1U << 2U,        ///< the pixel under the tip held no data
    FootNotFound = 1U << 3U,       ///< closest point did not converge
    NotInEquilibrium = 1U << 4U,   ///< the tip's equilibrium did not converge
    FrictionLock = 1U << 5U,       ///< friction would lock the lever
    ModelContradicted = 1U << 6U,  ///< the signals contradict the model's N by more than 3 sigma
    SingularGeometry = 1U << 7U,   ///< signals say little about one force direction
    CurvedSample = 1U << 8U,       ///< no single effective radius stands for the sample's curvature
    SharpValley = 1U << 9U,        ///< the sample is hollow about as sharply as the tip, or more
    SeveralFeet = 1U << 10U,       ///< the tip touches at several places; their forces are summed
    TipNotHeld = 1U << 11U,        ///< no place of the base holds the tip where the hand wants it
    ElasticLimit = 1U << 12U,      ///< peak pressure above the onset of yield, see yieldPressure()
    ThinFilm = 1U << 13U,        ///< contact too wide for the film and the law: see ContactValidity
    SnapInAhead = 1U << 14U,     ///< the lever is so soft that the tip will jump within 1 nm
    Implausible = 1U << 15U,     ///< the estimate breaks the friction law by more than 3 sigma
    UncertainPixel = 1U << 16U,  ///< the tip that recorded the scan may not have touched here
    FeetUnproven = 1U << 17U,    ///< other places may be as near to the tip as the feet found
    LawOutOfRange = 1U << 18U,   ///< the contact law leaves out what acts here, see LawRange
    EstimateInconsistent =
        1U << 19U,  ///< friction law or noise are not as stated: InnovationMonitor
};

/// A set of validity flags.
class ValidityFlags {
public:
    void set(Validity flag, bool on) noexcept {
        if (on) {
            bits_ |= static_cast<std::uint32_t>(flag);
        }
    }
    void add(ValidityFlags others) noexcept { bits_ |= others.bits_; }
    [[nodiscard]] bool has(Validity flag) const noexcept {
        return (bits_ & static_cast<std::uint32_t>(flag)) != 0;
    }
    [[nodiscard]] std::uint32_t bits() const noexcept { return bits_; }

private:
    std::uint32_t bits_ = 0;
};

inline constexpr int kValidityFlagCount = 20;

/// Name of one flag as logs and panels show it, e.g. "large_contact".
[[nodiscard]] const char* validityName(Validity flag) noexcept;

/// Names joined by '|', or "-" when none is set.
[[nodiscard]] std::string validityText(ValidityFlags flags);

}  // namespace asperity
