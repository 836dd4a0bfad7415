#pragma once

#include "core/Error.h"
#include "core/contact/laws/ContactModel.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/tables/CsvTable.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Settings.h"
#include "core/scene/TickOutput.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <type_traits>

namespace asperity::stored {

/// Returns whether a number is a whole one from `least` to `largest`.
inline bool isWhole(double number, double least, double largest) {
    return number >= least && number <= largest && number == std::floor(number);
}

/// Returns whether a number in a table is valid for the type of `Value`: tables hold numbers only.
template <typename Value>
bool standsFor(double number) {
    if constexpr (std::is_same_v<Value, double>) {
        return std::isfinite(number);
    } else if constexpr (std::is_same_v<Value, bool>) {
        return isWhole(number, 0.0, 1.0);
    } else if constexpr (std::is_same_v<Value, ContactBranch>) {
        return isWhole(number, 0.0, static_cast<double>(ContactBranch::Bonded));
    } else if constexpr (HasEnumTable<Value>) {
        return std::ranges::any_of(
            kValues<Value>, [number](Value value) { return number == static_cast<double>(value); });
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
        return isWhole(number, 0.0, static_cast<double>(kMaxContactPoints));
    } else if constexpr (std::is_same_v<Value, int>) {
        return isWhole(number, kNoButton, kLastButton);
    } else {
        static_assert(std::is_same_v<Value, std::uint32_t>);
        return isWhole(number, 0.0, std::numeric_limits<std::uint32_t>::max());
    }
}

/// Returns the condition for a `Value` in a column that the number fails; null: it meets it.
template <class Value>
const char* objection(Holds holds, double number) {
    const bool isEnd = holds == Holds::Endless && number == std::numeric_limits<double>::infinity();
    if (holds == Holds::Told || isEnd) {
        return nullptr;
    }
    if (holds == Holds::Stored || holds == Holds::Endless) {
        return standsFor<Value>(number) ? nullptr : "a number as Asperity writes it";
    }
    if (!std::isfinite(number)) {
        return "a finite number";
    }
    if (holds == Holds::Positive) {
        return number > 0.0 ? nullptr : "positive";
    }
    if (holds == Holds::Share) {
        return number >= 0.0 && number <= 1.0 ? nullptr : "a share from 0 to 1";
    }
    return holds == Holds::Finite || number >= 0.0 ? nullptr : "0 or more";
}

[[noreturn]] inline void refuse(const CsvTable& table, std::size_t row, const std::string& what) {
    throw InputError(table.file(), "line " + std::to_string(table.line(row)), what);
}

/// Takes over the cells of a row that addCells() wrote. @param list as in columnNames()
/// @throw InputError with the row's line
template <class List>
void readCells(const CsvTable& table, std::size_t row, const List& list) {
    list([&](const Column& column, auto& value) {
        using Value = std::decay_t<decltype(value)>;
        const std::string name = column.text();
        if (column.later && !table.has(name)) {
            return;
        }
        const double number = table.number(row, name);
        if (const char* const wanted = objection<Value>(column.holds, number)) {
            refuse(table, row, name + " must be " + wanted);
        }
        value = static_cast<Value>(number);
    });
}

}  // namespace asperity::stored
