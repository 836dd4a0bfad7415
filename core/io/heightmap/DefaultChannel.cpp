#include "core/io/heightmap/DefaultChannel.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <initializer_list>
#include <string_view>
#include <utility>

namespace asperity {

namespace {

bool containsAny(std::string_view text, std::initializer_list<std::string_view> words) {
    return std::any_of(words.begin(), words.end(), [text](std::string_view word) {
        return text.find(word) != std::string_view::npos;
    });
}

/// Some instruments and programs give these as lengths, too. The feedback of an STM may keep a
/// current constant while it measures a topography.
bool namesOtherThanHeight(const ScanChannel& channel) {
    if (channel.isSurface) {
        return false;
    }
    const std::string name = lowerCase(channel.name);
    const bool isCurrent =
        containsAny(name, {"current"}) && !containsAny(name, {"height", "topograph"});
    return isCurrent || containsAny(name, {"deflection", "amplitude", "phase", "error", "friction",
                                           "deformation", "indentation"});
}

/// Smaller is better.
int rankOfName(const ScanChannel& channel) {
    const std::string name = lowerCase(channel.name);
    if (channel.isSurface || containsAny(name, {"sensor", "measured"})) {
        return 0;
    }
    const bool piezo =
        containsAny(name, {"height", "topograph"}) || name == "z" || name.starts_with("z ");
    return piezo ? 1 : 2;
}

int rank(const ScanChannel& channel) {
    constexpr int kNames = 3;
    if (isTopography(channel)) {
        return rankOfName(channel);
    }
    if (!mayBeTopography(channel)) {
        return 3 * kNames;
    }
    return (channel.isMask ? 2 : 1) * kNames + rankOfName(channel);
}

}  // namespace

bool isTopography(const ScanChannel& channel) {
    return channel.isHeight() && !namesOtherThanHeight(channel);
}

bool mayBeTopography(const ScanChannel& channel) {
    return channel.unit.empty() && !namesOtherThanHeight(channel);
}

std::size_t suggestDefaultChannel(const std::vector<ScanChannel>& channels,
                                  std::string_view usualDirection) {
    const auto order = [usualDirection](const ScanChannel& channel) {
        return std::pair{rank(channel),
                         !usualDirection.empty() && channel.direction != usualDirection};
    };
    const auto best = std::min_element(
        channels.begin(), channels.end(),
        [&](const ScanChannel& a, const ScanChannel& b) { return order(a) < order(b); });
    return best == channels.end() ? 0 : static_cast<std::size_t>(best - channels.begin());
}

}  // namespace asperity
