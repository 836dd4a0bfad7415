#pragma once

#include <span>
#include <string>

namespace asperity {

/// How wide journals print a figure.
struct JournalColumn {
    const char* name;
    double width;  ///< [mm]
};

/// All that are known.
[[nodiscard]] std::span<const JournalColumn> journalColumns();
/// @throw Error naming those that there are
[[nodiscard]] const JournalColumn& journalColumn(const std::string& name);
/// For people: "single (85 mm), ...".
[[nodiscard]] std::string journalColumnList();

}  // namespace asperity
