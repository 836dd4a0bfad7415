#include "app/reports/run/ReproductionSection.h"

#include "app/program/ProgramParts.h"
#include "app/reports/run/ShellWord.h"
#include "core/FormattedText.h"

#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

std::string nameOf(const std::optional<RecordedProgram>& program) {
    return program ? "asperity " + program->version + ", compiler " + program->compiler
                   : "the folder of the run does not say";
}

PageTable factTable(const ReportedRun& run) {
    const RunEvents& events = run.history.events();
    return {.columns = {{"quantity"}, {"value"}},
            .rows = {{{"Made by"}, {nameOf(run.program)}},
                     {{"Replayed for this page by"},
                      {"asperity " + versionWithCommit() + ", " + compilerName()}},
                     {{"Length"},
                      {std::to_string(events.ticks) + " ticks, " +
                       formatted("%.3f s", run.history.duration())}},
                     {{"Run"}, {run.folder.string()}}},
            .hasTitles = false};
}

std::vector<std::string> commandsOf(const ReportedRun& run) {
    const std::string folder = shellWord(run.folder.string());
    return {"asperity replay " + folder + " --out AGAIN",
            "asperity report " + folder + " --out REPORT"};
}

std::string lineOf(const HashedFile& file) { return file.sha256 + "  " + file.file; }

void addHashes(PageContent& page, const ReportedRun& run) {
    page.addParagraph("SHA-256, as sha256sum prints and checks it:");
    if (run.bundle) {
        page.addCode({lineOf(*run.bundle)});
        page.addParagraph("Of the files in the bundle " + run.folder.filename().string() +
                          ", in the folder that it is unpacked into:");
    }
    std::vector<std::string> lines;
    lines.reserve(run.hashes.size());
    for (const HashedFile& file : run.hashes) {
        lines.push_back(lineOf(file));
    }
    page.addCode(lines);
}

}  // namespace

void addReproduction(PageContent& page, const ReportedRun& run) {
    const std::string same =
        run.difference.empty()
            ? "All numbers of this page come from a replay of the recorded inputs, which gave each "
              "recorded tick again, bit for bit."
            : "The replay differs from the recorded log: " + run.difference +
                  ". All numbers of this page are those of the replay.";
    page.addHeading("How to reproduce this");
    page.addTable(factTable(run));
    page.addParagraph(same, run.difference.empty() ? PageTone::Plain : PageTone::Fault);
    page.addParagraph(
        "The first command repeats the run and compares every tick, the second makes this page:");
    page.addCode(commandsOf(run));
    addHashes(page, run);
}

}  // namespace asperity
