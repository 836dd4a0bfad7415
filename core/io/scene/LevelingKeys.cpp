#include "core/io/scene/LevelingKeys.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr const char* kLevel = "level";
constexpr const char* kPoints = "level_points_m";

LevelingSteps stepsOf(const TomlSection& section, const std::vector<std::string>& texts) {
    if (texts.size() == 1 && texts.front() == kNoLeveling) {
        return {};
    }
    LevelingSteps steps;
    for (const std::string& text : texts) {
        const auto step = fromKey<LevelingStep>(text);
        if (!step) {
            section.refuse(kLevel, text == kNoLeveling
                                       ? "'none' alone, or a list of steps without it"
                                       : "steps of " + levelingKeys() + ", not '" + text + "'");
        }
        steps.push_back(*step);
    }
    return steps;
}

toml::array pairOf(const Vector2& point) { return toml::array{point.x(), point.y()}; }

}  // namespace

void readLeveling(TomlSection& section, SampleDescription& sample) {
    if (const auto texts = section.texts(kLevel)) {
        sample.leveling = stepsOf(section, *texts);
    }
    const std::vector<Vector2> places = section.places(kPoints);
    if (!section.has(kPoints)) {
        return;
    }
    LevelPoints points;
    if (places.size() != points.size()) {
        section.refuse(kPoints, "three places, [[x, y], [x, y], [x, y]]");
    }
    std::ranges::copy(places, points.begin());
    sample.levelPoints = points;
}

void insertLeveling(const SampleDescription& sample, toml::table& table) {
    if (sample.leveling.size() == 1) {
        table.insert(kLevel, keyOf(sample.leveling.front()));
    } else if (sample.leveling.empty()) {
        table.insert(kLevel, kNoLeveling);
    } else {
        toml::array steps;
        for (const LevelingStep step : sample.leveling) {
            steps.push_back(keyOf(step));
        }
        table.insert(kLevel, std::move(steps));
    }
    if (sample.levelPoints) {
        const auto& [first, second, third] = *sample.levelPoints;
        table.insert(kPoints, toml::array{pairOf(first), pairOf(second), pairOf(third)});
    }
}

}  // namespace asperity
