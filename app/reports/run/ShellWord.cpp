#include "app/reports/run/ShellWord.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace asperity {

std::string shellWord(const std::string& text) {
    constexpr std::string_view kPlain = "/._-+=:,@";
    const bool isPlain = !text.empty() && std::ranges::all_of(text, [&](unsigned char byte) {
        return byte >= 0x80 || std::isalnum(byte) != 0 ||
               kPlain.find(static_cast<char>(byte)) != std::string_view::npos;
    });
    if (isPlain) {
        return text;
    }
    std::string word = "'";
    for (const char byte : text) {
        word += byte == '\'' ? std::string("'\\''") : std::string(1, byte);
    }
    return word + "'";
}

}  // namespace asperity
