#include "app/reports/page/Base64.h"

#include <cstdint>

namespace asperity {

std::string base64(std::string_view bytes) {
    static constexpr std::string_view kDigits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const auto byteAt = [&](std::size_t place) {
            return place < bytes.size() ? static_cast<std::uint8_t>(bytes[place]) : 0U;
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

}  // namespace asperity
