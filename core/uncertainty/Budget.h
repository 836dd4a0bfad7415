#pragma once

#include "core/EnumTable.h"
#include "core/scene/Uncertainty.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace asperity {

/// Reason why the shares of the inputs in a result are not known.
enum class UnknownShares : std::uint8_t {
    None,             ///< they are known
    SeveralContacts,  ///< the law is of one
    MissingTicks,     ///< part of the reading has no state of the model
    NoLandmark,       ///< the law at the position has nothing like the reading
    NotComputed,      ///< nobody has asked for them
};

template <>
inline constexpr auto kEnumTable<UnknownShares> = std::to_array<EnumRow<UnknownShares>>(
    {{UnknownShares::None, "none", "known"},
     {UnknownShares::SeveralContacts, "several_contacts", "several contacts at once"},
     {UnknownShares::MissingTicks, "missing_ticks", "ticks without a state of the model"},
     {UnknownShares::NoLandmark, "no_landmark", "the law has none at this point"},
     {UnknownShares::NotComputed, "not_computed", "not computed"}});
static_assert(isComplete<UnknownShares>());

/// A result with what is open in it. All in the unit of the result; deviations are standard ones.
struct Budget {
    double value = 0.0;
    double noise = 0.0;  ///< what the detector cannot resolve
    /// Change of the result by each input, in the order of UncertaintyInput, >= 0; NaN: not known.
    std::array<double, kUncertaintyInputCount> shares{};
    /// Amount by which the value is too large because the scan still has the shape of its imaging
    /// tip: value - shift is the best estimate, about which the deviations are. Known in size and
    /// sign, it is no deviation: an interval by its square would hold the truth too often.
    double shift = 0.0;
    /// Largest change of the result, on the sampled runs of RequiredTerms, by terms that the model
    /// leaves out or that its law cannot have, >= 0. It counts as a standard deviation. NaN: not
    /// known.
    double leftOut = 0.0;
    bool isLeftOutJudged = true;  ///< false: no runs were sampled; `leftOut` is 0 for want of them
    UnknownShares unknown = UnknownShares::None;  ///< why `shares` are NaN
    /// Largest change of the result by roughness that smoothing or pixels may have removed and that
    /// the noise of the heights hides, >= 0. Not part of any deviation: it need not be there.
    double hidden = 0.0;

    [[nodiscard]] double share(UncertaintyInput input) const noexcept {
        return shares[static_cast<std::size_t>(input)];
    }
    /// Returns the uncertainty by the inputs: all shares, as independent ones; NaN: not known.
    [[nodiscard]] double inputs() const noexcept;
    /// Returns the uncertainty by model and calibration: the inputs, and terms left out.
    [[nodiscard]] double model() const noexcept;
    /// Returns whether that is known, but for terms left out that were not judged.
    [[nodiscard]] bool isModelKnown() const noexcept;
    /// Returns whether it is known what terms left out do.
    [[nodiscard]] bool isLeftOutKnown() const noexcept;
    /// The same about the value as it is, for where one number must do: the shift counts as one
    /// more deviation.
    [[nodiscard]] double modelAboutValue() const noexcept;
    /// Noise and model together.
    [[nodiscard]] double total() const noexcept;
    /// The input with the largest share; none: no input moves the result, or none is known to.
    [[nodiscard]] std::optional<UncertaintyInput> dominant() const noexcept;
    /// Returns whether the terms left out move the result by more than any input does.
    [[nodiscard]] bool isMostLeftOut() const noexcept;
    /// The inputs that make up nine tenths of the variance by all inputs, the largest first.
    [[nodiscard]] std::vector<UncertaintyInput> mainInputs() const;
    /// Returns the change of the result by smoothing and pixels, relative to its value.
    [[nodiscard]] double resolutionShare() const noexcept;
    /// The same relative shares of another reading of the result; where it is 0, or there is none,
    /// no share of a reading that is not is known. @param deviation by noise
    [[nodiscard]] Budget of(double reading, double deviation) const noexcept;
    /// The same without what the inputs move it by; terms left out stay. @param why not None
    [[nodiscard]] Budget withoutShares(UnknownShares why) const noexcept;
};

/// A reading of which no more is known than its noise. @param noise standard deviation
/// @param why not None
[[nodiscard]] Budget budgetByNoise(double value, double noise, UnknownShares why) noexcept;

}  // namespace asperity
