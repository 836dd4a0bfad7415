#include "core/io/FormerKeys.h"

#include <algorithm>
#include <set>

namespace asperity {

std::string_view currentKey(std::string_view key) noexcept {
    const auto* const renamed = std::ranges::find(kFormerKeys, key, &FormerKey::former);
    return renamed == kFormerKeys.end() ? key : renamed->current;
}

std::vector<std::string> currentKeys(std::vector<std::string> keys) {
    const std::set<std::string, std::less<>> given(keys.begin(), keys.end());
    for (std::string& key : keys) {
        const std::string_view current = currentKey(key);
        if (!given.contains(current)) {
            key = current;
        }
    }
    return keys;
}

std::string currentFlags(std::string_view flags) {
    constexpr char kBetween = '|';
    std::string text;
    while (true) {
        const std::size_t end = flags.find(kBetween);
        text += currentKey(flags.substr(0, end));
        if (end == std::string_view::npos) {
            return text;
        }
        text += kBetween;
        flags.remove_prefix(end + 1);
    }
}

}  // namespace asperity
