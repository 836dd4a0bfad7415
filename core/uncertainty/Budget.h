#pragma once

#include "core/scene/Uncertainty.h"

#include <array>
#include <optional>
#include <vector>

namespace asperity {

/// A result with what is open in it. All in the unit of the result; deviations are standard ones.
struct Budget {
    double value = 0.0;
    double noise = 0.0;  ///< what the detector cannot resolve
    /// By what each input moves the result, in the order of UncertaintyInput, >= 0; NaN: not known.
    std::array<double, kUncertaintyInputCount> shares{};
    /// By how much the value is too large because the scan still has the shape of its imaging tip:
    /// value - shift is the best estimate, about which the deviations are. Known in size and sign,
    /// it is no deviation: an interval by its square would hold the truth too often.
    double shift = 0.0;
    /// What terms that the model leaves out, or its law has no room for, change the result by, at
    /// most on the sampled runs of SceneNeeds, >= 0. It counts as a standard deviation.
    double leftOut = 0.0;
    /// Largest change of the result by roughness that smoothing or pixels may have removed and that
    /// the noise of the heights hides, >= 0. Not part of any deviation: it need not be there.
    double hidden = 0.0;

    [[nodiscard]] double share(UncertaintyInput input) const noexcept {
        return shares[static_cast<std::size_t>(input)];
    }
    /// What the inputs leave open: all shares, as independent ones; NaN: not known.
    [[nodiscard]] double inputs() const noexcept;
    /// What model and calibration leave open: the inputs, and terms left out.
    [[nodiscard]] double model() const noexcept;
    /// Whether that is known.
    [[nodiscard]] bool isModelKnown() const noexcept;
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
    /// What smoothing and pixels move the result by, relative to its value.
    [[nodiscard]] double resolutionShare() const noexcept;
    /// The same relative shares of another reading of the result. @param deviation by noise
    [[nodiscard]] Budget of(double reading, double deviation) const noexcept;
};

/// A reading of which no more is known than its noise. @param noise standard deviation
[[nodiscard]] Budget budgetByNoise(double value, double noise) noexcept;

}  // namespace asperity
