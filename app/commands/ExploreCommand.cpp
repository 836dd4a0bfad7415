#include "app/commands/Commands.h"
#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/program/EndSignals.h"
#include "app/recording/RunPacking.h"
#include "app/reports/RunPictures.h"
#include "app/runs/OutputFolder.h"
#include "app/runs/RunFolder.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/VirtualRun.h"
#include "core/io/scene/DevicePathFile.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/Validity.h"
#include "core/uncertainty/CycleBudgets.h"
#include "core/words/BudgetWords.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace asperity {

namespace {

constexpr double kDefaultDuration = 10.0;  // [s]
constexpr double kMaxDuration = 3600.0;    // [s]

/// Flags that come by noise, announce what comes, or are usual: the summary counts them.
constexpr std::array kInSummaryAlone{Validity::ModelContradicted, Validity::Implausible,
                                     Validity::SingularGeometry,  Validity::SeveralContactPoints,
                                     Validity::SnapInAhead,       Validity::StaleSignals};

struct ExploreOptions {
    std::string input;
    std::string out;
    std::string path = keyOf(PlannedPath::Approach);
    double duration = 0.0;  // [s]; 0: the path's own
    RunFormat format = RunFormat::Csv;
    bool force = false;
    bool noPictures = false;
    SceneOverrides overrides;
};

/// Motion of the base: as planned, or down to a setpoint.
using Motion = std::variant<DevicePath, PlannedApproach>;

Motion planned(PlannedPath path, const Scene& scene, const PathPlan& asked) {
    const PlannedPathRow& row = *rowOf(path);
    return row.plan != nullptr ? Motion(row.plan(scene, asked))
                               : Motion(planApproach(scene, asked));
}

/// A bare word that is no file is more likely a slip in one of the words.
CLI::Validator pathWordOrFile() {
    return {[](const std::string& text) {
                std::error_code ignored;
                const bool isBare = text.find_first_of("./") == std::string::npos;
                const bool isNothing = isBare && !fromKey<PlannedPath>(text) &&
                                       !std::filesystem::exists(text, ignored);
                return isNothing ? "expected " + keyList<PlannedPath>() + " or a CSV file, not '" +
                                       text + "'"
                                 : std::string();
            },
            ""};
}

struct PlannedRun {
    Motion motion;
    double duration = 0.0;  // [s]
};

PlannedRun planRun(const Scene& scene, const ExploreOptions& options) {
    PathPlan plan;
    plan.duration = options.duration > 0.0 ? options.duration : kDefaultDuration;
    if (const std::optional<PlannedPath> path = fromKey<PlannedPath>(options.path)) {
        return {planned(*path, scene, plan), plan.duration};
    }
    DevicePath path = readDevicePath(options.path);
    const double duration = options.duration > 0.0 ? options.duration : path.back().time;
    if (!(duration <= kMaxDuration)) {
        throw InputError(options.path, "",
                         "the path lasts longer than an hour; give a shorter --duration");
    }
    return {std::move(path), duration};
}

void requireApproach(const ExploreOptions& options) {
    if (options.overrides.setpoint && options.path != keyOf(PlannedPath::Approach)) {
        throw CLI::ValidationError("--setpoint", "holds for --path approach only");
    }
}

/// Everything that is kept of a run while it runs.
struct RunKeeper {
    RunRecorder recorder;
    RunEventRecorder events;
    RunCurves curves;

    void take(const TickSample& sample) {
        recorder.take(sample);
        events.take(sample);
        curves.take(sample);
    }
};

/// A setpoint that an approach did not reach.
struct MissedSetpoint {
    double force = 0.0;    ///< [N]
    const char* why = "";  ///< after the words that it was missed
};

/// The results of a run that outlive its scene.
struct FinishedRun {
    RunEvents events;
    RunCurves curves;
    std::optional<RunPictures> pictures;   ///< none: not wanted
    std::vector<std::string> remarks;      ///< on smoothing and pixels
    std::vector<std::string> results;      ///< of each cycle, with what is open in them
    double tickRate = 0.0;                 ///< [Hz]
    std::optional<MissedSetpoint> missed;  ///< none: the force reached it
};

void tellOutcome(const FinishedRun& run) {
    const RunEvents& events = run.events;
    for (const std::string& remark : run.remarks) {
        std::cerr << "note: " << remark << '\n';
    }
    for (const Validity flag : kFlagsByEffect) {
        const long ticks = events.flagged.at(indexOf(flag));
        if (ticks > 0 && std::ranges::find(kInSummaryAlone, flag) == kInSummaryAlone.end()) {
            std::cerr << "note: in " << ticks << " of " << events.ticks
                      << " ticks: " << traitsOf(flag).words << '\n';
        }
    }
    if (run.missed) {
        std::cerr << "note: the force did not reach the setpoint of "
                  << formatSi(run.missed->force, "N") << run.missed->why << '\n';
    }
    if (!events.snapIn && !events.bondedFromStart) {
        std::cerr << "note: the tip never snapped into contact\n";
    }
    if (events.faults > 0) {
        std::cerr << "note: " << events.faults << " ticks with the force off after a fault\n";
    }
}

constexpr const char* kNoEquilibrium =
    ": the approach ended where tip and cantilever have no equilibrium";
constexpr const char* kRecordEnded = ": the approach ended below the recorded curve";

/// @return the setpoint of an approach that did not reach it
/// @throw Canceled
std::optional<MissedSetpoint> run(const Scene& scene, const PlannedRun& plan, AfmController& afm,
                                  RunKeeper& keeper) {
    const long ticks = std::lround(plan.duration / scene.timeStep()) + 1;
    constexpr long kReports = 50;
    long done = 0;
    bool hasEnded = false;
    ProgressLine line("running");
    const TickSink take = [&](const TickSample& sample) {
        if (done % (ticks / kReports + 1) == 0) {
            reportTo(&line, static_cast<double>(done) / static_cast<double>(ticks));
        }
        ++done;
        hasEnded = sample.output.fault == Fault::RecordEnded;
        keeper.take(sample);
    };
    if (const auto* const path = std::get_if<DevicePath>(&plan.motion)) {
        runVirtually(scene, *path, afm, ticks, take);
        return std::nullopt;
    }
    const auto& approach = std::get<PlannedApproach>(plan.motion);
    ApproachDevice device(approach, scene.settings.positionGain);
    runVirtually(scene, device, afm, ticks, take);
    if (device.hasEngaged()) {
        return std::nullopt;
    }
    const char* const blocked = hasEnded ? kRecordEnded : kNoEquilibrium;
    return MissedSetpoint{approach.plan.setpoint, device.isBlocked() ? blocked : ""};
}

/// A scene and what its device is to do.
struct Prepared {
    LoadedScene loaded;
    PlannedRun plan;
};

Prepared prepare(const ExploreOptions& options) {
    LoadedScene loaded = loadSceneOnTerminal(options.input, options.overrides);
    for (const std::string& note : notesOn(loaded)) {
        std::cerr << "note: " << printable(note) << '\n';
    }
    PlannedRun plan = planRun(loaded.scene, options);
    return {std::move(loaded), std::move(plan)};
}

/// Says why no more than the noise is known of what a cycle shows.
void takeUnknown(const ContactCycle& cycle, std::vector<std::string>& remarks) {
    const std::string at = formatted("force cycle at %.4g s", cycle.touchTime);
    if (cycle.contacts > 1) {
        remarks.push_back(at + formatted(": up to %d contacts at once; the uncertainty from model "
                                         "and calibration is known of one contact only",
                                         cycle.contacts));
    }
    if (cycle.interrupted) {
        remarks.push_back(at + ": ticks without a state of the model are left out, and the "
                               "force may have been larger there");
    }
}

/// Says of each cycle what was read, and what is open in it.
void takeResults(const Scene& scene, const std::vector<ContactCycle>& cycles, FinishedRun& run) {
    for (const ContactCycle& cycle : cycles) {
        takeUnknown(cycle, run.remarks);
        for (const auto& [key, name, unit, budget] : cycleBudgets(scene, cycle)) {
            run.results.push_back(std::string(name) + " " + budgetText(budget, unit));
            std::string remark = resolutionText(budget, name, scene.description.tolerance);
            if (!remark.empty()) {
                run.remarks.push_back(std::move(remark));
            }
        }
    }
}

/// Runs, and leaves in the folder all but the pictures.
FinishedRun finishedRun(const Prepared& prepared, bool hasPictures,
                        const std::filesystem::path& out) {
    const auto& [loaded, plan] = prepared;
    const Scene& scene = loaded.scene;
    RunKeeper keeper{.recorder = RunRecorder(out, scene.belief.field), .events = {}, .curves = {}};
    const std::optional<MissedSetpoint> missed = run(scene, plan, *instrumentOf(scene), keeper);
    keeper.recorder.close();

    const RunEvents& events = keeper.events.events();
    writeTextFile(out / run_files::kScene, sceneText(settled(scene.description, scene.model)));
    writeTextFile(out / run_files::kSummary, runSummary(loaded, events));
    FinishedRun finished{.events = events,
                         .curves = std::move(keeper.curves),
                         .pictures = {},
                         .remarks = {},
                         .results = {},
                         .tickRate = scene.description.tickRate,
                         .missed = missed};
    if (hasPictures) {
        finished.pictures.emplace(scene, events);
    }
    takeResults(scene, events.cycles, finished);
    return finished;
}

/// @throw Canceled
void draw(const FinishedRun& run, const std::filesystem::path& folder) {
    ProgressLine line("drawing");
    run.pictures->write(folder, run.curves, &line);
}

void explore(const ExploreOptions& options) {
    requireApproach(options);
    const CancelOnSignal cancel;  // between one piece of work and the next, too
    std::optional<VirtualDisplay> display;
    std::optional<OffscreenApplication> qt;
    if (!options.noPictures) {  // before anything is written: pictures need them at the end
        display.emplace();
        qt.emplace();
    }
    std::optional<Prepared> prepared(prepare(options));
    OutputFolder out(options.out, exploredRun(), options.force);
    std::optional<FinishedRun> run;
    out.collect([&](const std::filesystem::path& folder) {
        run.emplace(finishedRun(*prepared, !options.noPictures, folder));
    });
    if (options.format == RunFormat::Hdf5) {
        out.collect(packRun);
    }
    prepared.reset();  // drawing takes as much memory as a large scan
    if (run->pictures) {
        try {
            out.collect([&](const std::filesystem::path& folder) { draw(*run, folder); });
        } catch (const Error&) {
            out.commit();  // what was measured is kept where it cannot be drawn
            throw;
        }
    }
    out.commit();
    tellOutcome(*run);
    for (const std::string& result : run->results) {
        std::cout << result << '\n';
    }
    std::cout << run->events.ticks << " ticks at " << run->tickRate << " Hz; results in "
              << printable(options.out) << "/\n";
}

}  // namespace

void addExploreCommand(CLI::App& program) {
    CLI::App* command =
        program.add_subcommand("explore", "Run an approach to a force setpoint and a retract, or "
                                          "follow a path; write pictures, fields and a force log");
    const auto options = std::make_shared<ExploreOptions>();
    command->add_option("INPUT", options->input, "height map or scene.toml")->required();
    addOutputFolder(*command, options->out, "folder for the results");
    addFormatOption(*command, options->format, "how the tables of the run are kept");
    addForce(*command, options->force);
    command->add_flag("--no-pictures", options->noPictures,
                      "numbers and tables only, without deformation.exr; needs no display");
    command
        ->add_option("--path", options->path,
                     keyList<PlannedPath>() + ", or a CSV file with time_s, x_m, y_m, z_m")
        ->capture_default_str()
        ->check(pathWordOrFile());
    command
        ->add_option("--duration", options->duration,
                     "duration of the run [s]; default: 10, or the duration of the CSV path")
        ->check(CLI::Range(1e-3, kMaxDuration))
        ->check(finiteNumber());
    addSetpointOption(*command, options->overrides.setpoint);
    command->add_option("--channel", options->overrides.channel, "channel of the height map");
    addScaleOptions(*command, options->overrides.scale);
    addCropOption(*command, options->overrides.crop);
    addLevelingOptions(*command, options->overrides.leveling, options->overrides.levelPoints,
                       "default: as in the scene, or plane");
    command->callback([options] { explore(*options); });
}

}  // namespace asperity
