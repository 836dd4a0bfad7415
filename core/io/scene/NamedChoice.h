#pragma once

#include "core/EnumTable.h"
#include "core/io/scene/TomlFile.h"

#include <optional>
#include <string>

namespace asperity {

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

}  // namespace asperity
