#include "core/io/Base64.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <openssl/evp.h>
#include <vector>

namespace asperity {

namespace {

constexpr std::size_t kGroup = 4;       // letters
constexpr std::size_t kGroupBytes = 3;  // that they encode

/// Decodes letters whose padding, if they have any, is at their end.
bool appendPart(std::string& bytes, std::string_view letters) {
    // The library counts padding as bytes, wherever it is.
    constexpr std::size_t kMaxPadding = 2;
    const std::size_t digits = letters.find_last_not_of('=') + 1;
    const std::size_t padding = letters.size() - digits;
    if (padding > kMaxPadding || letters.substr(0, digits).find('=') != std::string_view::npos) {
        return false;
    }
    std::vector<unsigned char> part(kGroupBytes * letters.size() / kGroup);
    const int count =
        EVP_DecodeBlock(part.data(), reinterpret_cast<const unsigned char*>(letters.data()),
                        static_cast<int>(letters.size()));
    if (count < 0) {
        return false;
    }
    bytes.append(part.begin(), part.end() - static_cast<std::ptrdiff_t>(padding));
    return true;
}

}  // namespace

std::string base64(std::string_view bytes) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byteAt = [&](std::size_t offset) {
            return offset < bytes.size() ? static_cast<std::uint8_t>(bytes[offset]) : 0U;
        };
        const std::uint32_t three =
            byteAt(i) << 16U | byteAt(i + 1) << 8U | static_cast<std::uint32_t>(byteAt(i + 2));
        for (std::size_t digit = 0; digit < 4; ++digit) {
            const bool isThere = i + digit <= bytes.size();
            text += isThere ? kDigits[three >> (18U - 6U * digit) & 63U] : '=';
        }
    }
    return text;
}

bool appendBase64(std::string& bytes, std::string_view letters) {
    constexpr std::size_t kMaxLetters = std::size_t{1} << 20U;  // at a time
    if (letters.size() % kGroup != 0) {
        return false;
    }
    while (!letters.empty()) {
        const std::size_t padding = letters.find('=');
        const std::size_t end =
            std::min({padding == std::string_view::npos ? letters.size()
                                                        : padding - padding % kGroup + kGroup,
                      kMaxLetters});
        if (!appendPart(bytes, letters.substr(0, end))) {
            return false;
        }
        letters.remove_prefix(end);
    }
    return true;
}

}  // namespace asperity
