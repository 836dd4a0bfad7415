#pragma once

namespace asperity {

/// Damping of the hand and the device that it holds [N s/m], as a light grip has it.
inline constexpr double kHandDamping = 1.0;

/// The largest force gain at which a hand that feels the lever's spring through a loop of this rate
/// gets no energy from it: the felt stiffness, gains times lever stiffness, may be up to twice the
/// damping over the period. The lever's stiffness bounds that of lever and contact in a row.
/// Source: Colgate, Schenkel (1997), b > K T / 2.
/// @param leverStiffness [N/m] @param positionGain tip's displacement per hand's @param rate [Hz]
[[nodiscard]] inline double largestForceGain(double leverStiffness, double positionGain,
                                             double rate) noexcept {
    return 2.0 * kHandDamping * rate / (leverStiffness * positionGain);
}

}  // namespace asperity
