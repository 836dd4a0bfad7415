#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace asperity {

/// Texts in which values hold values; their parsers use a piece of the stack for each depth and
/// some tens of bytes for each value, however short it is.
enum class NestedSyntax : std::uint8_t { Toml, Json };

/// Refuses a text that would need far more stack or memory than any of Asperity's own, before it is
/// parsed. Mistakes of other kinds are the parser's.
/// @param file for messages
/// @throw InputError with the line where there is too much
void requireParsable(std::string_view text, NestedSyntax syntax, const std::string& file);

}  // namespace asperity
