#include "app/session/SceneControl.h"

#include "app/program/DataFolder.h"
#include "core/Error.h"
#include "core/PathText.h"
#include "core/PrintableText.h"
#include "core/io/heightmap/MissingScale.h"
#include "core/io/scene/SceneFile.h"
#include "core/scene/SceneParameter.h"
#include "core/surface/MergedScale.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/LoadingBar.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace asperity {

SceneControl::SceneControl(MainWindow& window, RunControl& runs)
    : window_(window)
    , runs_(runs)
    , scales_(window)
    , loader_({.progressed = [&window](double share) { window.loading().setFraction(share); },
               .finished = [this](LoadedScene& scene) { use(scene); },
               .failed = [this](const std::exception_ptr& reason) { fail(reason); }}) {
    readMaterials();
    connect(&window, &MainWindow::openRequested, this, [this](const QString& file) {
        const std::string text = file.toStdString();
        open(pathFromText(text).value_or(text));
    });
    connect(window.menus().cancelLoading, &QAction::triggered, this, &SceneControl::cancelOpen);
    connect(&window.loading(), &LoadingBar::cancelRequested, this, &SceneControl::cancelOpen);
    connect(&window.controls(), &ControlBar::materialChosen, this, &SceneControl::chooseMaterial);
    connect(&window.menus(), &WindowMenus::channelChosen, this, &SceneControl::chooseChannel);
    connect(&scales_, &ScaleControl::given, this, [this](const GivenScale& scale) {
        SceneOverrides overrides = askedWith_;
        overrides.scale = merged(overrides.scale, scale);
        open(asked_, overrides);
    });
    connect(&scales_, &ScaleControl::refused, this, &SceneControl::openCanceled);
    connect(&runs, &RunControl::begun, this, &SceneControl::showMaterials);
    connect(&runs, &RunControl::begun, this, &SceneControl::showChannels);
    connect(this, &SceneControl::openCanceled, this, &SceneControl::showChannels);
    connect(this, &SceneControl::openFailed, this, &SceneControl::showChannels);
}

void SceneControl::readMaterials() {
    for (const std::filesystem::path& file : dataFiles("materials")) {
        try {
            SceneDescription scene = defaultScene();
            scene.sample.material = readMaterialFile(file);
            scene.truth.material = scene.sample.material;
            checkScene(scene);
            materials_.push_back(scene.sample.material);
        } catch (const Error& error) {
            window_.tell(QString::fromUtf8(error.what()));
        }
    }
}

void SceneControl::open(const std::filesystem::path& input, const SceneOverrides& overrides) {
    scales_.withdraw();
    asked_ = input;
    askedWith_ = overrides;
    loading_ = QString::fromStdString(printable(input.filename().string()));
    window_.showLoading(loading_);
    loader_.start(
        [input, overrides](Progress& progress) { return loadScene(input, overrides, &progress); });
}

void SceneControl::cancelOpen() {
    if (loading_.isEmpty()) {
        return;
    }
    loader_.cancel();
    window_.showLoading({});
    window_.tell(tr("Loading of %1 canceled").arg(std::exchange(loading_, {})));
    Q_EMIT openCanceled();
}

void SceneControl::endLoading() {
    loading_.clear();
    window_.showLoading({});
}

void SceneControl::use(LoadedScene& scene) {
    endLoading();
    open_ = asked_;
    runs_.use(std::move(scene));
}

void SceneControl::fail(const std::exception_ptr& reason) {
    endLoading();
    if (asksFor(reason)) {
        return;
    }
    openError_ = reason;
    const QString words = reasonOf(reason);
    window_.complain(words);
    Q_EMIT openFailed(words);
}

bool SceneControl::asksFor(const std::exception_ptr& reason) {
    try {
        std::rethrow_exception(reason);
    } catch (const MissingScale& missing) {
        scales_.ask(missing.path(), missing.gap());
        Q_EMIT scaleAsked();
        return true;
    } catch (...) {
        return false;
    }
}

void SceneControl::chooseChannel(const QString& name) {
    open(open_,
         {.channel = name.toStdString(), .scale = runs_.run()->scene().description.sample.scale});
}

void SceneControl::chooseMaterial(int index) {
    if (runs_.run() == nullptr) {
        return;
    }
    const SampleMaterial& material = materials_.at(static_cast<std::size_t>(index));
    SceneDescription changed = runs_.run()->scene().description;
    changed.sample.material = material;
    try {
        runs_.run()->requireHolding(changed);
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        showMaterials();
        return;
    }
    runs_.rebuild(
        [&material](LoadedScene scene) { return withMaterial(std::move(scene), material); });
}

void SceneControl::showChannels() {
    if (runs_.run() == nullptr) {
        return;
    }
    QStringList names;
    for (const std::string& name : runs_.run()->loaded().channels) {
        names << QString::fromStdString(name);
    }
    const SampleDescription& sample = runs_.run()->scene().description.sample;
    window_.menus().setChannels(names, QString::fromStdString(sample.channel));
}

void SceneControl::showMaterials() {
    const SampleMaterial& own = runs_.run()->scene().description.sample.material;
    if (std::find(materials_.begin(), materials_.end(), own) == materials_.end()) {
        std::erase_if(materials_, [&own](const SampleMaterial& material) {
            return material.name == own.name && own.name.ends_with(kEditedSuffix);
        });
        materials_.push_back(own);
    }
    QStringList names;
    for (const SampleMaterial& material : materials_) {
        names.push_back(QString::fromStdString(material.name).replace('_', ' '));
    }
    ControlBar& controls = window_.controls();
    controls.setMaterials(names);
    controls.setMaterial(static_cast<int>(std::find(materials_.begin(), materials_.end(), own) -
                                          materials_.begin()));
}

}  // namespace asperity
