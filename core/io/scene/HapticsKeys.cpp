#include "core/io/scene/HapticsKeys.h"

#include "core/io/scene/NamedChoice.h"
#include "core/scene/SettingFields.h"

#include <cmath>
#include <limits>
#include <type_traits>

namespace asperity {

namespace {

/// Here and not with the other ranges: a description holds whole numbers only.
int readButton(TomlSection& section, const char* key, int otherwise) {
    const double button = section.number(key, otherwise);
    if (!(button >= kNoButton && button <= kLastButton) || button != std::floor(button)) {
        section.refuse(key, "a whole number from 0 to 31, or -1 for none");
    }
    return static_cast<int>(button);
}

template <class Value>
Value readSetting(TomlSection& section, const char* key, Value otherwise) {
    if constexpr (HasEnumTable<Value>) {
        return choice(section, key, otherwise);
    } else if constexpr (std::is_same_v<Value, int>) {
        return readButton(section, key, otherwise);
    } else {
        return static_cast<Value>(section.number(key, otherwise));
    }
}

/// A direction of any length; one of unit length keeps its bits.
Vector3 unitAxis(const TomlSection& section, const Vector3& axis) {
    const double length = axis.stableNorm();
    if (!(length > 0.0 && std::isfinite(length))) {
        section.refuse("guide_axis_z", "with guide_axis_x and guide_axis_y a direction, not 0");
    }
    const bool isUnit = std::abs(length - 1.0) <= 4.0 * std::numeric_limits<double>::epsilon();
    return isUnit ? axis : Vector3(axis / length);
}

}  // namespace

void readHaptics(TomlSection section, SceneDescription& scene) {
    scene.tickRate = section.number("rate_hz", scene.tickRate);
    listSettings(scene.settings, [&section](const SettingField& field, auto& value) {
        if (field.key != nullptr) {
            value = readSetting(section, field.key, value);
        }
    });
    scene.settings.guide.axis = unitAxis(section, scene.settings.guide.axis);
    section.refuseUnknownKeys();
}

toml::table hapticsTable(const SceneDescription& scene) {
    toml::table table{{"rate_hz", scene.tickRate}};
    listSettings(scene.settings, [&table](const SettingField& field, const auto& value) {
        if (field.key == nullptr) {
            return;
        }
        if constexpr (HasEnumTable<std::decay_t<decltype(value)>>) {
            table.insert(field.key, keyOf(value));
        } else {
            table.insert(field.key, value);
        }
    });
    return table;
}

}  // namespace asperity
