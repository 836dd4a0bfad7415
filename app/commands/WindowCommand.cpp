#include "app/commands/WindowCommand.h"

#include "app/commands/LevelingOption.h"
#include "app/commands/OptionChecks.h"
#include "app/commands/ProgressLine.h"
#include "app/commands/ScaleOption.h"
#include "app/program/DataFolder.h"
#include "app/runs/OutputFolder.h"
#include "app/window/Stage.h"
#include "app/window/device/DemonstrationControl.h"
#include "app/window/lab/Features.h"
#include "app/window/lab/LiveWindow.h"
#include "app/window/recording/RecordingControl.h"
#include "app/window/scene/SceneControl.h"
#include "app/window/session/SessionControl.h"
#include "core/Error.h"
#include "vtkplugins/pictures/Display.h"

#include <QAction>

#include <CLI/CLI.hpp>
#include <exception>
#include <filesystem>
#include <iostream>
#include <system_error>

namespace asperity {

namespace {

/// A bare word that is no file is more likely a command with a slip than a scan.
CLI::Validator noMistypedCommand() {
    return {[](const std::string& text) {
                std::error_code ignored;
                const bool word = text.find_first_of("./") == std::string::npos;
                return word && !std::filesystem::exists(text, ignored)
                           ? text + " is neither a command nor a file"
                           : std::string();
            },
            ""};
}

/// Records the first scene that is shown.
void recordFromTheStart(Stage& stage, const RecordingTarget& target) {
    auto* const once = new QObject(&stage);
    QObject::connect(&stage.runs(), &RunControl::begun, once, [&stage, once, target] {
        once->deleteLater();
        stage.get<RecordingControl>().start(target);
    });
}

/// Opens a file in the window. Where that fails the program ends as every command does, but where
/// the scale is all that is missing: the window asks for it. From then on the window stays,
/// whatever a user opens in it.
/// @param reason why the program ends
void openOrQuit(Stage& stage, std::exception_ptr& reason) {
    SceneControl& scenes = stage.get<SceneControl>();
    const auto quits = QObject::connect(&scenes, &SceneControl::openFailed, [&scenes, &reason] {
        reason = scenes.openError();
        QApplication::quit();
    });
    const auto goOn = [quits] { QObject::disconnect(quits); };
    QObject::connect(&stage.runs(), &RunControl::begun, goOn);
    QObject::connect(&scenes, &SceneControl::openCanceled, goOn);
    QObject::connect(&scenes, &SceneControl::scaleAsked, goOn);
    showShippedInstead(stage);
}

/// The same for a run that is recorded: there is no other scene to record.
void recordOrQuit(Stage& stage, const std::filesystem::path& input, std::exception_ptr& reason) {
    SceneControl& scenes = stage.get<SceneControl>();
    auto* const once = new QObject(&stage);
    const auto quit = [&stage, once, &reason](const std::exception_ptr& why) {
        if (stage.run() == nullptr) {
            reason = why;
            QApplication::quit();
        }
        once->deleteLater();
    };
    QObject::connect(&scenes, &SceneControl::openFailed, once,
                     [quit, &scenes] { quit(scenes.openError()); });
    QObject::connect(&scenes, &SceneControl::openCanceled, once, [quit, input] {
        quit(std::make_exception_ptr(
            InputError(input.string(), "", "it was not opened; nothing is recorded")));
    });
    QObject::connect(&stage.runs(), &RunControl::begun, once, &QObject::deleteLater);
}

/// Opens the program's own scene where the last session cannot be opened any more.
void openLastSession(Stage& stage) {
    auto* const once = new QObject(&stage);
    QObject::connect(&stage.get<SceneControl>(), &SceneControl::openFailed, once, [&stage, once] {
        once->deleteLater();
        const std::filesystem::path shipped = defaultSceneFile();
        if (stage.run() == nullptr && !shipped.empty()) {
            stage.get<SceneControl>().open(shipped);
        }
    });
    QObject::connect(&stage.runs(), &RunControl::begun, once, &QObject::deleteLater);
    showShippedInstead(stage);
    stage.get<SessionControl>().openLast();
}

int execWith(LiveWindow& live, const std::filesystem::path& input, const SceneOverrides& overrides,
             bool isRecorded) {
    std::exception_ptr reason;
    live.stage().get<SceneControl>().setFit(isRecorded ? ModelFit::Now : ModelFit::Later);
    isRecorded ? recordOrQuit(live.stage(), input, reason) : openOrQuit(live.stage(), reason);
    live.stage().get<SceneControl>().open(input, overrides);
    const int status = live.exec();
    if (reason) {
        std::rethrow_exception(reason);
    }
    return status;
}

/// Without a file: the last session, or a demonstration on a scene that comes with the program.
int execAsBefore(LiveWindow& live) {
    if (live.stage().get<SessionControl>().startsWithLast()) {
        openLastSession(live.stage());
        return live.exec();
    }
    const std::filesystem::path shipped = firstSceneFile();
    if (shipped.empty()) {
        return live.exec();
    }
    live.stage().get<DemonstrationControl>().beginWithNextRun();
    return execWith(live, shipped, {}, false);
}

int exec(LiveWindow& live, const WindowOptions& options, const SceneOverrides& overrides) {
    const bool isRecorded = !options.record.empty();
    if (options.input.empty() && !isRecorded) {
        return execAsBefore(live);
    }
    const std::filesystem::path input =
        options.input.empty() ? defaultSceneFile() : std::filesystem::path(options.input);
    return input.empty() ? live.exec() : execWith(live, input, overrides, isRecorded);
}

}  // namespace

std::shared_ptr<WindowOptions> addWindowOptions(CLI::App& program) {
    auto options = std::make_shared<WindowOptions>();
    program
        .add_option("INPUT", options->input,
                    "height map or scene.toml to open in the window; without one, the scene that "
                    "comes with the program")
        ->check(noMistypedCommand());
    program.add_option("--channel", options->channel, "channel of the height map to open");
    addScaleOptions(program, options->scale);
    addCropOption(program, options->crop);
    addLevelingOptions(program, options->leveling, options->levelPoints,
                       "default: as in the scene, or plane");
    program
        .add_option("--record", options->record,
                    "folder: record every tick of the scene from the first one on")
        ->check(notEmpty());
    addFormatOption(program, options->format, "how the tables of the recording are kept")
        ->needs("--record");
    addForce(program, options->force);
    program.add_flag("--time-start", options->timeStart,
                     "print, as JSON, how long it took until the window and the first picture of "
                     "the scan were shown, and end");
    return options;
}

int openWindow(const WindowOptions& options) {
    const SceneOverrides overrides{.channel = options.channel,
                                   .leveling = options.leveling,
                                   .levelPoints = options.levelPoints,
                                   .scale = options.scale,
                                   .crop = options.crop};
    if (!options.input.empty() && !haveDisplay()) {
        (void)loadSceneOnTerminal(options.input,
                                  overrides);  // what is wrong with the input comes first
    }
    if (!options.record.empty()) {
        requireFreeForRun(options.record, options.force);
    }
    LiveWindow live;
    live.remember(userSettings());
    live.stage().get<RecordingControl>().recoverCutOff();
    if (!options.record.empty()) {
        recordFromTheStart(live.stage(), {options.record, options.force, options.format});
    }
    keepSession(live.stage(), sessionFolder());
    std::optional<StartTimes> times;
    if (options.timeStart) {
        times.emplace(live);
    }
    const int status = exec(live, options, overrides);
    if (times) {
        std::cout << times->json() << '\n';
    }
    return status;
}

}  // namespace asperity
