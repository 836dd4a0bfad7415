#include "app/exports/JournalColumn.h"

#include "core/Error.h"
#include "core/FormattedText.h"

#include <algorithm>
#include <array>

namespace asperity {

namespace {

constexpr std::array<JournalColumn, 8> kColumns{{{"single", 85.0},
                                                 {"double", 174.0},
                                                 {"nature", 89.0},
                                                 {"nature-double", 183.0},
                                                 {"elsevier", 90.0},
                                                 {"elsevier-double", 190.0},
                                                 {"aps", 86.0},
                                                 {"aps-double", 178.0}}};

}  // namespace

std::span<const JournalColumn> journalColumns() { return kColumns; }

const JournalColumn& journalColumn(const std::string& name) {
    const auto* const found = std::ranges::find(kColumns, name, &JournalColumn::name);
    if (found == kColumns.end()) {
        throw Error("'" + name + "' is no column of a journal: expected one of " +
                    journalColumnList());
    }
    return *found;
}

std::string journalColumnList() {
    std::string list;
    for (const JournalColumn& column : kColumns) {
        list.append(list.empty() ? "" : ", ")
            .append(column.name)
            .append(formatted(" (%.0f mm)", column.width));
    }
    return list;
}

}  // namespace asperity
