#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>

namespace asperity {

/// The usual row of an enum: a value with its key and name.
template <class Value>
struct EnumRow {
    Value value;
    const char* key;         ///< in files, logs and options
    const char* name = key;  ///< for people
};

/// The same of a value that no file calls by a key.
template <class Value>
struct NamedRow {
    Value value;
    const char* name;
};

/// The rows of an enum, in the order in which lists show them; it is beside the enum, which
/// specializes this with an array. A row has `value`, `key`, `name`, or what else there is to say.
template <class Value>
inline constexpr auto kEnumTable = nullptr;

template <class Value>
concept HasEnumTable = requires {
    kEnumTable<Value>.size();
};

/// The values of an enum, in the order of its table.
template <HasEnumTable Value>
inline constexpr auto kValues = [] {
    std::array<Value, kEnumTable<Value>.size()> values{};
    std::ranges::transform(kEnumTable<Value>, values.begin(), [](auto row) { return row.value; });
    return values;
}();

/// Returns whether an enum has such a value: only then does the compiler know it by a name.
template <auto value>
[[nodiscard]] consteval bool isNamed() {
    constexpr std::string_view kBefore = "value = ";
    const std::string_view text = __PRETTY_FUNCTION__;
    return text[text.rfind(kBefore) + kBefore.size()] != '(';
}

/// Returns whether each value of an enum, which count from 0, has a row.
template <class Value>
[[nodiscard]] consteval bool isComplete() {
    constexpr std::size_t kRows = kEnumTable<Value>.size();
    for (std::size_t i = 0; i < kRows; ++i) {
        if (std::ranges::count(kValues<Value>, static_cast<Value>(i)) != 1) {
            return false;
        }
    }
    return std::is_same_v<Value, bool> || !isNamed<static_cast<Value>(kRows)>();
}

/// Returns the row of a value; null where the table has none.
template <HasEnumTable Value>
[[nodiscard]] constexpr const auto* rowOf(Value value) noexcept {
    static_assert(isComplete<Value>());
    for (const auto& row : kEnumTable<Value>) {
        if (row.value == value) {
            return &row;
        }
    }
    return static_cast<decltype(kEnumTable<Value>.data())>(nullptr);
}

/// Returns its key in files, logs and options: "near_singular".
template <HasEnumTable Value>
[[nodiscard]] constexpr const char* keyOf(Value value) noexcept {
    const auto* const row = rowOf(value);
    return row != nullptr ? row->key : "unknown";
}

/// Returns the name for people: "van der Waals tail".
template <HasEnumTable Value>
[[nodiscard]] constexpr const char* nameOf(Value value) noexcept {
    const auto* const row = rowOf(value);
    return row != nullptr ? row->name : "unknown";
}

/// The value of a key; none where it is no value's.
template <HasEnumTable Value>
[[nodiscard]] constexpr std::optional<Value> fromKey(std::string_view key) noexcept {
    for (const auto& row : kEnumTable<Value>) {
        if (key == row.key) {
            return row.value;
        }
    }
    return std::nullopt;
}

/// All keys for people: "plane, rows, none".
template <HasEnumTable Value>
[[nodiscard]] std::string keyList() {
    std::string list;
    for (const auto& row : kEnumTable<Value>) {
        list += (list.empty() ? "" : ", ") + std::string(row.key);
    }
    return list;
}

}  // namespace asperity
