#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace asperity {

/// A character at the front of a text.
struct Utf8Character {
    std::size_t length = 0;  ///< in bytes; 0: the text does not begin with valid UTF-8
    char32_t codePoint = 0;
};

/// The first character of a text. Strict, as The Unicode Standard, table 3-7, has it: no overlong
/// form, no surrogate, nothing beyond U+10FFFF. @param text not empty
[[nodiscard]] Utf8Character firstCharacter(std::string_view text);

/// Whether a text is valid UTF-8 from end to end.
[[nodiscard]] bool isUtf8(std::string_view text);

/// Returns the start of a text, of at most so many bytes, that does not end within a character.
[[nodiscard]] std::string_view utf8Start(std::string_view text, std::size_t most);

/// Returns a text whole, or its start and its end around "…", of at most so many bytes: for
/// messages that quote a file and end with what was expected. @param most at least 100
[[nodiscard]] std::string shortened(std::string_view text, std::size_t most);

/// Appends a character. @param codePoint a Unicode scalar value
void appendUtf8(std::string& text, char32_t codePoint);

}  // namespace asperity
