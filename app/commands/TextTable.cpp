#include "app/commands/TextTable.h"

#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <iomanip>
#include <iostream>
#include <sstream>

namespace asperity {

namespace {

/// Characters on the screen: continuation bytes of UTF-8 take no room.
std::size_t shownWidth(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

}  // namespace

void printTable(std::vector<TableRow> rows, std::size_t texts) {
    for (TableRow& row : rows) {
        std::ranges::transform(row, row.begin(), printable);
    }
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const TableRow& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], shownWidth(row[i]));
        }
    }
    for (const TableRow& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string padding(widths[i] - shownWidth(row[i]), ' ');
            line += (i == 0 ? "" : "  ") + (i < texts ? row[i] + padding : padding + row[i]);
        }
        std::cout << line << '\n';
    }
}

std::string quantityText(double value, const std::string& unit) {
    const PhysicalUnit known = parseUnit(unit);  // "mV" must not become "mmV"
    if (!known.base.empty()) {
        return formatSi(value * known.factor, known.base.c_str());
    }
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

}  // namespace asperity
