#pragma once

namespace asperity {

/// Displacement of an elastic half-space of unit modulus E* at the middle of one square of a unit
/// grid by unit pressure on another that lies `rows` and `columns` away. Times pitch / E* in SI.
/// Source: Love (1929); Johnson, Contact Mechanics (1985), 3.25.
[[nodiscard]] double loveInfluence(int rows, int columns) noexcept;

}  // namespace asperity
