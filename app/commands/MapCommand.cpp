#include "app/commands/MapCommand.h"

#include "app/commands/MapOptions.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/maps/ComparisonReport.h"
#include "app/maps/ComparisonSheets.h"
#include "app/maps/MapJob.h"
#include "app/maps/MapKey.h"
#include "app/maps/MapRun.h"
#include "app/maps/MapSheets.h"
#include "app/maps/UnknownDeviations.h"
#include "app/program/ToldError.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/scene/SceneFiles.h"

#include <chrono>
#include <iostream>
#include <memory>
#include <optional>
#include <thread>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// For rank 0 to say what went wrong everywhere.
constexpr std::chrono::milliseconds kPatience(500);

/// Cancels on a signal and shows nothing.
class SilentProgress : public Progress {
public:
    void report(double /*fraction*/) override {}
    [[nodiscard]] bool isCanceled() const override { return CancelOnSignal::hasArrived(); }

private:
    CancelOnSignal cancel_;
};

PartUse useOf(const MapOptions& options) {
    return options.resume ? PartUse::Resume : options.force ? PartUse::Replace : PartUse::New;
}

bool isCompared(const MapOptions& options) { return !options.compare.empty(); }

/// Channels that the map is compared with.
std::size_t comparedCount(const MapOptions& options) {
    return isCompared(options) ? options.channels.size() : 0;
}

/// All files that a map writes.
std::vector<std::filesystem::path> targetsOf(const MapOptions& options, const MapFiles& files,
                                             const MapPlan& plan) {
    std::vector<std::filesystem::path> targets = filesOf(files, plan, !options.noPictures);
    if (isCompared(options)) {
        targets.push_back(files.comparison());
    }
    if (!options.noPictures) {
        for (std::size_t sheet = 1; sheet <= comparedCount(options); ++sheet) {
            targets.push_back(files.comparisonSheet(static_cast<int>(sheet)));
        }
    }
    return targets;
}

/// Refuses files that cannot be written, or that the user may want to keep, before long work is
/// done for them. An unfinished map's own files may go.
void requireTargets(const MapOptions& options, const MapFiles& files, const MapPlan& plan,
                    const SceneDescription& scene) {
    if (useOf(options) == PartUse::New) {
        requireNoPart(files.part());
    }
    requireWritable(files.part());
    std::vector<std::string> inputs{options.scene, options.compare};
    forEachFile(scene, [&inputs](const std::string& file) { inputs.push_back(file); });
    std::error_code none;
    for (const std::filesystem::path& file : targetsOf(options, files, plan)) {
        for (const std::string& input : inputs) {
            if (std::filesystem::equivalent(input, file, none)) {
                throw Error(file.string() + ": this is an input; give another output file");
            }
        }
        const bool isOwn = options.resume && std::filesystem::exists(files.part(), none);
        if (std::filesystem::exists(file, none) && !options.force && !isOwn) {
            throw Error(file.string() + ": exists; --force replaces it");
        }
        requireWritable(file);
    }
}

/// Computes what is missing, with the other processes of the job. @return whether it was not
/// canceled
bool compute(const MapOptions& options, const MpiJob& job, const Scene& scene, const MapPlan& plan,
             MapPart& part) {
    try {
        ProgressLine line("mapping");
        if (job.isAlone()) {
            computeMap(scene, plan, part, options.threads, &line);
        } else {
            leadMap(job, scene, plan, part, options.threads, &line);
        }
        return true;
    } catch (const Canceled&) {
        return false;
    }
}

/// What all ranks begin with.
struct MapInput {
    LoadedScene loaded;
    MapPlan plan;
};

MapInput inputOf(const MapOptions& options, Progress& progress) {
    SceneOverrides overrides;
    if (!isCompared(options) && !options.channels.empty()) {
        overrides.channel = options.channels.front();
    }
    // With all terms of the model: no map has to keep up with a tick.
    LoadedScene loaded = loadScene(options.scene, overrides, &progress, ModelFit::Later);
    reportTo(&progress, 1.0);
    MapPlan plan = planMap(loaded.scene, options.request);
    requireMapFits(plan, comparedCount(options));
    return {std::move(loaded), std::move(plan)};
}

MapInput loadedInput(const MapOptions& options) {
    ProgressLine line("loading");
    return inputOf(options, line);
}

MeasuredFile measuredInput(const MapOptions& options, const MapInput& input) {
    if (!isCompared(options)) {
        return {};
    }
    ProgressLine line("reading " + options.compare);
    return readMeasured(options.compare, options.channels, input.loaded.scene, input.plan, &line);
}

void writeComparison(const MapFiles& files, const std::string& json) {
    OutputFile file(files.comparison());
    file.stream() << json << '\n';
    file.commit();
}

/// A canceled map is written, too, whatever the signal: what it lacks holds no data.
void writeAll(const MapFiles& files, const MapInput& input, MeasuredFile measured,
              const MapPart& part, bool withPictures) {
    const CancelOnSignal deaf;
    const MapPlan& plan = input.plan;
    const std::vector<ComparedMap> compared =
        comparedMaps(std::move(measured.channels), plan, part);
    if (withPictures) {
        writeMapSheets(files, plan, part);
        writeComparisonSheets(files, plan, part, compared);
    }
    if (!compared.empty()) {
        writeComparison(files, comparisonJson(measured, plan, compared));
    }
    writeMapFiles(files, input.loaded, plan, part, nullptr, compared);
    for (const std::string& sentence : unknownDeviations(plan, part)) {
        std::cerr << "note: " << sentence << '\n';
    }
    for (const ComparedMap& map : compared) {
        std::cout << printable(sentenceOn(map)) << '\n';
    }
}

std::string speedText(const MapPlan& plan, int rows, double seconds) {
    const double curves = static_cast<double>(rows) * plan.grid.columns;
    return formatted("%d x %d pixels; %.0f of them computed in %.3g s: %.4g a second",
                     plan.grid.columns, plan.grid.rows, curves, seconds,
                     seconds > 0.0 ? curves / seconds : 0.0);
}

/// A launcher kills all processes a second after it has asked them to end: too soon for files.
[[noreturn]] void endCanceled(const MpiJob& job, const MapFiles& files, const MapPart& part) {
    const std::string count =
        formatted("canceled: %d of %d rows are in ", part.count(), part.rows());
    throw Error(job.hasLauncher()
                    ? count + files.part().string() + "; --resume goes on with the map"
                    : count + files.gwy().string() +
                          ", the others hold no data; --resume goes on with the map");
}

/// Of rank 0, or of the only process.
void lead(const MapOptions& options, const MpiJob& job) {
    const MapFiles files(options.out);
    const MapInput input = loadedInput(options);
    const auto& [loaded, plan] = input;
    std::error_code none;
    if (options.resume && job.isAlone() && !std::filesystem::exists(files.part(), none) &&
        holdsMap(files, loaded, plan)) {
        std::cout << printable(files.gwy().string())
                  << ": the map is whole; nothing is left to do\n";
        return;
    }
    requireTargets(options, files, plan, loaded.scene.description);
    MeasuredFile measured = measuredInput(options, input);
    std::optional<VirtualDisplay> display;  // before long work is done
    if (!options.noPictures) {
        display.emplace();
    }
    const std::string key = mapKey(loaded, plan);
    MapPart part(files.part(), plan, key, useOf(options));
    for (const std::string& note : notesOn(loaded)) {
        std::cerr << "note: " << printable(note) << '\n';
    }
    for (const std::string& note : measured.notes) {
        std::cerr << "note: " << printable(options.compare + ": " + note) << '\n';
    }
    job.requireSame(key, "the map");
    const int before = part.count();
    const auto begin = std::chrono::steady_clock::now();
    const bool isWhole = compute(options, job, loaded.scene, plan, part);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    if (isWhole || !job.hasLauncher()) {
        writeAll(files, input, std::move(measured), part, !options.noPictures);
    }
    if (!isWhole) {
        endCanceled(job, files, part);
    }
    part.remove();
    std::cout << speedText(plan, part.rows() - before, took.count()) << '\n';
}

/// Of the other ranks: they say nothing.
void follow(const MapOptions& options, const MpiJob& job) {
    SilentProgress progress;
    const auto [loaded, plan] = inputOf(options, progress);
    job.requireSame(mapKey(loaded, plan), "the map");
    followMap(job, loaded.scene, plan, options.threads, &progress);
}

void map(const MapOptions& options) {
    if (!isCompared(options) && options.channels.size() > 1) {
        throw CLI::ValidationError("--channel", "a scan has one; several need --compare");
    }
    const MpiJob job;
    try {
        job.rank() == 0 ? lead(options, job) : follow(options, job);
    } catch (...) {
        if (job.isAlone()) {
            throw;
        }
        if (job.rank() != 0) {  // what went wrong on all ranks is said by rank 0 alone
            std::this_thread::sleep_for(kPatience);
            std::cerr << "rank " << job.rank() << ": ";
        }
        job.abort(tellError(std::current_exception()));
    }
}

}  // namespace

void addMapCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "map",
        "Map adhesion, stiffness, deformation and friction over a scan: a force curve at each "
        "pixel, or a raster at constant force");
    const auto options = std::make_shared<MapOptions>();
    addMapOptions(*command, *options);
    command->callback([options] { map(*options); });
}

}  // namespace asperity
