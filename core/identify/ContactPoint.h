#pragma once

#include "core/EnumTable.h"
#include "core/identify/CurvePreparation.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace asperity {

/// Ways to find the base at which tip and sample touch.
enum class ContactMethod : std::uint8_t {
    Model,         ///< a parameter of the fit
    Deviation,     ///< the force leaves the noise: fast, early where forces have a long range
    LinePower,     ///< a line, from the contact on plus a power of the indentation
    ConstantLine,  ///< a constant, from the contact on a line: robust, late on soft samples
    Gradient,      ///< the slope reaches a twentieth of its maximum
};

template <>
inline constexpr auto kEnumTable<ContactMethod> =
    std::to_array<EnumRow<ContactMethod>>({{ContactMethod::Model, "model"},
                                           {ContactMethod::Deviation, "deviation"},
                                           {ContactMethod::LinePower, "line+power"},
                                           {ContactMethod::ConstantLine, "constant+line"},
                                           {ContactMethod::Gradient, "gradient"}});

/// Returns the base [m] at which the approach touches the sample; none where the method finds no
/// contact, or one outside the data. @param method any but Model  @param force without baseline [N]
/// @param noise of one sample [N]  @param exponent of force over indentation, 1.5 or 2
[[nodiscard]] std::optional<double> contactPoint(ContactMethod method,
                                                 const BranchSamples& approach,
                                                 const std::vector<double>& force, double noise,
                                                 double exponent = 1.5);

}  // namespace asperity
