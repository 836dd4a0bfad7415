#pragma once

namespace asperity {

/// Carlson's symmetric elliptic integral of the first kind; arguments >= 0, at most one of them 0.
/// To rounding, bounded, no exception. Source: Carlson (1995), Numer. Algorithms 10, 13.
[[nodiscard]] double carlsonRf(double x, double y, double z) noexcept;

/// Carlson's symmetric elliptic integral of the second kind; x, y >= 0, at most one of them 0, z >
/// 0.
[[nodiscard]] double carlsonRd(double x, double y, double z) noexcept;

}  // namespace asperity
