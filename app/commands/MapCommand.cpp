#include "app/commands/Commands.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/maps/ComparisonReport.h"
#include "app/maps/MapFiles.h"
#include "app/maps/MapJob.h"
#include "app/program/EndSignals.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/TemporaryFile.h"
#include "core/io/TextValue.h"
#include "core/map/MapPlan.h"
#include "core/scene/SceneDescription.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// Options of `asperity map`.
struct MapOptions {
    std::string scene;
    std::string out;
    MapRequest request;
    std::vector<std::string> channels;  ///< of the scan, or of the measured file if there is one
    std::string compare;                ///< measured file; empty: none
    int threads = 0;                    ///< 0: as many as the machine has cores
    bool resume = false;
    bool force = false;
    bool noPictures = false;
};

/// "512x256" as columns and rows; empty where it is anything else.
std::optional<MapGrid> parseGrid(const std::string& text) {
    const std::size_t cross = text.find('x');
    if (cross == std::string::npos) {
        return std::nullopt;
    }
    const auto columns = parseInteger(text.substr(0, cross));
    const auto rows = parseInteger(text.substr(cross + 1));
    constexpr long long kMax = std::numeric_limits<int>::max();
    if (!columns || !rows || *columns < 0 || *rows < 0 || *columns > kMax || *rows > kMax) {
        return std::nullopt;
    }
    return MapGrid{static_cast<int>(*columns), static_cast<int>(*rows)};
}

CLI::Validator gridText() {
    return {[](const std::string& text) {
                return parseGrid(text)
                           ? std::string()
                           : "expected WIDTHxHEIGHT in pixels, such as 128x128, not '" + text + "'";
            },
            "WxH"};
}

CLI::Validator meters() {
    return {[](const std::string& text) {
                const std::optional<double> number = parseNumber(text);
                return number && std::isfinite(*number)
                           ? std::string()
                           : "expected x0,y0,x1,y1 in meters, such as 0,0,1e-7,1e-7, not '" + text +
                                 "'";
            },
            ""};
}

CLI::Validator gwyName() {
    return {[](const std::string& text) {
                return lowerCase(std::filesystem::path(text).extension().string()) == ".gwy"
                           ? std::string()
                           : "expected the name of a .gwy file, not '" + text + "'";
            },
            ""};
}

CLI::Validator modeName() {
    std::vector<std::string> keys;
    keys.reserve(kValues<MapMode>.size());
    for (const MapMode mode : kValues<MapMode>) {
        keys.emplace_back(keyOf(mode));
    }
    return CLI::IsMember(keys);
}

void addRequest(CLI::App& command, MapRequest& request) {
    command
        .add_option_function<std::string>(
            "--grid", [&request](const std::string& text) { request.grid = parseGrid(text); },
            "pixels of the map; default: those of the scan in the region")
        ->check(gridText());
    command
        .add_option_function<std::vector<double>>(
            "--region",
            [&request](const std::vector<double>& corners) {
                request.region = MapRegion{corners[0], corners[1], corners[2], corners[3]};
            },
            "part of the scan between the corners x0,y0 and x1,y1, from its lower left corner [m]; "
            "default: all of it")
        ->delimiter(',')
        ->expected(4)
        ->check(meters());
    addSetpointOption(command, request.setpoint);
    command
        .add_option_function<std::string>(
            "--mode",
            [&request](const std::string& key) {
                request.mode = fromKey<MapMode>(key).value_or(MapMode::Approach);
            },
            "approach: approach and retract at each pixel (default); contact: a raster at constant "
            "force, trace and retrace")
        ->check(modeName());
    command
        .add_option("--quantities", request.quantities,
                    "channels, separated by commas (docs/maps.md); default: all of the mode but "
                    "deviations")
        ->delimiter(',');
    command.add_flag(
        "--uncertainty", request.deviations,
        "standard deviations of adhesion, work, indentation and stiffness by model and "
        "calibration, too (docs/uncertainty.md)");
    command.add_flag("--truth", request.truth,
                     "map the simulated true instrument, section [truth] of the scene, instead of "
                     "the model");
}

void addCompare(CLI::App& command, MapOptions& options) {
    CLI::Option* const channel =
        command
            .add_option("--channel", options.channels,
                        "channel of the height-map file SCENE; default: as in the scene. With "
                        "--compare: channel of that file, as NAME or NAME:QUANTITY, once for each")
            ->allow_extra_args(false);
    command
        .add_option("--compare", options.compare,
                    "measured maps of the same area, in any format of height maps; writes "
                    "difference, correlation and the share of variance that the prediction "
                    "explains of each --channel")
        ->needs(channel)
        ->check(notEmpty());
}

/// The options that make them up. @param options outlive the parse
void addMapOptions(CLI::App& command, MapOptions& options) {
    command.add_option("SCENE", options.scene, "scene.toml or a height-map file")
        ->required()
        ->check(notEmpty());
    command
        .add_option("--out", options.out,
                    "map to write (.gwy); .vti, .exr and pictures (.png) go beside it")
        ->required()
        ->check(gwyName());
    addRequest(command, options.request);
    addCompare(command, options);
    command
        .add_option("--threads", options.threads, "threads; default: as many as there are cores")
        ->check(CLI::Range(1, 1024));
    CLI::Option* const resume =
        command.add_flag("--resume", options.resume,
                         "continue an interrupted map: its finished rows are in OUT.gwy.part");
    command
        .add_flag("--force", options.force,
                  "replace files of these names, and restart an unfinished map")
        ->excludes(resume);
    command.add_flag("--no-pictures", options.noPictures,
                     "draw no sheets of pictures: no display is needed");
}

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
/// done for them. An unfinished map's own files may be deleted.
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

/// The input of all ranks.
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
    throw Error(job.hasLauncher() ? count + files.part().string() + "; --resume continues the map"
                                  : count + files.gwy().string() +
                                        ", the others have no data; --resume continues the map");
}

/// @throw Error where files beside the .gwy of a whole map are missing
void requireWhole(const MapFiles& files, bool hasPictures) {
    std::vector<std::filesystem::path> wanted{files.vti(), files.exr()};
    if (hasPictures) {
        wanted.push_back(files.sheet(1));
    }
    std::string missing;
    for (const std::filesystem::path& file : wanted) {
        if (std::error_code none; !std::filesystem::exists(file, none)) {
            missing += (missing.empty() ? "" : ", ") + file.filename().string();
        }
    }
    if (!missing.empty()) {
        throw Error(files.gwy().string() + ": the map is whole, but there is no " + missing +
                    ": --force computes it again and writes all its files");
    }
}

/// Runs on rank 0, or in the only process.
void lead(const MapOptions& options, const MpiJob& job) {
    const MapFiles files(options.out);
    const MapInput input = loadedInput(options);
    const auto& [loaded, plan] = input;
    std::error_code none;
    if (options.resume && job.isAlone() && !std::filesystem::exists(files.part(), none) &&
        holdsMap(files, loaded, plan)) {
        requireWhole(files, !options.noPictures);
        std::cout << printable(files.gwy().string())
                  << ": the map is whole; nothing is left to do\n";
        return;
    }
    requireTargets(options, files, plan, loaded.scene.description);
    MeasuredFile measured = measuredInput(options, input);
    std::optional<VirtualDisplay> display;  // before long work is done
    std::optional<OffscreenApplication> qt;
    if (!options.noPictures) {
        display.emplace();
        qt.emplace();
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

/// Runs on the other ranks: they print nothing.
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
        job.abort(reportError(std::current_exception()));
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
