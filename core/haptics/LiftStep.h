#pragma once

namespace asperity {

/// Where steps of a wheel bring the tip: near the sample they all have one length, away from it
/// they grow with the distance, so that a few of them lead from far away to the contact and none
/// passes through the sample at once. As many steps back lead to where they began.
/// @param height   of the tip above first contact, below 0 in contact [m]
/// @param notches  of the wheel, up positive; parts of one count
/// @param fineStep one notch near the sample, > 0 [m]
/// @return the new height [m]
[[nodiscard]] double liftedHeight(double height, double notches, double fineStep) noexcept;

/// One notch near the sample: a part of what the view shows, but in a wide view no more than moves
/// a lever in contact by a fifth of the setpoint, or a tenth of a nanometer [m].
/// @param halfWidth of the view [m]
/// @param setpoint  [N]
/// @param stiffness of the lever [N/m]
[[nodiscard]] double fineLiftStep(double halfWidth, double setpoint, double stiffness) noexcept;

}  // namespace asperity
