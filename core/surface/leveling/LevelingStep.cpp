#include "core/surface/leveling/LevelingStep.h"

#include <algorithm>

namespace asperity {

namespace {

std::string_view trimmed(std::string_view word) {
    const auto isSpace = [](char c) { return c == ' ' || c == '\t'; };
    while (!word.empty() && isSpace(word.front())) {
        word.remove_prefix(1);
    }
    while (!word.empty() && isSpace(word.back())) {
        word.remove_suffix(1);
    }
    return word;
}

}  // namespace

std::string textOf(const LevelingSteps& steps) {
    std::string text;
    for (const LevelingStep step : steps) {
        text += (text.empty() ? "" : ", ") + std::string(keyOf(step));
    }
    return text.empty() ? kNoLeveling : text;
}

std::optional<LevelingSteps> levelingSteps(std::string_view text) {
    if (trimmed(text) == kNoLeveling) {
        return LevelingSteps();
    }
    LevelingSteps steps;
    for (bool last = false; !last;) {
        const std::size_t comma = text.find(',');
        last = comma == std::string_view::npos;
        const auto step = fromKey<LevelingStep>(trimmed(text.substr(0, comma)));
        if (!step) {
            return std::nullopt;
        }
        steps.push_back(*step);
        text.remove_prefix(last ? text.size() : comma + 1);
    }
    return steps;
}

std::string levelingKeys() { return keyList<LevelingStep>() + " or " + kNoLeveling; }

std::string refusalOf(const LevelPoints& points) {
    constexpr double kMinHeight = 1e-6;  // of the triangle, of its longest side
    if (!std::ranges::all_of(points, isFinite)) {
        return "three_point needs points that are finite numbers of meters";
    }
    double longest = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        longest = std::max(longest, (points[(i + 1) % points.size()] - points[i]).norm());
    }
    const Vector2 along = points[1] - points[0];
    const Vector2 other = points[2] - points[0];
    const double twiceArea = std::abs(along.x() * other.y() - along.y() * other.x());
    if (!(twiceArea > kMinHeight * longest * longest)) {
        return "three_point needs three points that do not lie on one line";
    }
    return "";
}

}  // namespace asperity
