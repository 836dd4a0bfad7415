#include "app/commands/Commands.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/commands/VirtualDisplay.h"
#include "app/program/DataFolder.h"
#include "app/program/EndSignals.h"
#include "app/recording/RunRecording.h"
#include "app/reports/LoopReport.h"
#include "app/runs/OutputFolder.h"
#include "app/window/Stage.h"
#include "app/window/ViewControl.h"
#include "app/window/device/DeviceControl.h"
#include "app/window/device/PathControl.h"
#include "app/window/lab/LiveWindow.h"
#include "app/window/recording/RecordingControl.h"
#include "core/Error.h"
#include "core/haptics/DevicePath.h"
#include "hardware/DeviceRegistry.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/Menus.h"
#include "ui/view/SecondView.h"

#include <QAction>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <memory>
#include <thread>

namespace asperity {

namespace {

constexpr std::chrono::milliseconds kPoll{20};
constexpr double kOnePath = 10.0;  // approach, slide and retract [s]

struct LoopOptions {
    std::string input;
    GivenScale scale;
    std::optional<PixelRectangle> crop;
    double rate = 0.0;                  // [Hz]; 0: the scene's own
    double duration = 10.0;             // [s]
    std::string record;                 // folder; empty: nothing is recorded
    RunFormat format = RunFormat::Csv;  // of the recording
    bool force = false;                 // an earlier run in that folder may be deleted
    bool simulatedDevice = false;
    bool window = false;
    bool json = false;
};

LoadedScene loadForLoop(const LoopOptions& options) {
    const std::filesystem::path input =
        options.input.empty() ? defaultSceneFile() : std::filesystem::path(options.input);
    if (input.empty()) {
        throw Error("the program's data folder is missing: name a scan or a scene");
    }
    LoadedScene loaded = loadSceneOnTerminal(input, {.scale = options.scale, .crop = options.crop});
    if (options.rate > 0.0) {
        loaded.scene.description.tickRate = options.rate;
    }
    return loaded;
}

/// The same approach again and again; the path back from its end is high over the sample.
DevicePath repeatedApproach(const Scene& scene, double duration) {
    const DevicePath once = slidePath(scene, {.duration = kOnePath});
    DevicePath path = once;
    while (path.back().time < duration) {
        const DevicePath back =
            journey(scene, path.back().position, once.front().position.head<2>(), 1.0);
        const double leave = path.back().time;
        for (std::size_t i = 1; i < back.size(); ++i) {
            path.push_back({leave + back[i].time, back[i].position});
        }
        const double begin = path.back().time + 0.1;
        for (const PathPoint& point : once) {
            path.push_back({begin + point.time, point.position});
        }
    }
    return path;
}

/// A pair of blocks takes a little more than two seconds: the last one is waited for.
bool isDone(const AlternatingBlocks& blocks, double begin, const LoopOptions& options) {
    return monotonicSeconds() - begin >= options.duration &&
           static_cast<double>(blocks.pairs()) >= std::floor(0.5 * options.duration);
}

/// Results of a measurement.
struct LoopMeasurement {
    const AlternatingBlocks& blocks;
    double elapsed = 0.0;         ///< [s]
    double writingTime = 0.0;     ///< of a tick [s]
    std::vector<ViewRate> views;  ///< empty: without a window
};

void print(const LoopOptions& options, LiveRun& run, const LoopMeasurement& measured) {
    const LoopReport report{.rate = run.scene().description.tickRate,
                            .duration = options.duration,
                            .elapsed = measured.elapsed,
                            .statistics = run.loop().snapshot().statistics,
                            .blocks = measured.blocks,
                            .fetchTime = run.fetchCost().perTick(),
                            .writingTime = measured.writingTime,
                            .views = measured.views};
    std::cout << (options.json ? loopReportJson(report) : loopReportText(report)) << '\n';
}

/// Before the work.
void requireFreeFolder(const LoopOptions& options) {
    if (!options.record.empty()) {
        requireFreeForRun(options.record, options.force);
    }
}

/// Null where none is asked for.
std::unique_ptr<RecordingThread> startRecording(const LoopOptions& options, LiveRun& run) {
    if (options.record.empty()) {
        return nullptr;
    }
    run.fetch([](const TickSample&) {});  // what a device begins with is not of the recording
    return std::make_unique<RecordingThread>(
        RecordingTarget{options.record, options.force, options.format}, run.loaded(),
        run.loop().memory(), run.device().delay());
}

[[noreturn]] void failRecording(const std::string& folder, const std::string& reason) {
    throw Error(folder + ": the recording has ended: " + reason +
                "; what was written until then is kept, and can be replayed");
}

/// @return the time to write a tick [s]
double finish(RecordingThread& recording) {
    try {
        recording.finish();
    } catch (const std::exception& error) {
        failRecording(recording.folder().string(), error.what());
    }
    if (recording.end() != RecordingEnd::None) {
        failRecording(recording.folder().string(), recording.end() == RecordingEnd::TicksLost
                                                       ? "ticks were lost"
                                                       : "the disk is slower than the loop");
    }
    return recording.timePerTick();
}

void runBare(const LoopOptions& options) {
    requireFreeFolder(options);
    LoadedScene loaded = loadForLoop(options);
    const DevicePath path = repeatedApproach(loaded.scene, options.duration);
    LiveRun run(std::move(loaded), path.front().position);
    ActiveDevice device;
    if (options.simulatedDevice) {
        device.attach(run);
        device.use(simulatedDriver());
        device.pilotAlong(path);
    } else {
        run.takeDevice(
            [&] { return std::make_unique<ScriptedDevice>(path, run.settings().positionGain); });
    }
    const CancelOnSignal cancel;
    const std::unique_ptr<RecordingThread> recording = startRecording(options, run);
    const auto hasEnded = [&recording] {
        return recording && recording->end() != RecordingEnd::None;
    };
    AlternatingBlocks blocks(run.loop(), run.scene().description.tickRate);
    const auto fetch = [&] {
        run.fetch([&recording](const TickSample& sample) {
            if (recording) {
                recording->take(sample);
            }
        });
    };
    const double begin = monotonicSeconds();
    while (!isDone(blocks, begin, options) && !CancelOnSignal::hasArrived() && !hasEnded()) {
        std::this_thread::sleep_for(kPoll);
        device.advance(std::chrono::duration<double>(kPoll).count(), 0.0);
        fetch();
        blocks.poll();
    }
    blocks.finish();
    const double elapsed = monotonicSeconds() - begin;
    fetch();
    const double writingTime = recording ? finish(*recording) : 0.0;
    print(options, run, {blocks, elapsed, writingTime, {}});
}

/// The second view in 3-D, which costs most, and the pages of all tools.
void openEverything(LiveWindow& live) {
    SecondViewSettings settings = live.panels().second().settings();
    settings.content = SecondContent::Space;
    live.panels().second().setSettings(settings);
    for (const char* const name : {"markers", "touches", "roughness", "profile"}) {
        live.window().menus().entry(name).trigger();
    }
}

void runInWindow(const LoopOptions& options) {
    requireFreeFolder(options);
    const VirtualDisplay display;
    LiveWindow live;
    Stage& stage = live.stage();
    openEverything(live);
    RecordingControl& recordings = stage.get<RecordingControl>();
    stage.runs().use(loadForLoop(options));
    LiveRun& run = *stage.run();
    live.panels().lock();
    live.window().lock();  // another scene would end the run that is measured
    const DevicePath path = repeatedApproach(run.scene(), options.duration);
    options.simulatedDevice ? stage.get<DeviceControl>().pilotDevice(path)
                            : stage.get<PathControl>().follow(path);
    if (!options.record.empty()) {
        recordings.start({options.record, options.force, options.format});
    }
    AlternatingBlocks blocks(run.loop(), run.scene().description.tickRate);
    const double begin = monotonicSeconds();
    QTimer poll;
    QObject::connect(&poll, &QTimer::timeout, [&] {
        blocks.poll();
        if (isDone(blocks, begin, options) || !recordings.failure().isEmpty()) {
            live.window().close();
        }
    });
    poll.start(kPoll);
    live.exec();
    blocks.finish();
    const double elapsed = monotonicSeconds() - begin;
    recordings.finish();
    if (!recordings.failure().isEmpty()) {
        failRecording(options.record, recordings.failure().toStdString());
    }
    print(options, run,
          {blocks, elapsed, recordings.writingTime(), stage.get<ViewControl>().rates()});
}

}  // namespace

void addLoopCommand(CLI::App& program) {
    CLI::App* command = program.add_subcommand(
        "loop", "Measure the real-time loop in wall time beside a bare loop in the same run");
    const auto options = std::make_shared<LoopOptions>();
    command->add_option("INPUT", options->input,
                        "height map or scene.toml; default: the scene that comes with the program");
    addScaleOptions(*command, options->scale);
    addCropOption(*command, options->crop);
    command->add_option("--rate", options->rate, "tick rate [Hz]; default: as in the scene")
        ->check(CLI::Range(kMinTickRate, kMaxTickRate))
        ->check(finiteNumber());
    command
        ->add_option(
            "--duration", options->duration,
            "duration of the measurement without loading [s]: the loop and a bare loop in turn, "
            "1 s each")
        ->capture_default_str()
        ->check(CLI::Range(0.1, 3600.0))
        ->check(finiteNumber());
    command
        ->add_option("--record", options->record,
                     "folder: also record every tick, and report the cost")
        ->check(notEmpty());
    addFormatOption(*command, options->format, "how the tables of the recording are kept")
        ->needs("--record");
    addForce(*command, options->force);
    command->add_flag("--simulated-device", options->simulatedDevice,
                      "drive the tip with a simulated force-feedback device, not a script: with "
                      "coupling, governor and workspace edge");
    command->add_flag("--window", options->window,
                      "open the window with all views and tools, and draw them during the loop");
    command->add_flag("--json", options->json, "print JSON");
    command->callback([options] { options->window ? runInWindow(*options) : runBare(*options); });
}

}  // namespace asperity
