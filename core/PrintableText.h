#pragma once

#include <string>
#include <string_view>

namespace asperity {

/// Whether a terminal or a text's layout obeys a character in place of showing it: control
/// characters, line ends, marks that turn the direction of writing.
[[nodiscard]] bool isCommand(char32_t codePoint);

/// A text from outside (a file's name, a channel's, a cell of a table) as one line that a terminal
/// or a window shows and does not obey: the bytes of what isCommand(), and those that are no UTF-8,
/// stand as \n, \t, \r, \e or \x1f. All else stays as it is.
[[nodiscard]] std::string printable(std::string_view text);

/// As printable(), but line feeds end lines: for messages of several lines.
[[nodiscard]] std::string printableLines(std::string_view text);

}  // namespace asperity
