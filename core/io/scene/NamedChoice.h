#pragma once

#include "core/EnumTable.h"
#include "core/io/scene/TomlFile.h"

#include <optional>
#include <string>

namespace asperity {

/// How files call a choice that is left to the program.
inline constexpr const char* kAutomatic = "auto";

/// How they call a switch, where it is a choice with kAutomatic.
template <>
inline constexpr auto kEnumTable<bool> = std::to_array<EnumRow<bool>>({{true, "on"},
                                                                       {false, "off"}});

template <class Value>
const char* keyOf(const std::optional<Value>& value) {
    return value ? keyOf(*value) : kAutomatic;
}

/// @throw InputError naming what is known
[[noreturn]] inline void refuseChoice(TomlSection& section, const std::string& key,
                                      const std::string& known) {
    section.refuse(key, "one of " + known + ", not '" + section.text(key, "") + "'");
}

/// @throw InputError when the section names another value than those of its table
template <class Value>
Value choice(TomlSection& section, const std::string& key, Value otherwise) {
    const auto value = fromKey<Value>(section.text(key, keyOf(otherwise)));
    if (!value) {
        refuseChoice(section, key, keyList<Value>());
    }
    return *value;
}

/// A choice that may be left to the program; none: it is. @throw InputError as choice()
template <class Value>
std::optional<Value> choiceOrNone(TomlSection& section, const std::string& key,
                                  const std::optional<Value>& otherwise) {
    const std::string given = section.text(key, keyOf(otherwise));
    const auto value = fromKey<Value>(given);
    if (!value && given != kAutomatic) {
        refuseChoice(section, key, kAutomatic + (", " + keyList<Value>()));
    }
    return value;
}

}  // namespace asperity
