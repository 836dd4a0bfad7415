#include "core/Utf8.h"

#include <algorithm>

namespace asperity {

namespace {

/// What a lead byte promises.
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

/// Whether a byte of valid UTF-8 continues a character.
bool isWithinCharacter(char byte) { return (static_cast<unsigned char>(byte) & 0xC0U) == 0x80U; }

}  // namespace

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

}  // namespace asperity
