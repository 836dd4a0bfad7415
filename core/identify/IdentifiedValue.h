#pragma once

#include "core/EnumTable.h"

#include <cstdint>
#include <string>

namespace asperity {

/// Where a value comes from.
enum class ValueSource : std::uint8_t {
    Measured,  ///< computed from the measured curve
    File,      ///< in the curve's file, or in one that the user named
    Assumed,   ///< given by the user, or the usual one
    Fitted,    ///< a parameter of a fit
};

template <>
inline constexpr auto kEnumTable<ValueSource> =
    std::to_array<EnumRow<ValueSource>>({{ValueSource::Measured, "measured"},
                                         {ValueSource::File, "file"},
                                         {ValueSource::Assumed, "assumed"},
                                         {ValueSource::Fitted, "fitted"}});

/// A number that a curve was found to have, or that was used to find one, with its uncertainty.
struct IdentifiedValue {
    std::string key;  ///< in fit.json: "youngs_modulus_pa"
    double value = 0.0;
    double std = 0.0;             ///< by the noise of the curve, alike errors counted; 0: none
    double stdCalibration = 0.0;  ///< by the uncertainty of lever, tip and material; 0: none
    std::string unit;             ///< "Pa"; empty: none
    ValueSource source = ValueSource::Fitted;
};

}  // namespace asperity
