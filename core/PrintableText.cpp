#include "core/PrintableText.h"

#include <algorithm>

namespace asperity {

namespace {

void appendEscaped(std::string& line, char character) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    switch (character) {
    case '\n':
        line += "\\n";
        return;
    case '\r':
        line += "\\r";
        return;
    case '\t':
        line += "\\t";
        return;
    case '\x1b':
        line += "\\e";
        return;
    default:
        break;
    }
    const auto byte = static_cast<unsigned char>(character);
    line += "\\x";
    line += kDigits[byte >> 4U];
    line += kDigits[byte & 0xFU];
}

/// Facts that a lead byte announces.
struct Lead {
    std::size_t length = 0;  ///< of the sequence; 0: no sequence begins like this
    char32_t bits = 0;       ///< those of the code point that it holds
    char32_t minimum = 0;    ///< below it the form is overlong
};

Lead leadOf(unsigned char byte) {
    if (byte < 0x80U) {
        return {1, byte, 0};
    }
    if (byte >= 0xC2U && byte < 0xE0U) {
        return {2, byte & 0x1FU, 0x80};
    }
    if (byte >= 0xE0U && byte < 0xF0U) {
        return {3, byte & 0x0FU, 0x800};
    }
    if (byte >= 0xF0U && byte < 0xF5U) {
        return {4, byte & 0x07U, 0x10000};
    }
    return {};
}

/// Returns whether a byte of valid UTF-8 continues a character.
bool isWithinCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

constexpr std::string_view kScheme = "file://";  // what follows begins with the path's own slash
constexpr std::string_view kHexDigits = "0123456789ABCDEF";

bool isUri(std::string_view text) {
    return text.starts_with(kScheme) && text.substr(kScheme.size()).starts_with('/');
}

/// Returns whether a byte is unescaped in a URI's path (RFC 3986, "unreserved" and the slash).
bool isPlain(char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') ||
           (byte >= '0' && byte <= '9') ||
           std::string_view("-._~/").find(byte) != std::string_view::npos;
}

std::string encoded(std::string_view bytes) {
    std::string text;
    for (const char byte : bytes) {
        if (isPlain(byte)) {
            text += byte;
        } else {
            const auto value = static_cast<unsigned char>(byte);
            text += '%';
            text += kHexDigits[value >> 4U];
            text += kHexDigits[value & 0xFU];
        }
    }
    return text;
}

/// 16 for what is no hexadecimal digit.
unsigned digitValue(char digit) {
    const char upper = digit >= 'a' && digit <= 'f' ? static_cast<char>(digit - 'a' + 'A') : digit;
    const std::size_t value = kHexDigits.find(upper);
    return value == std::string_view::npos ? 16U : static_cast<unsigned>(value);
}

/// Empty when an escape is damaged, or is that of NUL, which no path holds.
std::optional<std::string> decoded(std::string_view text) {
    std::string bytes;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            bytes += text[i];
            continue;
        }
        if (i + 2 >= text.size()) {
            return std::nullopt;
        }
        const unsigned high = digitValue(text[i + 1]);
        const unsigned low = digitValue(text[i + 2]);
        if (high > 15U || low > 15U || high + low == 0U) {
            return std::nullopt;
        }
        bytes += static_cast<char>(high << 4U | low);
        i += 2;
    }
    return bytes;
}

}  // namespace

bool isCommand(char32_t codePoint) {
    const bool control = codePoint < 0x20 || (codePoint >= 0x7F && codePoint < 0xA0);
    const bool breaksOrTurnsLines = (codePoint >= 0x2028 && codePoint <= 0x202E) ||
                                    (codePoint >= 0x2066 && codePoint <= 0x2069);
    return control || breaksOrTurnsLines;
}

std::string printable(std::string_view text) {
    std::string line;
    while (!text.empty()) {
        const Utf8Character character = firstCharacter(text);
        const std::size_t length = std::max<std::size_t>(character.length, 1);
        const std::string_view bytes = text.substr(0, length);
        if (character.length > 0 && !isCommand(character.codePoint)) {
            line += bytes;
        } else {
            std::ranges::for_each(bytes, [&line](char byte) { appendEscaped(line, byte); });
        }
        text.remove_prefix(length);
    }
    return line;
}

std::string printableLines(std::string_view text) {
    std::string lines;
    for (std::size_t end = text.find('\n'); end != std::string_view::npos; end = text.find('\n')) {
        lines += printable(text.substr(0, end)) + '\n';
        text.remove_prefix(end + 1);
    }
    return lines + printable(text);
}

Utf8Character firstCharacter(std::string_view text) {
    constexpr char32_t kMax = 0x10FFFF;
    const Lead lead = leadOf(static_cast<unsigned char>(text.front()));
    if (lead.length == 0 || lead.length > text.size()) {
        return {};
    }
    char32_t codePoint = lead.bits;
    for (std::size_t i = 1; i < lead.length; ++i) {
        const auto byte = static_cast<unsigned char>(text[i]);
        if ((byte & 0xC0U) != 0x80U) {
            return {};
        }
        codePoint = (codePoint << 6U) | (byte & 0x3FU);
    }
    const bool surrogate = codePoint >= 0xD800 && codePoint <= 0xDFFF;
    if (codePoint < lead.minimum || codePoint > kMax || surrogate) {
        return {};
    }
    return {lead.length, codePoint};
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = firstCharacter(text).length;
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

std::string_view utf8Start(std::string_view text, std::size_t most) {
    std::size_t end = std::min(most, text.size());
    while (end > 0 && end < text.size() && isWithinCharacter(text[end])) {
        --end;
    }
    return text.substr(0, end);
}

std::string shortened(std::string_view text, std::size_t most) {
    constexpr std::string_view kGap = " … ";
    if (text.size() <= most) {
        return std::string(text);
    }
    const std::size_t room = most - kGap.size();
    const std::size_t endBytes = room / 4;
    std::size_t end = text.size() - endBytes;
    while (end < text.size() && isWithinCharacter(text[end])) {
        ++end;
    }
    return std::string(utf8Start(text, room - endBytes)) + std::string(kGap) +
           std::string(text.substr(end));
}

void appendUtf8(std::string& text, char32_t codePoint) {
    const auto follow = [&](unsigned shift) {
        text += static_cast<char>(0x80U | ((codePoint >> shift) & 0x3FU));
    };
    if (codePoint < 0x80U) {
        text += static_cast<char>(codePoint);
    } else if (codePoint < 0x800U) {
        text += static_cast<char>(0xC0U | (codePoint >> 6U));
        follow(0);
    } else if (codePoint < 0x10000U) {
        text += static_cast<char>(0xE0U | (codePoint >> 12U));
        follow(6);
        follow(0);
    } else {
        text += static_cast<char>(0xF0U | (codePoint >> 18U));
        follow(12);
        follow(6);
        follow(0);
    }
}

std::string pathText(const std::filesystem::path& path) {
    const std::string& bytes = path.native();
    if (isUtf8(bytes) && !isUri(bytes)) {
        return bytes;
    }
    return std::string(kScheme) + encoded(std::filesystem::absolute(path).native());
}

std::optional<std::filesystem::path> pathFromText(std::string_view text) {
    if (!isUri(text)) {
        return std::filesystem::path(text);
    }
    const std::optional<std::string> bytes = decoded(text.substr(kScheme.size()));
    return bytes ? std::optional<std::filesystem::path>(*bytes) : std::nullopt;
}

}  // namespace asperity
