#include "ui/view/ZoomPicture.h"

#include "ui/Theme.h"
#include "ui/view/DrapedGrid.h"
#include "ui/view/SurfacePick.h"
#include "ui/view/ViewNotes.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <QObject>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

// In half widths of the frame.
constexpr double kMaxPatchReach = 0.85;
constexpr double kSlack = 0.35;        // how far the tip goes from the middle
constexpr double kSlackInDrag = 0.85;  // the picture stays still under the pointer
constexpr double kBlockDepth = 0.12;
constexpr double kMinFloor = 0.05;  // of block below a dent
constexpr double kGuideReach = 0.4;
constexpr double kOverlap = 0.015;  // of patch and terrain

constexpr double kDentStep = 1.5;    // a dent that needs more room gets so many times its depth
constexpr double kDentMargin = 0.1;  // of the picture's height, below a dent

// In sizes of tip and arrow.
constexpr double kTipTop = 1.15;
constexpr double kSmallGear = 0.6;  // of the frame: from here on outwards the lever is in the view
constexpr double kLeverHalfWidth = 0.5;
constexpr double kArrowRoom = 1.1;

constexpr double kStray = 0.25;  // of the tip from the middle of the patch, in its half widths

constexpr int kPatchSamples = 65;

bool isNearMiddle(const ScanWindow& patch, const Vector2& tip, double distance) {
    return std::abs(tip.x() - 0.5 * (patch.left + patch.right)) <= distance &&
           std::abs(tip.y() - 0.5 * (patch.bottom + patch.top)) <= distance;
}

/// Size of tip and arrow as drawn: as the frame up close, less of it from afar [m].
double gearSize(double halfWidth, double tipRadius) {
    return std::min(halfWidth, 1.5 * tipRadius + 0.4 * halfWidth);
}

}  // namespace

ZoomPicture::ZoomPicture(vtkGenericOpenGLRenderWindow* window)
    : cache_(window, still_)
    , terrain_(still_)
    , contact_(live_, through_)
    , tip_(live_)
    , lever_(live_)
    , section_({still_, live_}, live_)
    , force_(through_)
    , guide_(through_)
    , cross_(live_)
    , markers_(live_)
    , ghosts_(through_)
    , labels_(through_) {
    window->SetMultiSamples(0);
    window->SetNumberOfLayers(3);
    int layer = 0;
    for (vtkRenderer* renderer : {still_.Get(), live_.Get(), through_.Get()}) {
        renderer->SetLayer(layer++);
        renderer->SetActiveCamera(still_->GetActiveCamera());
        addLights(renderer);
        window->AddRenderer(renderer);
    }
    showTheme();
    live_->PreserveDepthBufferOn();
}

ZoomPicture::~ZoomPicture() = default;

void ZoomPicture::showTheme() {
    still_->SetBackground(theme::palette().backdrop.fractions().data());
    cache_.invalidate();
}

void ZoomPicture::setScene(const Scene* scene) {
    scene_ = scene;
    sample_.reset();
    trueTip_.reset();
    halfSpace_.reset();
    frame_.reset();
    forgetDents();
    shape_.reset();
    crossHair_.reset();
    terrain_.hide();
    cache_.invalidate();
    if (scene_ != nullptr) {
        scale_ = viewScale(*scene_);
        frame_.emplace(scene_->surface.sizeX(), scene_->surface.sizeY(), scale_.usual);
        placeTerrain({.window = frame_->window(), .hole = {}, .patch = {}});
    }
}

void ZoomPicture::showSample(const ViewCamera& camera, bool dragging) {
    if (sample_ && isDrawable(sample_->output.model)) {
        follow(sample_->output.model.tip.head<2>(), dragging ? kSlackInDrag : kSlack);
        showContact(*sample_, camera);
    } else {
        shape_.reset();
        contact_.hide();
        tip_.hide();
        lever_.hide();
        section_.hide();
        force_.hide();
        guide_.hide();
    }
    showGhosts(camera);
    showCrossHair();
    showMarkers();
}

void ZoomPicture::showTerrain(const ViewCamera& camera, TerrainDetail detail) {
    if (frame_) {
        terrain_.show(detail, {.colors = colors_,
                               .space = space(),
                               .shading = shading(camera),
                               .grid = options_.grid});
        cache_.invalidate();
    }
}

void ZoomPicture::follow(const Vector2& tip, double slack) {
    frame_->follow(tip, slack);
    const ScanWindow window = frame_->window();
    const double reach = std::min(scale_.patch, kMaxPatchReach * frame_->halfWidth());
    const ScanWindow hole = windowAround(tip, reach, window);
    const double lap = kOverlap * frame_->halfWidth();  // patch and terrain join without a crack
    // Where the patch is cut off by the frame's edge, its middle is elsewhere and does not stray.
    const Vector2 middle(0.5 * (hole.left + hole.right), 0.5 * (hole.bottom + hole.top));
    if (!sameWindow(window, terrain_.place().window) ||
        !isNearMiddle(terrain_.place().hole, middle, kStray * reach)) {
        placeTerrain(
            {.window = window, .hole = hole, .patch = windowAround(tip, reach + lap, window)});
    }
}

void ZoomPicture::placeTerrain(const TerrainPlace& place) {
    const bool otherWindow = !sameWindow(place.window, terrain_.place().window);
    terrain_.setPlace(scene_->surface, place);
    const std::array<double, 2> heights = terrain_.heightRange();
    colors_.fitHeights(heights[0], heights[1]);
    const bool otherColors = fitColors();
    terrain_.setBottom(drawnBottom() / options_.heightScale);
    if (isExtentAsked_ || !isTouching()) {  // the scale stays while the tip is in contact
        fitExtent();
    }
    Q_EMIT terrainPlaced();
    if (otherColors) {
        Q_EMIT scalesChanged();
    }
    if (otherWindow) {
        Q_EMIT frameChanged();
    }
}

/// @return whether the colors are others
bool ZoomPicture::fitColors() {
    if (colors_.isLive()) {
        return false;
    }
    return colors_.needsEnds() ? colors_.fitRest(terrain_.heightRange())
                               : colors_.fitRest(terrain_.valuesOf(colors_.field()));
}

void ZoomPicture::setLook(const SurfaceLook& look, const SurfaceField& field) {
    colors_.setLook(look, field);
    if (frame_) {
        fitColors();
        Q_EMIT terrainPlaced();
    }
    Q_EMIT scalesChanged();
}

/// Where the block of sample ends below, as drawn [m].
double ZoomPicture::drawnBottom() const {
    return options_.heightScale * (colors_.heightRange().low - dentDepth_) -
           kBlockDepth * frame_->halfWidth();
}

/// Of the heights of the colors, which seldom change, so that the picture seldom jumps [m].
double ZoomPicture::drawnMiddle() const {
    const AxisRange& heights = colors_.heightRange();
    return options_.heightScale * 0.5 * (heights.low + heights.high);
}

bool ZoomPicture::isTouching() const {
    return shape_ != nullptr && shape_->contact().contactRadius > 0.0;
}

/// From now on the picture holds what is in the frame at rest, and the tip above it.
void ZoomPicture::fitExtent() {
    const double above = options_.heightScale * colors_.heightRange().high - drawnMiddle();
    extent_ = {.halfWidth = frame_->halfWidth(),
               .below = drawnMiddle() - drawnBottom(),
               .above = above,
               .tipTop =
                   above + kTipTop * gearSize(frame_->halfWidth(), scene_->belief.tipRadius())};
    isExtentAsked_ = false;
}

Shading ZoomPicture::shading(const ViewCamera& camera) const {
    return {camera, space(), options_.light};
}

void ZoomPicture::forgetDents() {
    dentDepth_ = 0.0;
    lowered_ = 0.0;
    isExtentAsked_ = true;
}

/// The block reaches below the deepest dent since the scene or the zoom changed. It does not shrink
/// when the tip retracts: nothing but the tip shall move then. The picture keeps its scale and, as
/// long as the dent is in it, its place.
void ZoomPicture::makeRoomFor(const ContactShape& shape, const ViewCamera& camera) {
    const double low = colors_.heightRange().low;
    const double floor = kMinFloor * frame_->halfWidth() / options_.heightScale;
    const double missing = terrain_.bottom() + floor - shape.lowest();
    if (missing > 0.0) {
        dentDepth_ = kDentStep * (low - shape.lowest());
        terrain_.setBottom(drawnBottom() / options_.heightScale);
        Q_EMIT terrainPlaced();
    }
    keepInPicture(shape.contactPoint(), camera);
}

void ZoomPicture::keepInPicture(const Vector3& place, const ViewCamera& camera) {
    const int height = still_->GetSize()[1];
    const double missing = kDentMargin * height - drawnPlace(place).y();
    if (missing > 0.0 && camera.heightSeen() > 0.0) {
        lowered_ += kDentStep * missing * metersPerPixel(height) / camera.heightSeen();
        Q_EMIT terrainPlaced();
    }
}

void ZoomPicture::showContact(const TickSample& sample, const ViewCamera& camera) {
    shape_ = std::make_unique<const ContactShape>(
        *scene_, sample.output.model, terrain_.place().patch, kPatchSamples, halfSpace_.get());
    const ContactShape& shape = *shape_;
    const PatchColors colors(*scene_, shape, colors_);
    if (fitLiveColors(shape, colors)) {
        Q_EMIT scalesChanged();
    }
    makeRoomFor(shape, camera);
    const ScanWindow window = terrain_.place().window;
    const double width = std::max(window.right - window.left, window.top - window.bottom);
    const Shading shading = this->shading(camera);
    contact_.show(*scene_, shape,
                  {.colors = colors,
                   .space = space(),
                   .shading = shading,
                   .gridSpacing = options_.grid ? gridSpacing(width) : 0.0,
                   .gridArea = terrain_.place().patch,
                   .window = window,
                   .bottom = terrain_.bottom(),
                   .isCut = options_.section});
    showTip(shape, shading);
    showSection(shape, camera);
    guide_.show(sample.input.settings.guide, kGuideReach * frame_->halfWidth(), space());
    force_.show(sample.output.estimate, space().point(shape.contactPoint()), sample.time,
                scale_.force,
                kArrowRoom * gearSize(frame_->halfWidth(), shape.contact().tipRadius));
}

/// @return whether the colors are others
bool ZoomPicture::fitLiveColors(const ContactShape& shape, const PatchColors& colors) {
    const bool otherDisplacements = colors_.fitDisplacement(shape.largestDisplacement());
    if (!colors_.isLive()) {
        return otherDisplacements && colors_.field().quantity() == SurfaceQuantity::Height;
    }
    const Color before = colors_.ofLive(0.0);
    const bool others = colors_.fitLive(colors.values());
    if (colors_.ofLive(0.0) != before) {
        Q_EMIT terrainPlaced();  // it is far from the tip
    }
    return others;
}

/// Farther out than the tip alone.
bool ZoomPicture::showsLever() const {
    const double halfWidth = frame_->halfWidth();
    return gearSize(halfWidth, scene_->belief.tipRadius()) <= kSmallGear * halfWidth;
}

void ZoomPicture::showTip(const ContactShape& shape, const Shading& shading) {
    const double gear = gearSize(frame_->halfWidth(), shape.contact().tipRadius);
    const double height = kTipTop * gear;
    tip_.show(shape, {.height = height,
                      .paraboloidReach = scale_.paraboloidReach,
                      .space = space(),
                      .shading = shading});
    if (!showsLever()) {
        lever_.hide();
        return;
    }
    const CantileverGeometry& lever = scene_->description.probe;
    lever_.show({.shankTop = space().point(apexOf(shape.contact())) + height * Vector3::UnitZ(),
                 .size = kLeverHalfWidth * gear,
                 .azimuth = lever.azimuth,
                 .tilt = lever.mountTilt},
                shading);
}

void ZoomPicture::showSection(const ContactShape& shape, const ViewCamera& camera) {
    if (!options_.section) {
        section_.hide();
        return;
    }
    cache_.invalidate();  // the terrain is cut where the tip is
    section_.show(*scene_, shape,
                  {.window = terrain_.place().window,
                   .bottom = terrain_.bottom(),
                   .tip = tip_.body(),
                   .toEye = camera.out(),
                   .space = space(),
                   .shading = shading(camera)});
}

void ZoomPicture::showGhosts(const ViewCamera& camera) {
    if (!sample_ || !frame_) {
        ghosts_.show({}, {}, {}, {});
        return;
    }
    const double radius = scene_->belief.tipRadius();
    ghosts_.show(options_, sample_->output.base.position, trueTip_,
                 {.radius = radius,
                  .height = kTipTop * gearSize(frame_->halfWidth(), radius),
                  .paraboloidReach = scale_.paraboloidReach,
                  .right = camera.right(),
                  .space = space(),
                  .color = {}});
}

void ZoomPicture::setCrossHair(const std::optional<Vector2>& place, const QString& reading) {
    crossHair_ = place;
    reading_ = reading;
}

void ZoomPicture::showCrossHair() {
    if (!crossHair_ || !frame_) {
        cross_.hide();
        return;
    }
    cross_.show(scene_->surface, *crossHair_, terrain_.place().window, shape_.get(), space());
}

void ZoomPicture::showMarkers() {
    if (frame_) {
        markers_.show(scene_->description.markers, scene_->surface, terrain_.place().window,
                      space());
    } else {
        markers_.hide();
    }
}

std::optional<Vector2> ZoomPicture::placeAt(const Vector2& pixel) const {
    return frame_ ? seenPlace(scene_->surface, rayThrough(*still_, pixel, space()),
                              terrain_.place().window, shape_.get())
                  : std::nullopt;
}

SurfaceReading ZoomPicture::reading(const Vector2& place) const {
    return readingAt(*scene_, colors_.field(), shape_.get(), place);
}

void ZoomPicture::showLabels(const ViewCamera& camera, int height, double pixelRatio) {
    if (!frame_) {
        labels_.hide();
        return;
    }
    labels_.setPixelRatio(pixelRatio);
    LabelContent content{.scaleBars = options_.scaleBars && !camera.hasPerspective(),
                         .metersPerPixel = metersPerPixel(height),
                         .heightPerPixel =
                             metersPerPixel(height) / (options_.heightScale * camera.heightSeen()),
                         .notes = notes(camera),
                         .tipAbove = tipAbove(height, pixelRatio),
                         .force = sample_ ? sample_->output.estimate.force.stableNorm() : 0.0,
                         .forceEnd = force_.end(),
                         .names = ghosts_.names(),
                         .markers = markers_.names(),
                         .reading = crossHair_ ? reading_.toStdString() : std::string()};
    if (options_.axes) {
        content.axes = FrameAxes{.window = terrain_.place().window,
                                 .bottom = options_.heightScale * terrain_.bottom(),
                                 .toEye = camera.out()};
    }
    labels_.show(content);
}

std::vector<std::string> ZoomPicture::notes(const ViewCamera& camera) const {
    return viewNotes({.heightScale = options_.heightScale,
                      .hasPerspective = camera.hasPerspective(),
                      .missesTrueTip = options_.trueTip && sample_ && !trueTip_,
                      .showsLever = showsLever(),
                      .tipRadius = scene_->belief.tipRadius(),
                      .pixel = scale_.pixel,
                      .width = 2.0 * frame_->halfWidth()});
}

std::string ZoomPicture::tipAbove(int height, double pixelRatio) const {
    if (shape_ == nullptr || drawnPlace(apexOf(shape_->contact())).y() < pixelRatio * height) {
        return {};
    }
    return tipAboveNote(-shape_->contact().indentation);
}

void ZoomPicture::aim(const ViewCamera& camera, double aspect) {
    cache_.invalidate();
    if (frame_) {
        FrameBox box = extent_;
        box.middle = {frame_->center().x(), frame_->center().y(), drawnMiddle() - lowered_};
        camera.apply(still_->GetActiveCamera(), box, aspect);
    }
}

void ZoomPicture::setOptions(const ViewOptions& options) {
    options_ = options;
    cache_.invalidate();
    if (frame_) {
        forgetDents();
        fitExtent();
        terrain_.setBottom(drawnBottom() / options_.heightScale);
        Q_EMIT terrainPlaced();
    }
}

void ZoomPicture::setHalfWidth(double halfWidth) {
    forgetDents();
    frame_->setHalfWidth(std::max(halfWidth, scale_.least));
    if (!sample_ && !sameWindow(frame_->window(), terrain_.place().window)) {
        placeTerrain({.window = frame_->window(), .hole = {}, .patch = {}});
    }
}

Vector2 ZoomPicture::drawnPlace(const Vector3& place) const {
    const Vector3 drawn = space().point(place);
    still_->SetWorldPoint(drawn.x(), drawn.y(), drawn.z(), 1.0);
    still_->WorldToDisplay();
    const double* display = still_->GetDisplayPoint();
    return {display[0], display[1]};
}

double ZoomPicture::metersPerPixel(int height) const {
    return 2.0 * still_->GetActiveCamera()->GetParallelScale() / height;
}

}  // namespace asperity
