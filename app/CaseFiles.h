#pragma once

#include <CLI/CLI.hpp>
#include <functional>
#include <ostream>
#include <string>

namespace asperity {

/// Where a command that works through a table of cases reads and writes.
struct CaseFiles {
    std::string cases;
    std::string out;  ///< empty: standard output
};

/// The options --cases and --out.
void addCaseFiles(CLI::App& command, CaseFiles& files);

/// The option --out for a table.
void addTableFile(CLI::App& command, std::string& out);

/// Hands the stream of the file, which takes its place only when all is written, or standard output
/// where there is no name. @throw Error when the file cannot be written
void writeTable(const std::string& out, const std::function<void(std::ostream&)>& write);

}  // namespace asperity
