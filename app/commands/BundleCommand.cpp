#include "app/commands/BundleCommand.h"

#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/exports/PictureExport.h"
#include "app/program/CancelOnSignal.h"
#include "app/recording/Bundle.h"
#include "app/recording/Replay.h"
#include "app/recording/RunPlace.h"
#include "app/recording/RunSlice.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/PrivateFolder.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <limits>
#include <memory>

namespace asperity {

namespace {

struct BundleOptions {
    std::string run;
    std::string out;
    RunSpan span{.from = -std::numeric_limits<double>::infinity(),
                 .to = std::numeric_limits<double>::infinity()};
    bool isPart = false;
    bool force = false;
};

/// A bundle of a run that is not what it says would tell others something else than its tables.
void requireReplay(const std::string& name, const std::filesystem::path& folder,
                   const LoadedScene& loaded, const RecordedRun& run,
                   const std::filesystem::path& scratch) {
    ProgressLine line("replaying");
    const std::string difference = differenceOnReplay(loaded.scene, run, scratch, {}, &line);
    if (!difference.empty()) {
        throw Error(name + ": does not replay: " + failureOfReplay(difference, loaded, folder));
    }
}

/// The run or its part, checked. @return its folder: that of the run, or one in `scratch`
std::filesystem::path checkedRun(const BundleOptions& options, const std::filesystem::path& folder,
                                 const std::filesystem::path& scratch) {
    const RecordedRun run = readRun(folder);
    const LoadedScene loaded = loadSceneOnTerminal(folder / run_files::kScene, {});
    requireSameScan(loaded, folder);
    requireReplay(options.run, folder, loaded, run, scratch / "replay");
    if (!options.isPart && run.state == RunState::Complete) {
        return folder;
    }
    writeSlice(folder, loaded, run, options.span, scratch / "run");
    return scratch / "run";
}

void draw(const std::filesystem::path& run, const std::filesystem::path& picture) {
    ProgressLine line("drawing");
    ExportInput input(run, &line);
    writeExport(input, {}, picture, ExportFormat::Png, &line);
}

void bundle(const BundleOptions& options) {
    const CancelOnSignal cancel;   // between one piece of work and the next, too
    const VirtualDisplay display;  // before long work: the picture needs it
    if (options.span.from > options.span.to) {
        throw Error(
            formatted("--from %g s is after --to %g s", options.span.from, options.span.to));
    }
    const PrivateFolder scratch;  // sweeps what a killed one left, also where this one is refused
    requireOutside(options.run, options.out);
    requireFree(options.out, options.force);
    const RunPlace input(options.run);
    input.read([&] {
        const std::filesystem::path run = checkedRun(options, input.folder(), scratch.path());
        const std::filesystem::path picture = scratch.path() / "picture.png";
        draw(run, picture);
        ProgressLine line("packing");
        writeBundle(run, picture, options.out, &line);
    });
    std::cout << printable(options.out) << ": " << std::filesystem::file_size(options.out)
              << " bytes; it opens and replays on any machine\n";
}

}  // namespace

void addBundleCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "bundle", "Put a run, or a part of it, with its scan and a picture into one file");
    const auto options = std::make_shared<BundleOptions>();
    command->add_option("RUN", options->run, "folder that explore or a recording wrote")
        ->required();
    command->add_option("OUT", options->out, "file to write, a zip archive")
        ->required()
        ->check(notEmpty());
    CLI::Option* const from =
        command->add_option("--from", options->span.from, "first moment of a part [s]")
            ->check(finiteNumber());
    CLI::Option* const to =
        command->add_option("--to", options->span.to, "last moment of a part [s]")
            ->check(finiteNumber());
    command->add_flag("--force", options->force, "replace a file of that name");
    command->callback([options, from, to] {
        options->isPart = from->count() + to->count() > 0;
        bundle(*options);
    });
}

}  // namespace asperity
