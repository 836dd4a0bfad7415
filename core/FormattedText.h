#pragma once

#include <string>

namespace asperity {

/// Returns what std::printf() would print, up to 511 bytes.
[[nodiscard, gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

/// Returns a duration for people, to the second, the minute or a tenth of an hour: "45 s", "12
/// min", "3.4 h".
[[nodiscard]] std::string durationText(double seconds);

}  // namespace asperity
