#pragma once

#include "core/io/tables/CsvWriter.h"

#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

// A table of a recording has one list of its columns: a function that calls `cell(column, value)`
// for each, in their order. Names, cells and what is read back are made from it.

namespace asperity {

/// Values that a cell may hold when it is read back.
enum class Holds {
    Stored,       ///< the code of a value of its type
    Endless,      ///< the same, or infinity
    Finite,       ///< a finite number
    Positive,     ///< a finite number above 0
    NotNegative,  ///< a finite number, 0 or more
    Share,        ///< a number from 0 to 1
    Told,         ///< any number: what device and instrument said may be NaN, a fault that replays
};

/// A column: its name in parts, which are put together only where names count, and what it holds.
struct Column {
    std::string_view front;
    std::string_view axis = "";
    std::string_view back = "";
    Holds holds = Holds::Stored;
    bool later = false;  ///< recordings from before there was such a column read as before

    [[nodiscard]] std::string text() const { return std::string(front).append(axis).append(back); }
};

/// The three columns of a vector.
template <class Vector, class Cell>
void listVector(const Cell& cell, std::string_view front, Vector&& vector, std::string_view back) {
    cell({front, "x", back}, vector.x());
    cell({front, "y", back}, vector.y());
    cell({front, "z", back}, vector.z());
}

/// @param list calls what it is given as `cell`
template <class List>
[[nodiscard]] std::vector<std::string> columnNames(const List& list) {
    std::vector<std::string> names;
    list([&names](const Column& column, const auto& /*value*/) { names.push_back(column.text()); });
    return names;
}

/// The next cells of a row: text as it is, all else as a number. @param list as in columnNames()
template <class List>
void addCells(CsvWriter& csv, const List& list) {
    list([&csv](const Column& /*column*/, const auto& value) {
        if constexpr (std::is_convertible_v<decltype(value), std::string_view>) {
            csv.add(std::string_view(value));
        } else {
            csv.add(static_cast<double>(value));
        }
    });
}

/// The SI unit that a column's name ends in: "N/m" of "guide_stiffness_n_m"; empty: it has none.
[[nodiscard]] std::string unitOfColumn(std::string_view name);

}  // namespace asperity
