#include "core/PathText.h"

#include "core/Utf8.h"

namespace asperity {

namespace {

constexpr std::string_view kScheme = "file://";  // what follows begins with the path's own slash
constexpr std::string_view kHexDigits = "0123456789ABCDEF";

bool isUri(std::string_view text) {
    return text.starts_with(kScheme) && text.substr(kScheme.size()).starts_with('/');
}

/// Whether a byte stands for itself in a URI's path (RFC 3986, "unreserved" and the slash).
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

/// Empty when an escape is damaged, or stands for NUL, which no path holds.
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
