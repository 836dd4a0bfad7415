#include "tests/app/commands/CaseRuns.h"

#include "core/io/TextValue.h"
#include "tests/app/ProgramRun.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

namespace asperity::test {

std::string lineOf(const ContactRow& row) {
    return row.model + "," + row.radius + "," + row.modulus + "," + row.work + "," + row.stress +
           "," + exactText(row.indentation) + "," + row.branch + "\n";
}

CsvTable contactTable(const std::string& lines, const std::string& header) {
    const ScratchFolder scratch;
    const auto cases = scratch.write("cases.csv", header + lines);
    const auto run = runProgram("contact --cases " + cases.string() + " --out " +
                                scratch.file("out.csv").string());
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_EQ(run.output, "");
    return readCsv(scratch.file("out.csv"));
}

}  // namespace asperity::test
