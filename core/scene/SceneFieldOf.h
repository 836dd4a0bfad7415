#pragma once

#include "core/scene/SceneFields.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>

namespace asperity {

/// The rows of a scene's fields from the member with the value: `access` is a lambda without
/// captures from a scene to its member.
namespace scene_field {

// Units in which people see fields, and their own [SI].
inline constexpr double kNano = 1e-9;
inline constexpr double kMicro = 1e-6;
inline constexpr double kDegree = std::numbers::pi / 180.0;  ///< [rad]

template <class Value>
inline constexpr bool kIsOptional = false;
template <class Value>
inline constexpr bool kIsOptional<std::optional<Value>> = true;

template <HasEnumTable Value>
std::vector<SceneChoice> choicesOf(bool open) {
    std::vector<SceneChoice> choices;
    if (open) {
        choices.push_back({kLeftOpen, "automatic"});
    }
    for (const auto& row : kEnumTable<Value>) {
        std::string name = row.name;
        std::ranges::replace(name, '_', ' ');
        choices.push_back({row.key, name});
    }
    return choices;
}

/// Returns the name of a value, or the value itself, whatever its type.
template <class Value>
SceneValue shown(const Value& value) {
    if constexpr (kIsOptional<Value>) {
        using Inner = typename Value::value_type;
        if constexpr (std::is_same_v<Inner, double>) {
            return value.value_or(0.0);
        } else if constexpr (std::is_same_v<Inner, bool>) {
            return std::string(!value ? kLeftOpen : (*value ? "on" : "off"));
        } else {
            return std::string(value ? keyOf(*value) : kLeftOpen);
        }
    } else if constexpr (std::is_enum_v<Value>) {
        return std::string(keyOf(value));
    } else if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::string>) {
        return value;
    } else {
        return static_cast<double>(value);
    }
}

/// 0: the number is not known; a key that is none of the list changes nothing.
template <class Value>
void take(Value& value, const SceneValue& given) {
    if constexpr (kIsOptional<Value>) {
        using Inner = typename Value::value_type;
        if constexpr (std::is_same_v<Inner, double>) {
            const double number = std::get<double>(given);
            value = number == 0.0 ? std::nullopt : std::optional(number);
        } else if (std::get<std::string>(given) == kLeftOpen) {
            value = std::nullopt;
        } else if constexpr (std::is_same_v<Inner, bool>) {
            value = std::get<std::string>(given) == "on";
        } else {
            value = fromKey<Inner>(std::get<std::string>(given));
        }
    } else if constexpr (std::is_enum_v<Value>) {
        value = fromKey<Value>(std::get<std::string>(given)).value_or(value);
    } else if constexpr (std::is_same_v<Value, bool> || std::is_same_v<Value, std::string>) {
        value = std::get<Value>(given);
    } else {
        value = static_cast<Value>(std::get<double>(given));
    }
}

template <class Value>
constexpr SceneInput inputOf() {
    if constexpr (std::is_same_v<Value, bool>) {
        return SceneInput::Switch;
    } else if constexpr (std::is_same_v<Value, std::string>) {
        return SceneInput::Text;
    } else if constexpr (std::is_same_v<Value, double> ||
                         std::is_same_v<Value, std::optional<double>>) {
        return SceneInput::Number;
    } else if constexpr (std::is_integral_v<Value>) {
        return SceneInput::Whole;
    } else {
        return SceneInput::Choice;
    }
}

template <class Value>
std::vector<SceneChoice> listOf() {
    if constexpr (std::is_same_v<Value, std::optional<bool>>) {
        return {{kLeftOpen, "automatic"}, {"on", "on"}, {"off", "off"}};
    } else if constexpr (kIsOptional<Value>) {
        if constexpr (HasEnumTable<typename Value::value_type>) {
            return choicesOf<typename Value::value_type>(true);
        }
    } else if constexpr (std::is_enum_v<Value>) {
        return choicesOf<Value>(false);
    }
    return {};
}

/// A row by the type of the value.
template <class Access>
SceneField at(SceneGroup group, const char* key, const SceneWords& words, const Limits& limits,
              Access /*access*/) {
    using Value = std::decay_t<decltype(Access{}(std::declval<SceneDescription&>()))>;
    return {.group = group,
            .key = key,
            .words = words,
            .limits = limits,
            .input = inputOf<Value>(),
            .choices = listOf<Value>(),
            .get = [](const SceneDescription& scene) { return shown(Access{}(scene)); },
            .set = [](SceneDescription& scene,
                      const SceneValue& value) { take(Access{}(scene), value); },
            .isStated =
                [](const SceneDescription& scene) {
                    if constexpr (std::is_same_v<Value, std::optional<double>>) {
                        return Access{}(scene).has_value();
                    }
                    return true;
                }};
}

/// A row of a value that lies in members of a scene, one in the other.
template <auto... Members>
SceneField at(SceneGroup group, const char* key, const SceneWords& words, const Limits& limits) {
    return at(
        group, key, words, limits, [](auto& scene) -> auto& { return (scene.*....*Members); });
}

}  // namespace scene_field

}  // namespace asperity
