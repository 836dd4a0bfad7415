#include "core/io/scene/SceneKeys.h"

#include "core/PathText.h"
#include "core/scene/SceneFieldChange.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace asperity {

namespace {

std::string readChoice(TomlSection& section, const SceneField& field) {
    std::string given = section.text(field.key, "");
    if (!field.choices.empty() &&
        std::ranges::find(field.choices, given, &SceneChoice::key) == field.choices.end()) {
        std::string known;
        for (const SceneChoice& choice : field.choices) {
            known += (known.empty() ? "" : ", ") + choice.key;
        }
        section.refuse(field.key, "one of " + known + ", not '" + given + "'");
    }
    return given;
}

SceneValue readValue(TomlSection& section, const SceneField& field) {
    switch (field.input) {
    case SceneInput::Number:
        return readNumber(section, field, 0.0);
    case SceneInput::Whole:
        return static_cast<double>(section.count(field.key, 0));
    case SceneInput::Switch:
        return section.flag(field.key, false);
    case SceneInput::File:
        return section.path(field.key).string();
    default:
        return readChoice(section, field);
    }
}

}  // namespace

double readNumber(TomlSection& section, const SceneField& field, double otherwise) {
    const double value = section.number(field.key, otherwise);
    if (section.has(field.key) && !field.limits.hold(value)) {
        section.complain(field.key, std::string("must ") + field.limits.words);
    }
    return value;
}

void readKey(TomlSection& section, const SceneField& field, SceneDescription& scene) {
    section.allow(field.key);
    if (section.has(field.key)) {
        field.set(scene, readValue(section, field));
    }
}

void readKeys(TomlSection& section, SceneGroup group, SceneDescription& scene) {
    for (const SceneField& field : sceneFields()) {
        if (field.group != group || field.ownForm) {
            continue;
        }
        const std::string idle = whyNotOfSample(field, scene);
        if (section.has(field.key) && !idle.empty()) {
            section.complain(field.key, idle);
        }
        readKey(section, field, scene);
    }
}

void insertKey(const SceneField& field, const SceneDescription& scene, toml::table& table) {
    if (field.isStated != nullptr && !field.isStated(scene)) {
        return;
    }
    const SceneValue value = field.get(scene);
    if (const auto* const number = std::get_if<double>(&value)) {
        if (field.input == SceneInput::Whole) {
            table.insert(field.key, static_cast<std::int64_t>(*number));
        } else {
            table.insert(field.key, *number);
        }
    } else if (const auto* const on = std::get_if<bool>(&value)) {
        table.insert(field.key, *on);
    } else {
        const auto& text = std::get<std::string>(value);
        table.insert(field.key, field.input == SceneInput::File ? pathText(text) : text);
    }
}

void insertKeys(SceneGroup group, const SceneDescription& scene, toml::table& table) {
    for (const SceneField& field : sceneFields()) {
        if (field.group == group && !field.ownForm && whyNotOfSample(field, scene).empty()) {
            insertKey(field, scene, table);
        }
    }
}

}  // namespace asperity
