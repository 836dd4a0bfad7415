#include "app/CaseFiles.h"

#include "app/OptionChecks.h"
#include "core/TemporaryFile.h"

#include <iostream>

namespace asperity {

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

void writeTable(const std::string& out, const std::function<void(std::ostream&)>& write) {
    if (out.empty()) {
        write(std::cout);
        return;
    }
    OutputFile file(out);
    write(file.stream());
    file.commit();
}

}  // namespace asperity
