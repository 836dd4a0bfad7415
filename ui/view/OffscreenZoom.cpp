#include "ui/view/OffscreenZoom.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/deformation/HalfSpaceModel.h"
#include "core/scene/Scene.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/OffscreenPicture.h"
#include "vtkplugins/pictures/Panel.h"

#include <vtkLookupTable.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderWindow.h>

#include <QObject>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

namespace asperity {

namespace {

constexpr int kOversampling = 2;
constexpr int kMinBand = 32;  // that can be drawn [pixel]

// In pixels of the letters.
constexpr double kBarHeight = 54.0;
constexpr double kBarEdge = 18.0;
constexpr double kBarTop = 8.0;
constexpr double kWideEnough = 640.0;  // for two bars side by side
constexpr double kHighEnough = 320.0;  // for a view above them

/// Heights have a bar for displacements beside their own.
bool hasTwoBars(const OffscreenZoomLook& look) {
    const SurfaceQuantity shown =
        look.shown ? look.shown->colors.field().quantity() : SurfaceQuantity::Height;
    return look.color.value_or(shown) == SurfaceQuantity::Height;
}

/// How many rows of color bars a picture of this size has; side by side they are one.
int barRows(const OffscreenZoomLook& look) {
    const double ratio = look.look.pixelRatio;
    if (!look.parts.bars || look.size.height / ratio < kHighEnough) {
        return 0;
    }
    return hasTwoBars(look) && look.size.width / ratio < kWideEnough ? 2 : 1;
}

PictureSize barsSize(const OffscreenZoomLook& look) {
    const int rows = barRows(look);
    const double height = rows * kBarHeight * look.look.pixelRatio;
    const int band = rows == 0 ? 0 : std::max(kMinBand, static_cast<int>(std::lround(height)));
    // A tiny picture is all view.
    const bool hasRoom = look.size.height >= band + kMinBand && look.size.width >= kMinBand;
    return {.width = look.size.width, .height = hasRoom ? band : 0};
}

vtkSmartPointer<vtkLookupTable> tableOf(const ColorScale& scale) {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    table->SetNumberOfTableValues(static_cast<vtkIdType>(scale.colors.size()));
    table->SetRange(scale.low, scale.high);
    for (std::size_t i = 0; i < scale.colors.size(); ++i) {
        const QColor& color = scale.colors[i];
        table->SetTableValue(static_cast<vtkIdType>(i), color.redF(), color.greenF(),
                             color.blueF());
    }
    return table;
}

void paintBar(Painter& painter, const ColorScale& scale, const PixelRect& area) {
    if (scale.colors.empty() || !(scale.high > scale.low)) {
        return;
    }
    const auto table = tableOf(scale);
    drawColorBar(
        painter,
        {scale.quantity.toStdString(), scale.unit.toStdString(), scale.low, scale.high, table},
        area);
}

}  // namespace

OffscreenZoom::OffscreenZoom(const Scene& scene, const OffscreenZoomLook& look)
    : scene_(scene)
    , look_(look)
    , bars_(barsSize(look))
    , view_({.width = look.size.width, .height = look.size.height - bars_.height}) {
    requireDrawable(look.size);
    const theme::LightColors light;
    prepareOffscreen(window_, view_, kOversampling);
    picture_.emplace(vtkOpenGLRenderWindow::SafeDownCast(window_));
    setUp(scene);
}

OffscreenZoom::~OffscreenZoom() = default;

void OffscreenZoom::setUp(const Scene& scene) {
    picture_->cache().setEnabled(false);
    if (look_.look.transparent) {
        picture_->setTransparent();
    }
    QObject::connect(&*picture_, &ZoomPicture::terrainPlaced, [this] { moved_ = true; });
    QObject::connect(&*picture_, &ZoomPicture::scalesChanged, [this] { drawnBars_.reset(); });
    picture_->setScene(&scene);
    picture_->setOptions(options());
    if (look_.shown) {
        camera_ = look_.shown->camera;
        picture_->setColors(look_.shown->colors);
        setColor();
        picture_->setHalfWidth(look_.shown->halfWidth);
        picture_->keepHalfWidth();
        return;
    }
    setColor();
    if (look_.side) {
        camera_.lookFrom(*look_.side);
    }
    if (look_.width) {
        setWidth(*look_.width);
    }
}

/// A part that the window's view does not show is not shown here.
ViewOptions OffscreenZoom::options() const {
    ViewOptions options = look_.shown ? look_.shown->options
                                      : ViewOptions{.heightScale = look_.heightScale,
                                                    .grid = true,
                                                    .section = look_.section,
                                                    .light = {}};
    options.axes = options.axes && look_.parts.bars;
    options.scaleBars = options.scaleBars && look_.parts.bars;
    options.grid = options.grid && look_.parts.surfaceGrid;
    options.labels = options.labels && look_.parts.labels;
    return options;
}

void OffscreenZoom::setColor() {
    if (look_.color) {
        SurfaceLook colors;
        colors.quantity = *look_.color;
        picture_->setLook(colors, SurfaceField(*look_.color));
    }
}

void OffscreenZoom::setWidth(double width) {
    picture_->setHalfWidth(0.5 * width);
    picture_->keepHalfWidth();
    const double shown = 2.0 * picture_->frame()->halfWidth();
    if (std::abs(shown - width) > 1e-9 * width) {
        throw Error("a frame of " + formatSi(width, "m") +
                    " cannot be shown of this scene; the nearest is " + formatSi(shown, "m"));
    }
}

void OffscreenZoom::aim() {
    const double ratio = look_.look.pixelRatio;
    picture_->aim(camera_, static_cast<double>(view_.width) / view_.height,
                  look_.parts.bars ? wordRoom(view_.width / ratio, view_.height / ratio)
                                   : WordRoom{});
}

/// As often as the frame moves with what is shown in it: a dent lowers the picture by steps.
void OffscreenZoom::show(const TickSample& sample) {
    constexpr int kSteps = 16;
    if (look_.shown) {
        picture_->setHalfSpace(look_.shown->halfSpace);
    } else if (scene_.model.deformation == DeformationModel::HalfSpace) {
        picture_->setHalfSpace(std::make_shared<const HalfSpaceAnswer>(
            HalfSpaceModel().solve(scene_, sample.output.model)));
    }
    picture_->setSample(sample, look_.shown ? look_.shown->trueTip : std::nullopt);
    bool isDue = moved_;
    for (int step = 0; step < kSteps; ++step) {
        moved_ = false;
        picture_->showSample(camera_, false);
        isDue = isDue || moved_;
        aim();
        if (!moved_) {
            break;
        }
    }
    moved_ = isDue;
}

void OffscreenZoom::foresee(const TickSample& sample) {
    const theme::LightColors light;
    show(sample);
}

void OffscreenZoom::keepScales() {
    const theme::LightColors light;
    picture_->keepScales();
}

RasterImage OffscreenZoom::draw(const TickSample& sample, const std::string& caption) {
    const theme::LightColors light;
    show(sample);
    if (moved_) {
        picture_->showTerrain(camera_, TerrainDetail::Fine);
        moved_ = false;
    }
    const double drawnRatio = kOversampling * look_.look.pixelRatio;
    picture_->setCaption(caption);
    picture_->showLabels(camera_, view_.height / look_.look.pixelRatio, drawnRatio);
    RasterImage image = drawnImage(window_, kOversampling, look_.look.transparent, drawnRatio);
    if (bars_.height == 0) {
        return image;
    }
    if (!drawnBars_) {
        drawnBars_ = barsImage();
    }
    return stacked(std::move(image), *drawnBars_);
}

RasterImage OffscreenZoom::barsImage() const {
    OffscreenPicture band(bars_, look_.look);
    const PixelRect area = band.area();
    const int rows = barRows(look_);
    const ColorScale quantity = picture_->colors().scale();
    const ColorScale displacement = picture_->colors().displacementScale();
    band.paint([&](Painter& painter) {
        const double columns = rows == 1 && hasTwoBars(look_) ? 2.0 : 1.0;
        const double width = (area.width - (columns + 1.0) * kBarEdge) / columns;
        const double top = area.top() - kBarTop;
        const PixelRect first{kBarEdge, top - (kBarHeight - kBarTop), width, kBarHeight - kBarTop};
        PixelRect second = first;
        second.left += rows == 1 ? width + kBarEdge : 0.0;
        second.bottom -= rows == 1 ? 0.0 : kBarHeight;
        paintBar(painter, quantity, first);
        paintBar(painter, displacement, second);
    });
    return band.image();
}

double OffscreenZoom::metersPerPixel() const {
    return picture_->metersPerPixel(view_.height / look_.look.pixelRatio);
}

}  // namespace asperity
