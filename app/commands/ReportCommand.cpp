#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/program/EndSignals.h"
#include "app/recording/Bundle.h"
#include "app/recording/Replay.h"
#include "app/reports/RunPictures.h"
#include "app/reports/page/ReportPage.h"
#include "app/reports/run/RunPage.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/PrintableText.h"
#include "core/io/FileBytes.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

namespace {

struct ReportOptions {
    std::vector<std::string> runs;
    std::string out;
    bool force = false;
};

constexpr PictureSize kPicture{1100, 760};  // its texts can be read on paper

/// A run that a page is made of.
struct Task {
    std::filesystem::path folder;  ///< as the user gave it
    std::string page;              ///< name of its files
    std::string parent;            ///< name of the page that lists it; empty: none
};

/// The facts of a page that are kept when it is written.
struct Written {
    IndexedRun run;
    std::string note;  ///< fault of the run, a clause; empty: nothing
};

void writePage(const std::filesystem::path& folder, const ReportPage& page) {
    writeTextFile(folder / (page.name + ".html"), htmlPage(page));
    writePdfPage(folder / (page.name + ".pdf"), page);
}

RecordedRun readSomeTicks(const std::filesystem::path& folder) {
    RecordedRun recorded = readRun(folder);
    if (recorded.samples.empty()) {
        throw InputError(folder.string(), "",
                         "holds no tick: the recording ended before its first one was written");
    }
    return recorded;
}

/// @throw Canceled
void draw(ReportedRun& run, const std::filesystem::path& scratch, Progress* progress) {
    const RunEvents& events = run.history.events();
    const RunPictures pictures(run.loaded.scene, events);
    reportTo(progress, 0.2);
    pictures.writeOverview(scratch, run.history.tipPath(), kPicture);
    run.overview = readFileBytes(scratch);
    reportTo(progress, 0.6);
    if (events.deepest->output.region() == TipRegion::Contact) {
        pictures.writeDeformation(scratch, kPicture);
        run.deformation = readFileBytes(scratch);
    }
    std::filesystem::remove(scratch);
    reportTo(progress, 1.0);
}

/// Hashes the files of a run. @param shown start of their names on the page
std::vector<HashedFile> hashesOf(const std::filesystem::path& folder,
                                 const std::filesystem::path& shown) {
    std::vector<HashedFile> hashes;
    for (const char* name :
         {run_files::kScene, run_files::kInput, run_files::kLog, run_files::kTables}) {
        const std::filesystem::path file = folder / name;
        if (isThere(file)) {
            hashes.push_back({sha256Of(FileBytes(file)), (shown / name).string()});
        }
    }
    return hashes;
}

/// The files that the page lists, by names that outlive it: those of a bundle are unpacked into
/// a folder that is deleted.
void addFiles(ReportedRun& run, const RunLocation& input) {
    run.scan = run.loaded.sha256.empty() ? "" : run.loaded.scene.description.sample.file;
    if (input.isBundle()) {
        run.bundle = {sha256Of(FileBytes(run.folder)), run.folder.string()};
        run.scan = std::filesystem::path(run.scan).lexically_relative(input.folder()).string();
    }
    run.hashes = hashesOf(input.folder(), input.isBundle() ? "" : run.folder);
    if (!run.scan.empty()) {
        run.hashes.push_back({run.loaded.sha256, run.scan});
    }
}

std::string noteOn(const ReportedRun& run) {
    return run.difference.empty() ? run.state
                                  : "the replay differs from the recorded log: " + run.difference;
}

/// Reads, replays and draws a run, and writes its page.
Written writeRun(const Task& task, const RunLocation& input, const std::filesystem::path& folder,
                 Progress* progress) {
    const RecordedRun recorded = readSomeTicks(input.folder());
    ProgressPart loading(progress, 0.0, 0.4);
    const LoadedScene loaded = loadScene(input.folder() / run_files::kScene, {}, &loading);
    requireSameScan(loaded, recorded.scan);
    const RunRecord record = readRecord(input.folder());
    ReportedRun run{.name = task.page,
                    .folder = task.folder,
                    .scan = {},
                    .loaded = loaded,
                    .history = {},
                    .program = record.program,
                    .summary = record.summary,
                    .state = sentenceOf(recorded.state),
                    .difference = {},
                    .bundle = {},
                    .hashes = {},
                    .overview = {},
                    .deformation = {}};
    addFiles(run, input);
    ProgressPart replaying(progress, 0.4, 0.6);
    run.difference = differenceOnReplay(
        loaded.scene, recorded, folder / "replay",
        [&run](const TickSample& sample) { run.history.take(sample); }, &replaying);
    if (!run.difference.empty()) {
        run.difference = failureOfReplay(run.difference, loaded, recorded.scan);
    }
    ProgressPart drawing(progress, 0.6, 0.95);
    draw(run, folder / "picture.png", &drawing);
    writePage(folder, runPage(run, task.parent));
    reportTo(progress, 1.0);
    return {indexed(run), noteOn(run)};
}

std::vector<Task> tasksOf(const std::vector<std::string>& runs) {
    PageNames names(kReportIndex);
    std::vector<Task> tasks;
    tasks.reserve(runs.size());
    for (const std::string& run : runs) {
        tasks.push_back({run, names.nameFor(run), runs.size() > 1 ? kReportIndex : ""});
    }
    return tasks;
}

std::vector<std::string> pagesOf(const std::vector<Task>& tasks) {
    std::vector<std::string> pages;
    if (tasks.size() > 1) {
        pages.emplace_back(kReportIndex);
    }
    for (const Task& task : tasks) {
        pages.push_back(task.page);
    }
    return pages;
}

/// Before hours of work: what is no run at all is found at once. @throw InputError
void requireRuns(const std::vector<Task>& tasks) {
    for (const Task& task : tasks) {
        if (isBundle(task.folder)) {
            continue;
        }
        const RunLocation named(task.folder);  // as other commands say it
        const bool isPacked = isThere(named.folder() / run_files::kTables);
        for (const char* name : {run_files::kScene, run_files::kInput, run_files::kLog}) {
            if (!isThere(named.folder() / name) && !(isPacked && name != run_files::kScene)) {
                throw InputError(task.folder.string(), "",
                                 std::string("holds no run: there is no ") + name);
            }
        }
    }
}

/// @throw Canceled
std::vector<Written> writeAll(const std::vector<Task>& tasks, const std::filesystem::path& folder) {
    ProgressLine line("reporting");
    std::vector<Written> written;
    std::vector<IndexedRun> runs;
    const auto count = static_cast<double>(tasks.size());
    for (const Task& task : tasks) {
        const auto done = static_cast<double>(written.size());
        ProgressPart part(&line, done / count, (done + 1.0) / count);
        const RunLocation input(task.folder);
        written.push_back(input.read([&] { return writeRun(task, input, folder, &part); }));
        runs.push_back(written.back().run);
    }
    if (tasks.size() > 1) {
        writePage(folder, indexPage(kReportIndex, runs));
    }
    writeReportList(folder, pagesOf(tasks));
    return written;
}

void tellOutcome(const std::vector<Task>& tasks, const std::vector<Written>& written,
                 const std::filesystem::path& out) {
    for (std::size_t i = 0; i < tasks.size(); ++i) {
        if (!written[i].note.empty()) {
            std::cerr << "note: " << printable(tasks[i].folder.string()) << ": "
                      << printable(written[i].note) << '\n';
        }
    }
    const std::string first = pagesOf(tasks).front();
    std::cout << (tasks.size() == 1 ? "1 run" : std::to_string(tasks.size()) + " runs") << "; open "
              << printable((out / (first + ".html")).string()) << " or "
              << printable(first + ".pdf") << '\n';
}

void report(const ReportOptions& options) {
    const CancelOnSignal cancel;
    const std::vector<Task> tasks = tasksOf(options.runs);
    requireRuns(tasks);
    const VirtualDisplay display;
    const OffscreenApplication qt;  // PDF needs its fonts
    OutputFolder out(options.out, reportContent(options.out, pagesOf(tasks)), options.force);
    std::vector<Written> written;
    out.collect([&](const std::filesystem::path& folder) { written = writeAll(tasks, folder); });
    out.commit();
    tellOutcome(tasks, written, options.out);
}

}  // namespace

void addReportCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "report", "Write a page on each recorded run, as HTML and PDF: curves, force cycles, "
                  "pictures, parameters, validity");
    const auto options = std::make_shared<ReportOptions>();
    command
        ->add_option("RUN", options->runs,
                     "folders that explore or a recording wrote, or bundles (.zip)")
        ->required();
    addOutputFolder(*command, options->out, "folder for the pages");
    addForce(*command, options->force);
    command->callback([options] { report(*options); });
}

}  // namespace asperity
