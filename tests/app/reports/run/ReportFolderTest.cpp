#include "app/reports/run/RunPage.h"
#include "app/runs/RunFolder.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace asperity {
namespace {

void writeReport(const std::filesystem::path& folder, const std::vector<std::string>& pages) {
    OutputFolder out(folder, reportContent(folder, pages));
    out.collect([&](const std::filesystem::path& staging) {
        for (const std::string& page : pages) {
            writeTextFile(staging / (page + ".html"), "");
            writeTextFile(staging / (page + ".pdf"), "");
        }
        writeReportList(staging, pages);
    });
    out.commit();
}

std::vector<std::string> filesIn(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& file : std::filesystem::directory_iterator(folder)) {
        names.push_back(file.path().filename().string());
    }
    std::ranges::sort(names);
    return names;
}

TEST(ReportFolder, HoldsNoPageOfAnEarlierReport) {
    const test::ScratchFolder scratch;
    writeReport(scratch.file("out"), {"index", "a", "b"});
    writeReport(scratch.file("out"), {"c"});
    EXPECT_EQ(filesIn(scratch.file("out")),
              (std::vector<std::string>{"asperity_report.json", "c.html", "c.pdf"}));
}

TEST(ReportFolder, OfAChangedListLosesNothingElse) {
    const test::ScratchFolder scratch;
    const auto precious = scratch.write("precious.html", "mine");
    std::filesystem::create_directory(scratch.file("out"));
    (void)scratch.write("out/notes.txt", "mine");
    (void)scratch.write("out/asperity_report.json",
                        R"({"files": ["../precious.html", "notes.txt", 7, "", "..", "x/y.pdf"]})");
    writeReport(scratch.file("out"), {"c"});
    EXPECT_EQ(test::contentOf(precious), "mine");
    EXPECT_EQ(test::contentOf(scratch.file("out/notes.txt")), "mine");
    (void)scratch.write("out/asperity_report.json", "[");
    EXPECT_NO_THROW(writeReport(scratch.file("out"), {"c"}));
}

}  // namespace
}  // namespace asperity
