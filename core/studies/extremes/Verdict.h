#pragma once

#include "core/EnumTable.h"

#include <cstdint>

namespace asperity {

/// What a state is worth, best first.
enum class Verdict : std::uint8_t {
    Exact,     ///< solved, not flagged, within kExactWithin of the reference
    Valid,     ///< solved, not flagged, within kValidWithin of it
    Off,       ///< solved, not flagged, farther off
    Flagged,   ///< solved, and a validity flag says that it does not hold
    Unproven,  ///< solved, not flagged, but the reference itself is not known to hold there
    Refused,   ///< no answer, but a reason
};

template <>
inline constexpr auto
    kEnumTable<Verdict> = std::to_array<EnumRow<Verdict>>({{Verdict::Exact, "exact"},
                                                           {Verdict::Valid, "valid"},
                                                           {Verdict::Off, "off"},
                                                           {Verdict::Flagged, "flagged"},
                                                           {Verdict::Unproven, "unproven"},
                                                           {Verdict::Refused, "refused"}});

/// Below what any force calibration tells [relative].
inline constexpr double kExactWithin = 1e-3;
/// As far as two adhesion laws of the same work and range differ [relative]: nothing finer has a
/// physical meaning. Source: docs/theory.md 2.9.
inline constexpr double kValidWithin = 0.05;

/// The verdict on a solved state without flags whose reference holds. @param error relative to the
/// reference
[[nodiscard]] Verdict verdictOnError(double error) noexcept;

/// Difference of two quantities relative to the largest of both and `unit` >= 0; 0 where all are 0.
[[nodiscard]] double relativeError(double value, double reference, double unit) noexcept;

}  // namespace asperity
