#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace asperity {

/// One row of a table for people.
using TableRow = std::vector<std::string>;

/// Prints a table on standard output, its title first: columns as wide as their widest cell, texts
/// to the left, numbers to the right.
/// @param rows with the same number of cells each; made printable()
/// @param texts columns from the left that hold texts
void printTable(std::vector<TableRow> rows, std::size_t texts);

/// Returns a value in its unit with a prefix, "12.5 nm"; one without unit as a number. A unit with
/// a prefix of its own is taken as it is meant.
[[nodiscard]] std::string quantityText(double value, const std::string& unit);

}  // namespace asperity
