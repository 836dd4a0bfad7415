#include "app/commands/CaseFiles.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"

#include <filesystem>
#include <iostream>
#include <sstream>
#include <system_error>
#include <unistd.h>

namespace asperity {

namespace {

/// Byte by byte into a pipe or file; a terminal must not obey what the cells of a table hold.
void writeToStandardOutput(const TableWriting& write) {
    if (isatty(STDOUT_FILENO) != 1) {
        write(std::cout, nullptr);
        return;
    }
    std::ostringstream table;
    write(table, nullptr);
    std::cout << printableLines(table.str());
}

}  // namespace

void addCaseFiles(CLI::App& command, CaseFiles& files) {
    command.add_option("--cases", files.cases, "CSV table, one case a row")
        ->required()
        ->check(notEmpty());
    addTableFile(command, files.out);
}

void addTableFile(CLI::App& command, std::string& out) {
    command.add_option("--out", out, "CSV file to write (default: standard output)")
        ->check(notEmpty());
}

void requireWritableTable(const std::string& out, const std::vector<std::string>& inputs) {
    if (out.empty()) {
        return;
    }
    for (const std::string& input : inputs) {
        std::error_code none;
        if (std::filesystem::equivalent(input, out, none)) {
            throw Error(out + ": this is an input; give another output file");
        }
    }
    requireWritable(out);
}

void writeTable(const std::string& out, const TableWriting& write) {
    if (out.empty()) {
        writeToStandardOutput(write);
        return;
    }
    ProgressLine line("writing");  // before the file: a signal in between would leave it
    OutputFile file(out);
    try {
        write(file.stream(), &line);
    } catch (const Error&) {
        if (!file.stream()) {
            file.commit();  // which says of which file not all could be written
        }
        throw;
    }
    file.commit();
}

}  // namespace asperity
