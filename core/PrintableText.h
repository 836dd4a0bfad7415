#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// Returns whether a terminal or a text's layout obeys a character instead of showing it: control
/// characters, line ends, marks that turn the direction of writing.
[[nodiscard]] bool isCommand(char32_t codePoint);

/// A text from outside (a file's name, a channel's, a cell of a table) as one line that a terminal
/// or a window shows and does not obey: the bytes of what isCommand(), and those that are no UTF-8,
/// become \n, \t, \r, \e or \x1f. All else stays as it is.
[[nodiscard]] std::string printable(std::string_view text);

/// The same as printable(), but line feeds end lines: for messages of several lines.
[[nodiscard]] std::string printableLines(std::string_view text);

/// A character at the front of a text.
struct Utf8Character {
    std::size_t length = 0;  ///< in bytes; 0: the text does not begin with valid UTF-8
    char32_t codePoint = 0;
};

/// The first character of a text. Strict, as The Unicode Standard, table 3-7, has it: no overlong
/// form, no surrogate, nothing beyond U+10FFFF. @param text not empty
[[nodiscard]] Utf8Character firstCharacter(std::string_view text);

/// Returns whether a text is valid UTF-8 from end to end.
[[nodiscard]] bool isUtf8(std::string_view text);

/// Returns the start of a text, of at most this many bytes, that does not end within a character.
[[nodiscard]] std::string_view utf8Start(std::string_view text, std::size_t most);

/// Returns a text whole, or its start and its end around "…", of at most this many bytes:
/// messages that quote a file and end with what was expected. @param most at least 100
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/// Maximum length of a message to a user, which can quote any length of a file [bytes].
inline constexpr std::size_t kMaxMessage = 1000;

/// Appends a character. @param codePoint a Unicode scalar value
void appendUtf8(std::string& text, char32_t codePoint);

/// A path as text for JSON and TOML, which hold UTF-8 only. Most paths stay as they are. One that
/// is no UTF-8, or that would read as a URI, becomes the file URI of its absolute path (RFC 8089,
/// "file:///scans/25%B5m.gsf"), so that no byte is lost.
[[nodiscard]] std::string pathText(const std::filesystem::path& path);

/// Returns the path that a text means: a file URI of this machine, or the path itself.
/// @return empty when the text begins as a file URI and is none ("%" without two digits, "%00")
[[nodiscard]] std::optional<std::filesystem::path> pathFromText(std::string_view text);

}  // namespace asperity
