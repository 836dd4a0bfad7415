#pragma once

#include <string>

namespace asperity {

/// What std::printf() would print, up to 511 bytes.
[[nodiscard, gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace asperity
