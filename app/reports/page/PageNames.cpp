#include "app/reports/page/PageNames.h"

#include "core/PrintableText.h"
#include "core/Utf8.h"

#include <algorithm>
#include <cctype>
#include <string_view>
#include <system_error>

namespace asperity {

namespace {

constexpr std::size_t kLongest = 100;  // bytes, so that a file system takes it with its suffix

bool isKept(const Utf8Character& character) {
    if (character.codePoint >= 0x80) {
        return !isCommand(character.codePoint);
    }
    const int letter = static_cast<int>(character.codePoint);
    return std::isalnum(letter) != 0 || letter == '.' || letter == '-' || letter == '_';
}

std::string fileNameOf(std::string_view text) {
    std::string name;
    while (!text.empty() && name.size() < kLongest) {
        const Utf8Character character = firstCharacter(text);
        const std::size_t length = std::max<std::size_t>(1, character.length);
        if (character.length > 0 && isKept(character)) {
            name += text.substr(0, length);
        } else {
            name += '_';
        }
        text.remove_prefix(length);
    }
    if (name.empty() || name.front() == '.' || name.front() == '-') {
        name.insert(0, "run");  // neither hidden nor an option
    }
    return name;
}

std::string inSmallLetters(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char letter) {
        return static_cast<char>(std::tolower(letter));
    });
    return text;
}

}  // namespace

std::string PageNames::nameFor(const std::filesystem::path& folder) {
    std::error_code unknown;
    std::filesystem::path whole = std::filesystem::absolute(folder, unknown).lexically_normal();
    if (!whole.has_filename()) {
        whole = whole.parent_path();  // "run/"
    }
    const std::string first = fileNameOf(whole.filename().string());
    std::string name = first;
    for (int number = 2; !taken_.insert(inSmallLetters(name)).second; ++number) {
        name = first + "_" + std::to_string(number);
    }
    return name;
}

}  // namespace asperity
