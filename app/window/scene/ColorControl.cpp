#include "app/window/scene/ColorControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/LivePanels.h"
#include "ui/view/ColorsMenu.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <utility>

namespace asperity {

namespace {

QString nameOfImage(const SurfaceLook& look) {
    return look.quantity == SurfaceQuantity::Channel ? look.channel
                                                     : QObject::tr(nameOf(look.quantity));
}

/// What a map of the sample's material holds; null where it is no such quantity, or the same
/// everywhere.
std::shared_ptr<const PixelField> materialMap(SurfaceQuantity quantity, const Scene& scene) {
    const MaterialMaps& maps = scene.maps.sample;
    switch (quantity) {
    case SurfaceQuantity::YoungsModulus:
        return maps.youngsModulus;
    case SurfaceQuantity::WorkOfAdhesion:
        return maps.workOfAdhesion;
    case SurfaceQuantity::FrictionCoefficient:
        return maps.friction;
    default:
        return nullptr;
    }
}

constexpr std::array kOfMaterial{SurfaceQuantity::YoungsModulus, SurfaceQuantity::WorkOfAdhesion,
                                 SurfaceQuantity::FrictionCoefficient};

bool isOfMaterial(SurfaceQuantity quantity) {
    return std::ranges::find(kOfMaterial, quantity) != kOfMaterial.end();
}

}  // namespace

ColorControl::ColorControl(Stage& stage)
    : Feature(stage)
    , loader_({.progressed =
                   [this](double share) {
                       host_.tell(tr("Reading %1: %2 %")
                                      .arg(nameOfImage(look_))
                                      .arg(std::lround(100.0 * share)));
                   },
               .finished =
                   [this](PixelField& image) {
                       loaded_ = std::exchange(loading_, {});
                       image_ = std::make_shared<const PixelField>(std::move(image));
                       show();
                   },
               .failed =
                   [this](const std::exception_ptr& reason) {
                       loading_.clear();
                       showHeights(reasonOf(reason));
                   }}) {
    connect(&stage, &Stage::fieldOffered, this, &ColorControl::setForceMap);
    connect(&stage, &Stage::fieldWanted, this, &ColorControl::showForceMap);
    connect(&live_.colors(), &ColorsMenu::lookChosen, this, &ColorControl::choose);
    connect(&runs_, &RunControl::ending, this, &ColorControl::leaveScene);
    connect(&runs_, &RunControl::begun, this, &ColorControl::beginScene);
    connect(&runs_, &RunControl::sceneLeaving, this, &ColorControl::leaveScene);
    connect(&runs_, &RunControl::recordingShown, this, &ColorControl::beginScene);
    connect(&runs_, &RunControl::liveShown, this, &ColorControl::beginScene);
    runs_.beforeRecording(
        [this]() -> std::function<void()> { return [this, look = look_] { choose(look); }; });
    offer();
}

void ColorControl::setForceMap(const std::optional<SurfaceField>& map) {
    if (map && forceMap_ && map->name() != forceMap_->name()) {
        look_.freeRange(
            SurfaceQuantity::ForceMap);  // numbers of one quantity say nothing of another
    }
    forceMap_ = map;
    offer();
    if (look_.quantity == SurfaceQuantity::ForceMap) {
        look_.quantity = map ? look_.quantity : SurfaceQuantity::Height;
        show();
    }
}

void ColorControl::showForceMap() {
    look_ = live_.colors().look();
    look_.quantity = SurfaceQuantity::ForceMap;
    look_.channel.clear();
    show();
}

void ColorControl::choose(const SurfaceLook& look) {
    look_ = look;
    show();
}

/// Only a file holds them.
bool ColorControl::isOfFile() const {
    return look_.quantity == SurfaceQuantity::Residual ||
           look_.quantity == SurfaceQuantity::Channel;
}

/// What an image depends on: while it is the same, the image need not be read again.
std::string ColorControl::imageKey() const {
    const Scene& scene = runs_.scene();
    const SampleDescription& sample = scene.description.sample;
    std::ostringstream key;
    key << keyOf(look_.quantity) << '\n'
        << look_.channel.toStdString() << '\n'
        << sample.file << '\n'
        << runs_.loaded().sha256 << '\n'
        << scene.surface.sizeX() << '\n'
        << scene.surface.sizeY() << '\n';
    if (sample.crop) {
        key << sample.crop->column << ' ' << sample.crop->row << '\n';
    }
    if (look_.quantity == SurfaceQuantity::Residual) {
        key << sample.channel << '\n'
            << sample.smoothingPixels.value_or(0.0) << '\n'
            << sample.smoothingLength << '\n'
            << sample.erode << sample.imagingTipRadius << '\n'
            << textOf(sample.leveling);
        if (sample.levelPoints) {
            for (const Vector2& point : *sample.levelPoints) {
                key << '\n' << point.transpose();
            }
        }
    }
    return key.str();
}

/// Of a quantity that no file holds, or of heights until there is a scene.
SurfaceField ColorControl::field() const {
    const bool hasScene = runs_.run() != nullptr;
    if (look_.quantity == SurfaceQuantity::ForceMap) {
        return forceMap_.value_or(SurfaceField());
    }
    if (look_.quantity == SurfaceQuantity::Certainty) {
        return hasScene ? SurfaceField(runs_.scene().certainty) : SurfaceField();
    }
    if (isOfMaterial(look_.quantity)) {
        const auto map = hasScene ? materialMap(look_.quantity, runs_.scene()) : nullptr;
        return map != nullptr ? SurfaceField(look_.quantity, map) : SurfaceField();
    }
    return isOfFile() ? SurfaceField() : SurfaceField(look_.quantity);
}

void ColorControl::show() {
    if (runs_.run() == nullptr) {
        live_.showLook(look_, field());
        return;
    }
    if (!isOfFile()) {
        loader_.cancel();
        loading_.clear();
        live_.showLook(look_, field());
        return;
    }
    if (loaded_ == imageKey()) {
        live_.showLook(look_, SurfaceField(look_.quantity, image_, look_.channel.toStdString()));
        return;
    }
    live_.showLook(look_, SurfaceField());  // heights, until the image is read
    if (loading_ != imageKey()) {
        load();
    }
}

/// The surface is passed along: the run may end before.
void ColorControl::load() {
    const Scene& scene = runs_.scene();
    loading_ = imageKey();
    host_.tell(tr("Reading %1…").arg(nameOfImage(look_)));
    loader_.start([sample = scene.description.sample,
                   surface = std::make_shared<const BSplineSurface>(scene.surface),
                   channel = look_.channel.toStdString(),
                   isResidual = look_.quantity == SurfaceQuantity::Residual](Progress& progress) {
        return isResidual ? residualImage(sample, *surface, &progress)
                          : imageBeside(sample, *surface, channel, &progress);
    });
}

void ColorControl::showHeights(const QString& reason) {
    const QString name = nameOfImage(look_);
    look_.quantity = SurfaceQuantity::Height;
    look_.channel.clear();
    show();
    host_.complain(tr("%1 cannot be shown: %2").arg(name, reason));
}

/// Nothing of the scene stays behind.
void ColorControl::leaveScene() {
    loader_.cancel();
    loading_.clear();
    if (!SurfaceField(look_.quantity).isLive()) {
        live_.showLook(look_, SurfaceField());
    }
}

/// Returns whether the scene has nothing of the quantity.
bool ColorControl::isMissing() const {
    const Scene& scene = runs_.scene();
    const std::vector<std::string>& images = runs_.loaded().images;
    switch (look_.quantity) {
    case SurfaceQuantity::Channel:
        return std::ranges::find(images, look_.channel.toStdString()) == images.end();
    case SurfaceQuantity::Certainty:
        return !scene.certainty.isKnown();
    case SurfaceQuantity::Residual:
        return scene.description.sample.file.empty();
    case SurfaceQuantity::ForceMap:
        return !forceMap_;
    default:
        return isOfMaterial(look_.quantity) && materialMap(look_.quantity, scene) == nullptr;
    }
}

void ColorControl::beginScene() {
    offer();
    if (isMissing()) {
        host_.tell(tr("The scan has no %1: colored by height").arg(nameOfImage(look_)));
        look_.quantity = SurfaceQuantity::Height;
        look_.channel.clear();
    }
    show();
}

/// Which quantities the scene has.
void ColorControl::offer() {
    ColorsMenu& menu = live_.colors();
    menu.refuse(SurfaceQuantity::ForceMap,
                forceMap_ ? QString() : tr("There is no force map: Measure > Force map"));
    for (const SurfaceQuantity quantity : kOfMaterial) {
        const bool hasMap =
            runs_.run() != nullptr && materialMap(quantity, runs_.scene()) != nullptr;
        menu.refuse(quantity, hasMap ? QString()
                                     : tr("The material is the same everywhere: the scene names no "
                                          "map of it"));
    }
    if (runs_.run() == nullptr) {
        menu.refuse(SurfaceQuantity::Residual, tr("No scan is open"));
        menu.refuse(SurfaceQuantity::Certainty, tr("No scan is open"));
        return;
    }
    const Scene& scene = runs_.scene();
    QStringList images;
    for (const std::string& name : runs_.loaded().images) {
        images << QString::fromStdString(name);
    }
    menu.setChannels(images);
    menu.refuse(SurfaceQuantity::Certainty,
                scene.certainty.isKnown()
                    ? QString()
                    : tr("The scene does not say which tip recorded the scan: [sample] "
                         "imaging_tip_radius_m"));
    menu.refuse(SurfaceQuantity::Residual, scene.description.sample.file.empty()
                                               ? tr("The sample is a shape, not a scan")
                                               : QString());
}

}  // namespace asperity
