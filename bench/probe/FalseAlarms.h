#pragma once

namespace asperity {

/// Feeds the innovation test with the noise that it expects, in free air and in contact, at rest
/// and sliding in several directions, at several rates, and prints the flags per second with an
/// upper bound at 95 % confidence.
/// @param seconds simulated of each situation
/// @return whether each bound is below 1e-4 per second
bool printFalseAlarms(double seconds);

}  // namespace asperity
