#pragma once

#include "core/io/scene/TomlFile.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace asperity {

/// A value and how files call it.
template <class Value>
using NamedValue = std::pair<std::string_view, Value>;

/// How files call a choice that is left to the program.
inline constexpr const char* kAutomatic = "auto";

template <class Value, std::size_t Size>
using Names = std::array<NamedValue<Value>, Size>;

template <class Value, std::size_t Size>
std::string nameOf(const Names<Value, Size>& names, Value value) {
    for (const auto& [name, candidate] : names) {
        if (candidate == value) {
            return std::string(name);
        }
    }
    return {};
}

template <class Value, std::size_t Size>
std::string nameOf(const Names<Value, Size>& names, const std::optional<Value>& value) {
    return value ? nameOf(names, *value) : kAutomatic;
}

template <class Value, std::size_t Size>
std::optional<Value> valueOf(const Names<Value, Size>& names, const std::string& given) {
    for (const auto& [name, value] : names) {
        if (name == given) {
            return value;
        }
    }
    return std::nullopt;
}

/// @throw InputError naming what is known @param first names before the others
template <class Value, std::size_t Size>
[[noreturn]] void refuse(TomlSection& section, const std::string& key,
                         const Names<Value, Size>& names, std::string first = {}) {
    for (const auto& [name, value] : names) {
        first += (first.empty() ? "" : ", ") + std::string(name);
    }
    section.refuse(key, "one of " + first + ", not '" + section.text(key, "") + "'");
}

/// @throw InputError when the section names another value
template <class Value, std::size_t Size>
Value choice(TomlSection& section, const std::string& key, const Names<Value, Size>& names,
             Value otherwise) {
    const auto value = valueOf(names, section.text(key, nameOf(names, otherwise)));
    if (!value) {
        refuse(section, key, names);
    }
    return *value;
}

/// A choice that may be left to the program; none: it is. @throw InputError as choice()
template <class Value, std::size_t Size>
std::optional<Value> choiceOrNone(TomlSection& section, const std::string& key,
                                  const Names<Value, Size>& names,
                                  const std::optional<Value>& otherwise) {
    const std::string given = section.text(key, nameOf(names, otherwise));
    const auto value = valueOf(names, given);
    if (!value && given != kAutomatic) {
        refuse(section, key, names, kAutomatic);
    }
    return value;
}

}  // namespace asperity
