#include "app/recording/RunDifferences.h"

#include "core/FormattedText.h"
#include "core/scene/SceneFields.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <string_view>
#include <type_traits>
#include <utility>

namespace asperity {

namespace {

/// A key of a scene or a knob, and its value for people.
struct NamedValue {
    std::string name;
    std::string value;
};

std::string numberText(double value, const char* unit, double scale) {
    return *unit == '\0' ? formatted("%.6g", value / scale)
                         : formatted("%.6g %s", value / scale, unit);
}

std::string switchText(bool isOn) { return formatted("%s", isOn ? "on" : "off"); }

std::string textOf(const SceneField& field, const SceneValue& value) {
    if (const auto* const number = std::get_if<double>(&value)) {
        return numberText(*number, field.words.unit, field.words.scale);
    }
    if (const auto* const isOn = std::get_if<bool>(&value)) {
        return switchText(*isOn);
    }
    const auto& text = std::get<std::string>(value);
    const auto named = std::ranges::find(field.choices, text, &SceneChoice::key);
    if (named != field.choices.end()) {
        return named->name;
    }
    return text.empty() ? formatted("none") : text;
}

template <class Value>
std::string textOf(const SettingField& field, const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        return keyOf(value);
    } else if constexpr (std::is_same_v<Value, bool>) {
        return switchText(value);
    } else {
        return numberText(static_cast<double>(value), field.words.unit, field.words.scale);
    }
}

/// Told by the name of the scan; its file may be the same one elsewhere.
bool isOfScan(const SceneField& field) {
    return field.input == SceneInput::File ||
           (field.group == SceneGroup::Sample && std::string_view(field.key) == "channel");
}

/// All that the force can follow from, but the scan.
std::vector<NamedValue> valuesOf(const SceneDescription& scene) {
    std::vector<NamedValue> values;
    for (const SceneField& field : sceneFields()) {
        if (field.group != SceneGroup::View && !isOfScan(field)) {
            values.push_back({formatted("%s, %s", nameOf(field.group), field.words.caption),
                              textOf(field, field.get(scene))});
        }
    }
    listSettings(scene.settings, [&values](const SettingField& field, const auto& value) {
        if (field.key != nullptr && field.words.group != SettingGroup::Hidden) {
            values.push_back({formatted("%s, %s", nameOf(field.words.group), field.words.caption),
                              textOf(field, value)});
        }
    });
    return values;
}

}  // namespace

RunConditions conditionsOf(const LoadedScene& loaded) {
    return {.scene = loaded.scene.description, .sha256 = loaded.sha256};
}

std::vector<std::string> differencesOf(const RunConditions& first, const RunConditions& second) {
    std::vector<std::string> differences;
    const auto tell = [&differences](const std::string& name, const std::string& one,
                                     const std::string& other) {
        std::string text = name;
        differences.push_back(text.append(": ").append(one).append(" → ").append(other));
    };
    if (first.sha256 != second.sha256 ||
        first.scene.sample.channel != second.scene.sample.channel) {
        tell("Scan", sampleName(first.scene.sample), sampleName(second.scene.sample));
    }
    const std::vector<NamedValue> ones = valuesOf(first.scene);
    const std::vector<NamedValue> others = valuesOf(second.scene);
    for (std::size_t i = 0; i < ones.size(); ++i) {
        if (ones[i].value != others[i].value) {
            tell(ones[i].name, ones[i].value, others[i].value);
        }
    }
    return differences;
}

}  // namespace asperity
