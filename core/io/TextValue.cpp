#include "core/io/TextValue.h"

#include "core/PrintableText.h"

#include <array>
#include <charconv>
#include <cstdint>

namespace asperity {

namespace {

/// Code points of the bytes 0x80 to 0x9F in Windows-1252; unused ones keep their number.
constexpr std::array<std::uint16_t, 32> kWindows1252 = {
    0x20AC, 0x81,   0x201A, 0x0192, 0x201E, 0x2026, 0x2020, 0x2021, 0x02C6, 0x2030, 0x0160,
    0x2039, 0x0152, 0x8D,   0x017D, 0x8F,   0x90,   0x2018, 0x2019, 0x201C, 0x201D, 0x2022,
    0x2013, 0x2014, 0x02DC, 0x2122, 0x0161, 0x203A, 0x0153, 0x9D,   0x017E, 0x0178};

/// std::from_chars accepts no plus sign.
std::string_view withoutPlus(std::string_view text) {
    const bool plus = text.size() > 1 && text[0] == '+' && text[1] != '-' && text[1] != '+';
    return plus ? text.substr(1) : text;
}

template <typename Number>
std::optional<Number> parseWhole(std::string_view text) {
    text = withoutPlus(trimmed(text));
    Number value{};
    const char* end = text.data() + text.size();
    const std::from_chars_result result = std::from_chars(text.data(), end, value);
    if (result.ec != std::errc() || result.ptr != end) {
        return std::nullopt;
    }
    return value;
}

/// Returns whether it is a number below the smallest double: 1e-400.
bool isTooSmall(std::string_view text) {
    text = withoutPlus(trimmed(text));
    double number = 0.0;
    const std::from_chars_result result =
        std::from_chars(text.data(), text.data() + text.size(), number);
    return result.ec == std::errc::result_out_of_range && result.ptr == text.data() + text.size() &&
           text.find_first_of("eE") != std::string_view::npos &&
           text[text.find_first_of("eE") + 1] == '-';
}

char32_t utf16Unit(std::string_view bytes, std::size_t offset, std::endian order) {
    const auto first = static_cast<unsigned char>(bytes[offset]);
    const auto second = static_cast<unsigned char>(bytes[offset + 1]);
    return order == std::endian::little ? first | (second << 8U) : second | (first << 8U);
}

constexpr bool isHighSurrogate(char32_t unit) { return unit >= 0xD800 && unit < 0xDC00; }
constexpr bool isLowSurrogate(char32_t unit) { return unit >= 0xDC00 && unit < 0xE000; }

}  // namespace

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view kBlank = " \t\r\n";
    const std::size_t first = text.find_first_not_of(kBlank);
    if (first == std::string_view::npos) {
        return {};
    }
    return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

std::string lowerCase(std::string_view text) {
    std::string lower(text);
    for (char& c : lower) {
        if (c >= 'A' && c <= 'Z') {
            c = static_cast<char>(c - 'A' + 'a');
        }
    }
    return lower;
}

std::string toUtf8(std::string_view text) {
    if (isUtf8(text)) {
        return std::string(text);
    }
    std::string utf8;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        const bool special = byte >= 0x80 && byte < 0xA0;
        appendUtf8(utf8, special ? kWindows1252[byte - 0x80U] : byte);
    }
    return utf8;
}

std::string utf16ToUtf8(std::string_view bytes, std::endian order) {
    constexpr char32_t kReplacement = 0xFFFD;
    std::string utf8;
    utf8.reserve(bytes.size() / 2);
    for (std::size_t offset = 0; offset + 1 < bytes.size(); offset += 2) {
        char32_t character = utf16Unit(bytes, offset, order);
        if (isHighSurrogate(character) && offset + 3 < bytes.size()) {
            const char32_t low = utf16Unit(bytes, offset + 2, order);
            if (isLowSurrogate(low)) {
                character = 0x10000U + ((character - 0xD800U) << 10U) + (low - 0xDC00U);
                offset += 2;
            }
        }
        const bool single = character >= 0xD800 && character < 0xE000;
        appendUtf8(utf8, single ? kReplacement : character);
    }
    return utf8;
}

std::optional<double> parseNumber(std::string_view text) {
    const std::optional<double> number = parseWhole<double>(text);
    return !number && isTooSmall(text) ? 0.0 : number;
}

std::optional<long long> parseInteger(std::string_view text) { return parseWhole<long long>(text); }

std::optional<LeadingNumber> parseLeadingNumber(std::string_view text) {
    text = withoutPlus(trimmed(text));
    LeadingNumber number;
    const std::from_chars_result result =
        std::from_chars(text.data(), text.data() + text.size(), number.value);
    if (result.ec != std::errc()) {
        return std::nullopt;
    }
    number.rest = trimmed(text.substr(static_cast<std::size_t>(result.ptr - text.data())));
    return number;
}

std::string exactText(double value) {
    std::array<char, 32> text{};
    const std::to_chars_result result =
        std::to_chars(text.data(), text.data() + text.size(), value);
    return {text.data(), result.ptr};
}

}  // namespace asperity
