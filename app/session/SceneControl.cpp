#include "app/session/SceneControl.h"

#include "app/recording/Bundle.h"
#include "app/runs/RunFolder.h"
#include "app/session/StayingRun.h"
#include "app/session/WindowSection.h"
#include "core/Error.h"
#include "core/PathText.h"
#include "core/io/heightmap/MissingScale.h"
#include "core/surface/MergedScale.h"
#include "ui/ShownPath.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

#include <memory>
#include <utility>

namespace asperity {

namespace {

/// Loads a file; of a bundle its scene. @param read (scene) -> LoadedScene
template <class Read>
LoadedScene loadedOf(const std::filesystem::path& input, Progress& progress, const Read& read) {
    if (!isBundle(input)) {
        return read(input);
    }
    ProgressPart unpacking(&progress, 0.0, 0.3);
    const std::filesystem::path folder = stayingRun(input, &unpacking);
    return readStaying(input, folder, [&] { return read(folder / run_files::kScene); });
}

}  // namespace

SceneControl::SceneControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window), runs_(runs), edits_(edits), scales_(window) {
    connect(&window, &MainWindow::openRequested, this, [this](const QString& file) {
        const std::string text = file.toStdString();
        open(pathFromText(text).value_or(text));
    });
    WindowMenus& menus = window.menus();
    connect(menus.undo, &QAction::triggered, &edits, &SceneEdits::undo);
    connect(menus.redo, &QAction::triggered, &edits, &SceneEdits::redo);
    connect(&menus, &WindowMenus::channelChosen, this, &SceneControl::chooseChannel);
    connect(&scales_, &ScaleControl::given, this, [this](const GivenScale& scale) {
        const Retry retry = retry_;
        retry(scale);
    });
    connect(&scales_, &ScaleControl::refused, this, &SceneControl::openCanceled);
    connect(&edits, &SceneEdits::scaleMissing, this,
            [this](const std::filesystem::path& file, const ScaleGap& gap, const QString& name,
                   const SceneDescription& next) {
                askForScale(file, gap, [this, name, next](const GivenScale& scale) {
                    SceneDescription scaled = next;
                    scaled.sample.scale = merged(scaled.sample.scale, scale);
                    edits_.change(name, scaled);
                });
            });
    connect(&runs, &RunControl::begun, this, &SceneControl::showChannels);
    connect(&edits, &SceneEdits::changed, this, &SceneControl::showChannels);
}

void SceneControl::open(const std::filesystem::path& input, const SceneOverrides& overrides,
                        const FailureWords& failureWords) {
    askedWith_ = overrides;
    const auto kept = std::make_shared<QVariantMap>();
    begin(input,
          {.name = {},
           .load =
               [input, overrides, kept, fit = fit_](Progress& progress) {
                   return loadedOf(input, progress, [&](const std::filesystem::path& scene) {
                       *kept = windowSectionOf(scene);
                       return loadScene(scene, overrides, &progress, fit);
                   });
               },
           .place = [kept] { return tipPlaceIn(*kept); },
           .opened =
               [this, input, kept] {
                   Q_EMIT opened(input);
                   if (!kept->isEmpty()) {
                       Q_EMIT sessionOpened(input, *kept);
                   }
               },
           .failed = {},
           .canceled = {}},
          failureWords);
}

void SceneControl::open(const std::filesystem::path& input, const LongWork<LoadedScene>::Work& load,
                        const std::function<void()>& shown) {
    begin(input, {.name = {}, .load = load, .opened = shown, .failed = {}, .canceled = {}});
}

void SceneControl::begin(const std::filesystem::path& input, SceneEdits::Opening opening,
                         const FailureWords& failureWords) {
    scales_.withdraw();
    asked_ = input;
    const QString name = shownPath(input.filename());
    opening.name = name;
    opening.opened = [this, opened = opening.opened] {
        Q_EMIT sceneTaken();
        opened();
    };
    opening.failed = [this, failureWords](const std::exception_ptr& reason) {
        fail(reason, failureWords);
    };
    opening.canceled = [this, name] {
        window_.tell(tr("Loading of %1 canceled").arg(name));
        Q_EMIT openCanceled();
    };
    edits_.open(std::move(opening));
}

void SceneControl::cancelOpen() { edits_.cancel(); }

void SceneControl::fail(const std::exception_ptr& reason, const FailureWords& words) {
    if (asksFor(reason)) {
        return;
    }
    openError_ = reason;
    const QString why = reasonOf(reason);
    window_.complain(words ? words(why) : why);
    Q_EMIT openFailed(why);
}

bool SceneControl::asksFor(const std::exception_ptr& reason) {
    try {
        std::rethrow_exception(reason);
    } catch (const MissingScale& missing) {
        askForScale(missing.path(), missing.gap(), [this](const GivenScale& scale) {
            SceneOverrides overrides = askedWith_;
            overrides.scale = merged(overrides.scale, scale);
            open(asked_, overrides);
        });
        return true;
    } catch (...) {
        return false;
    }
}

void SceneControl::askForScale(const std::filesystem::path& file, const ScaleGap& gap,
                               const Retry& retry) {
    retry_ = retry;
    scales_.ask(file, gap);
    Q_EMIT scaleAsked();
}

void SceneControl::chooseChannel(const QString& name) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.sample.channel = name.toStdString();
        edits_.change(tr("Channel: %1").arg(name), next);
    }
}

void SceneControl::showChannels() {
    const SceneDescription* const scene = edits_.wanted();
    if (scene == nullptr) {
        return;
    }
    QStringList names;
    for (const std::string& name : runs_.run()->loaded().channels) {
        names << QString::fromStdString(name);
    }
    window_.menus().setChannels(names, QString::fromStdString(scene->sample.channel));
}

}  // namespace asperity
