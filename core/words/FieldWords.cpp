#include "core/words/FieldWords.h"

#include "core/FormattedText.h"

#include <algorithm>
#include <cctype>

namespace asperity {

namespace {

/// What is told before a caption that other groups have, too.
std::string ownerOf(SceneGroup group) {
    switch (group) {
    case SceneGroup::Tip:
        return "Tip";
    case SceneGroup::Probe:
        return "Lever";
    case SceneGroup::Truth:
        return "True";
    case SceneGroup::Shape:
        return "Shape";
    case SceneGroup::Uncertainty:
        return "Deviation of";
    default:
        return {};
    }
}

/// "Young's modulus", "InvOLS" and "Q factor" keep their capital.
std::string within(const std::string& caption) {
    const bool isName = caption.find("'s ") != std::string::npos || caption.size() < 2 ||
                        std::isupper(static_cast<unsigned char>(caption[1])) != 0 ||
                        caption[1] == ' ' || caption.starts_with("InvOLS");
    std::string text = caption;
    if (!isName) {
        text[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(text[0])));
    }
    return text;
}

std::string valueText(const SceneField& field, const SceneValue& value) {
    if (const auto* const number = std::get_if<double>(&value)) {
        const std::string unit = field.words.unit;
        return formatted("%.6g", *number / field.words.scale) +
               (unit.empty() || unit == "°" ? unit : " " + unit);
    }
    if (const auto* const on = std::get_if<bool>(&value)) {
        return *on ? "on" : "off";
    }
    const std::string& text = std::get<std::string>(value);
    const auto choice = std::ranges::find(field.choices, text, &SceneChoice::key);
    return choice == field.choices.end() ? text : choice->name;
}

}  // namespace

std::string valueText(const SceneField& field, const SceneDescription& scene) {
    return valueText(field, field.get(scene));
}

std::string changeText(const SceneField& field, const SceneDescription& scene) {
    const std::string owner = ownerOf(field.group);
    const std::string caption = field.words.caption;
    const bool isAlone = owner.empty() || owner == caption;
    return (isAlone ? caption : owner + " " + within(caption)) + ": " + valueText(field, scene);
}

}  // namespace asperity
