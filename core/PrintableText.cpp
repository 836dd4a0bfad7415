#include "core/PrintableText.h"

#include "core/Utf8.h"

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

}  // namespace asperity
