#pragma once

#include <bit>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// Without the blanks, tabs and line ends around it.
[[nodiscard]] std::string_view trimmed(std::string_view text);

/// ASCII letters in lower case, every other byte as it is.
[[nodiscard]] std::string lowerCase(std::string_view text);

/// The text as UTF-8: kept when it is valid UTF-8, else read as Windows-1252.
[[nodiscard]] std::string toUtf8(std::string_view text);

/// UTF-16 as UTF-8. Half a pair of surrogates becomes U+FFFD; an odd byte at the end is left out.
[[nodiscard]] std::string utf16ToUtf8(std::string_view bytes, std::endian order);

/// The whole text as a number with a decimal point, blanks around it allowed; independent of the
/// locale; "nan" and "inf" are numbers here. Empty when it is anything else or out of range.
[[nodiscard]] std::optional<double> parseNumber(std::string_view text);

/// The whole text as an integer.
[[nodiscard]] std::optional<long long> parseInteger(std::string_view text);

/// A number at the start of a text and what follows it.
struct LeadingNumber {
    double value = 0.0;
    std::string_view rest;  ///< trimmed
};
[[nodiscard]] std::optional<LeadingNumber> parseLeadingNumber(std::string_view text);

/// The shortest decimal text that reads back as the same double.
[[nodiscard]] std::string exactText(double value);

}  // namespace asperity
