#pragma once

#include "core/Error.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/StoredValue.h"
#include "core/io/tables/CsvTable.h"

#include <cmath>
#include <limits>
#include <string>
#include <type_traits>

namespace asperity::stored {

/// What a number that a column holds for a `Value` must be and is not; null: it is.
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
