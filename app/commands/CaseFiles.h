#pragma once

#include "core/Progress.h"

#include <CLI/CLI.hpp>
#include <functional>
#include <ostream>
#include <string>

namespace asperity {

/// Files of a command that works through a table of cases.
struct CaseFiles {
    std::string cases;
    std::string out;  ///< empty: standard output
};

/// The options --cases and --out.
void addCaseFiles(CLI::App& command, CaseFiles& files);

/// The option --out for a table.
void addTableFile(CLI::App& command, std::string& out);

/// Writes a table to a stream. @param progress may be null; cancels it
using TableWriting = std::function<void(std::ostream&, Progress* progress)>;

/// Refuses a file that cannot be written, or is one of the inputs, before long work is done for it;
/// no name is fine. @throw Error
void requireWritableTable(const std::string& out, const std::vector<std::string>& inputs);

/// Passes the stream of the file, which takes its place only when all is written and shows on the
/// terminal how far it is, or standard output where there is no name.
/// @throw Error when the file cannot be written; Canceled
void writeTable(const std::string& out, const TableWriting& write);

}  // namespace asperity
