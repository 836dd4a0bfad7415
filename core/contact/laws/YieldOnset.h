#pragma once

namespace asperity {

/// Pressure in the middle of an elastic contact at which a sample of this hardness begins to yield
/// below the surface, long before it flows [Pa].
///
/// On the axis of Hertz' contact, at depth z = x a, the two principal stresses differ by p0 f(x),
/// f = 3 / (2 (1 + x^2)) - (1 + nu) (1 - x atan(1/x)), and by nothing else in Tresca's or von
/// Mises' condition: yield begins at p0 = Y / max f, 1.30 Y at nu = 0, 1.61 Y at 0.3 and 1.88 Y at
/// 0.5. A hardness is the mean pressure under a fully plastic contact, H = 2.8 Y; so the onset lies
/// between 0.46 H and 0.67 H.
///
/// An adhesive contact's pressure is that of Hertz less tractions of the flat punch's kind, each
/// p / sqrt(1 - r^2/t^2) with its own radius t. Under one of radius a the stresses differ by
/// p (f - x f'), where f is largest by p f: there they are in the same ratio to the pressure in the
/// middle as under Hertz' alone, singular edge or not. The largest difference lies a little higher;
/// it is 7 % more for JKR without load, and less under load. The onset is known no better than
/// hardness over yield stress, 2.6 to 3.
///
/// Sources: Johnson, Contact Mechanics (1985), chapter 6 (onset of yield, hardness; Tabor 1951);
/// the closed form 1.295 exp(0.736 nu) of 1 / max f: Jackson, Green (2005), within 0.4 %.
/// @param hardness     [Pa], >= 0  @param poissonRatio of the sample, 0 .. 0.5
[[nodiscard]] double yieldPressure(double hardness, double poissonRatio) noexcept;

}  // namespace asperity
