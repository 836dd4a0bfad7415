#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Returns bytes as text. Source: RFC 4648, section 4.
[[nodiscard]] std::string base64(std::string_view bytes);

/// Appends the bytes of letters of base64; padding ends a part, and another one may follow.
/// @param letters groups of four, nothing else between them
/// @return whether all of them were such letters; false: `bytes` holds those before
[[nodiscard]] bool appendBase64(std::string& bytes, std::string_view letters);

}  // namespace asperity
