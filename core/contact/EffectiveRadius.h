#pragma once

namespace asperity {

/// A tip on a curved sample as the contact laws see it: a tip on a flat one.
struct EffectiveRadius {
    double radius = 0.0;       ///< [m]
    bool tipFits = true;       ///< false: valley about as narrow as the tip or narrower
    bool anisotropic = false;  ///< the two relative curvatures differ by more than a factor of 2
};

/// R_eff = [(1/R + kappa_1)(1/R + kappa_2)]^(-1/2), each factor at least a tenth of 1/R: below, the
/// tip does not fit the valley. A bump has no such bound, however sharp. R_eff is never below
/// kMinTipRadius.
/// Good to a few per cent unless `anisotropic`; valid only if `tipFits`. For values that are no
/// numbers or a tip outside the laws' range `tipFits` is false and the radius is R.
/// @param tipRadius R [m]  @param largest, smallest principal curvatures of the sample, > 0 for a
///        bump [1/m]. Source: docs/theory.md 1.
[[nodiscard]] EffectiveRadius effectiveRadius(double tipRadius, double largest,
                                              double smallest) noexcept;

}  // namespace asperity
