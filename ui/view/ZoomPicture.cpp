#include "ui/view/ZoomPicture.h"

#include "core/scene/Scene.h"
#include "ui/view/TerrainLayer.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkCamera.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkRenderer.h>

#include <cmath>

namespace asperity {

namespace {

// In half widths of the frame.
constexpr double kMaxPatchReach = 0.85;
constexpr double kSlack = 0.35;        // how far the tip goes from the middle
constexpr double kSlackInDrag = 0.85;  // the picture stays still under the pointer
constexpr double kGuideReach = 0.4;
constexpr double kTargetArm = 0.16;
constexpr double kOverlap = 0.015;  // of patch and terrain

constexpr double kWideningStep = 1.2;  // a tip that needs a wider frame gets so many times that
constexpr double kLoweringStep = 1.5;  // a dent below the picture lowers it by so many times that
constexpr double kDentMargin = 0.1;    // of the picture's height, below a dent

constexpr double kArrowRoom = 1.1;    // in sizes of tip and arrow
constexpr double kStartTip = 0.7;     // of its height, seen of a tip at the start
constexpr double kMaxStartGap = 1.0;  // below it, in half widths of the frame
constexpr double kMaxTip = 4.0;       // height above the apex, in half widths of the frame
constexpr double kTopMargin = 0.015;  // above the tip, of the picture's height

constexpr double kStray = 0.25;  // of the tip from the middle of the patch, in its half widths

constexpr int kPatchSamples = 65;

bool isNearMiddle(const ScanWindow& patch, const Vector2& tip, double distance) {
    return std::abs(tip.x() - 0.5 * (patch.left + patch.right)) <= distance &&
           std::abs(tip.y() - 0.5 * (patch.bottom + patch.top)) <= distance;
}

}  // namespace

ZoomPicture::ZoomPicture(vtkOpenGLRenderWindow* window)
    : cache_(window, still_)
    , terrain_(still_)
    , contact_(live_, through_)
    , tip_(live_)
    , section_({still_, live_}, live_)
    , force_(through_)
    , guide_(through_)
    , cross_(live_)
    , markers_(live_)
    , target_(through_)
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

void ZoomPicture::setTransparent() {
    still_->SetBackground(0.0, 0.0, 0.0);
    still_->SetBackgroundAlpha(0.0);
}

void ZoomPicture::setScene(const Scene* scene) {
    scene_ = scene;
    sample_.reset();
    trueTip_.reset();
    writtenForce_.clear();
    halfSpace_.reset();
    frame_.reset();
    extent_.forget();
    startGap_.reset();
    shown_ = {};
    shape_.reset();
    crossHair_.reset();
    terrain_.hide();
    cache_.invalidate();
    colors_.forgetScene();
    if (scene_ != nullptr) {
        scale_ = viewScale(*scene_);
        frame_.emplace(scene_->surface.sizeX(), scene_->surface.sizeY(), scale_.usual);
        placeTerrain({.window = frame_->window(), .hole = {}, .patch = {}});
    }
}

void ZoomPicture::showSample(const ViewCamera& camera, bool dragging) {
    if (sample_ && isDrawable(sample_->output.model)) {
        makeRoomForStart(sample_->output.model);
        widenFor(sample_->output.model.contact.indentation);
        follow(sample_->output.model.tip.head<2>(), dragging ? kSlackInDrag : kSlack);
        showContact(*sample_, camera);
    } else {
        shape_.reset();
        contact_.hide();
        tip_.hide();
        section_.hide();
        force_.hide();
        guide_.hide();
    }
    showGhosts(camera);
    showCrossHair();
    showMarkers();
    showTarget();
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

/// A tip that is pressed in deep stays inside of the block of sample.
void ZoomPicture::widenFor(double indentation) {
    const TipOutline outline{scene_->description.tip.shape(), scale_.paraboloidReach};
    const double needed = outline.frameAround(options_.deformation ? indentation : 0.0);
    if (isWidthKept_ || gear().isCap() || needed <= frame_->halfWidth()) {
        return;
    }
    const double before = frame_->halfWidth();
    frame_->setHalfWidth(kWideningStep * needed);
    if (frame_->halfWidth() > before) {  // it does not show the whole scan yet
        extent_.forget();
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
    if (!sameWindow(window, terrain_.area().window) ||
        !isNearMiddle(terrain_.area().hole, middle, kStray * reach)) {
        placeTerrain(
            {.window = window, .hole = hole, .patch = windowAround(tip, reach + lap, window)});
    }
}

void ZoomPicture::placeTerrain(const TerrainArea& area) {
    const bool otherWindow = !sameWindow(area.window, terrain_.area().window);
    terrain_.setArea(scene_->surface, area);
    fitHeights();
    const bool otherColors = fitColors();
    // The scale stays while the tip is in contact.
    if (extent_.isFitWanted() || !(isTouching() || shown_.isKept())) {
        extent_.fit(framed(), headroom(), scale_.dent);
    }
    terrain_.setBottom(extent_.bottom(framed()));
    Q_EMIT terrainPlaced();
    if (otherColors) {
        Q_EMIT scalesChanged();
    }
    if (otherWindow) {
        Q_EMIT frameChanged();
    }
}

void ZoomPicture::fitHeights() {
    const std::array<double, 2> heights = shown_.heights(terrain_.heightRange());
    colors_.fitHeights(heights[0], heights[1]);
}

void ZoomPicture::keepScales() {
    shown_.keep();
    fitHeights();
    fitColors();
    extent_.fit(framed(), headroom(), scale_.dent);
    terrain_.setBottom(extent_.bottom(framed()));
    Q_EMIT terrainPlaced();
    Q_EMIT scalesChanged();
}

/// @return whether the colors are others
bool ZoomPicture::fitColors() {
    if (colors_.isLive()) {
        return false;
    }
    return colors_.needsEnds() ? colors_.fitRest(shown_.heights(terrain_.heightRange()))
                               : colors_.fitRest(terrain_.valuesOf(colors_.field()));
}

void ZoomPicture::setLook(const SurfaceLook& look, const SurfaceField& field) {
    colors_.setLook(look, field);
    showColors();
}

void ZoomPicture::setColors(const SurfaceColors& colors) {
    colors_ = colors;
    showColors();
}

void ZoomPicture::showColors() {
    if (frame_) {
        fitColors();
        Q_EMIT terrainPlaced();
    }
    Q_EMIT scalesChanged();
}

/// The heights are those of the colors, which seldom change, so that the picture seldom jumps.
FramedSurface ZoomPicture::framed() const {
    return {.heights = colors_.heightRange(),
            .halfWidth = frame_->halfWidth(),
            .heightScale = options_.heightScale};
}

GearScale ZoomPicture::gear() const {
    return {.halfWidth = frame_->halfWidth(),
            .tipRadius = scene_->belief.tipRadius(),
            .paraboloidReach = scale_.paraboloidReach,
            .heightScale = options_.heightScale};
}

/// Height that tip and arrow take above the surface, and of a tip that begins higher up, its lower
/// part, as drawn [m].
double ZoomPicture::headroom() const {
    const double gap = std::min(startGap_.value_or(0.0), kMaxStartGap * frame_->halfWidth());
    const double usual = gear().headroom();
    return std::max(usual, options_.heightScale * gap + kStartTip * usual);
}

void ZoomPicture::makeRoomForStart(const TipState& state) {
    if (startGap_) {
        return;
    }
    startGap_ = std::max(0.0, -state.contact.indentation);
    extent_.fit(framed(), headroom(), scale_.dent);
    Q_EMIT terrainPlaced();
}

/// Height above the tip's apex at which it leaves the picture at the top, as drawn [m]: without end
/// where it does not.
double ZoomPicture::roomAbove(const Vector3& apex, const ViewCamera& camera) const {
    constexpr int kSteps = 16;
    const TipOutline outline{scene_->description.tip.shape(), scale_.paraboloidReach};
    const double top = (1.0 - kTopMargin) * still_->GetSize()[1];
    const Vector3 level(camera.up().x(), camera.up().y(), 0.0);
    const Vector3 back = level.stableNormalized();
    const auto isSeen = [&](double height) {
        const double world = height / options_.heightScale;
        const Vector3 edge = apex + world * Vector3::UnitZ() + outline.radius(world) * back;
        return drawnPosition(edge).y() < top;
    };
    double low = 0.0;
    double high = kMaxTip * frame_->halfWidth();
    if (isSeen(high)) {
        return std::numeric_limits<double>::infinity();
    }
    for (int step = 0; step < kSteps; ++step) {
        const double middle = 0.5 * (low + high);
        (isSeen(middle) ? low : high) = middle;
    }
    return low;
}

bool ZoomPicture::isTouching() const {
    return shape_ != nullptr && shape_->contact().contactRadius > 0.0;
}

Shading ZoomPicture::shading(const ViewCamera& camera) const {
    return {camera, space(), options_.light};
}

void ZoomPicture::makeRoomFor(const ContactShape& shape, const ViewCamera& camera) {
    const bool isReleased = !isTouching() && !shown_.isKept() && extent_.release();
    if (extent_.makeRoomFor(shape.lowest(), framed()) || isReleased) {
        terrain_.setBottom(extent_.bottom(framed()));
        Q_EMIT terrainPlaced();
    }
    keepInPicture(shape.contactPoint(), camera);
}

/// The picture keeps its scale and, as long as the dent is in it, its position.
void ZoomPicture::keepInPicture(const Vector3& position, const ViewCamera& camera) {
    const int height = still_->GetSize()[1];
    const double missing = kDentMargin * height - drawnPosition(position).y();
    if (missing > 0.0 && camera.heightSeen() > 0.0) {
        extent_.lower(kLoweringStep * missing * metersPerPixel(height) / camera.heightSeen());
        Q_EMIT terrainPlaced();
    }
}

void ZoomPicture::showContact(const TickSample& sample, const ViewCamera& camera) {
    const TipState& model = sample.output.model;
    shape_ = std::make_unique<const ContactShape>(
        *scene_, options_.deformation ? model : atRest(model), terrain_.area().patch, kPatchSamples,
        options_.deformation ? halfSpace_.get() : nullptr);
    const ContactShape& shape = *shape_;
    const PatchColors colors(*scene_, shape, colors_);
    if (fitLiveColors(shape, colors)) {
        Q_EMIT scalesChanged();
    }
    makeRoomFor(shape, camera);
    const ScanWindow window = terrain_.area().window;
    const double width = std::max(window.right - window.left, window.top - window.bottom);
    const Shading shading = this->shading(camera);
    contact_.show(*scene_, shape,
                  {.colors = colors,
                   .space = space(),
                   .shading = shading,
                   .gridSpacing = options_.grid ? gridSpacing(width) : 0.0,
                   .gridArea = terrain_.area().patch,
                   .window = window,
                   .bottom = terrain_.bottom(),
                   .hasShadow = !colors_.isLive() && !this->gear().isCap(),
                   .isCut = options_.section});
    GearScale gear = this->gear();
    gear.room = roomAbove(apexOf(shape.contact()), camera);
    tip_.show(*scene_, shape, gear, {.right = camera.right(), .up = camera.up()}, space(), shading);
    showSection(shape, camera);
    guide_.show(sample.input.settings.guide, kGuideReach * frame_->halfWidth(), space());
    force_.show(sample.output.estimate, space().point(shape.contactPoint()), sample.time,
                scale_.force, kArrowRoom * gear.size());
}

/// @return whether the colors are others
bool ZoomPicture::fitLiveColors(const ContactShape& shape, const PatchColors& colors) {
    const bool otherDisplacements =
        colors_.fitDisplacement(shown_.displacement(shape.largestDisplacement()));
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

void ZoomPicture::showSection(const ContactShape& shape, const ViewCamera& camera) {
    if (!options_.section) {
        section_.hide();
        return;
    }
    cache_.invalidate();  // the terrain is cut where the tip is
    section_.show(*scene_, shape,
                  {.window = terrain_.area().window,
                   .bottom = terrain_.bottom(),
                   .tip = tip_.body(),
                   .opacity = tip_.opacity(),
                   .toEye = camera.out(),
                   .space = space(),
                   .shading = shading(camera)});
}

void ZoomPicture::showGhosts(const ViewCamera& camera) {
    if (!sample_ || !frame_) {
        ghosts_.hide();
        return;
    }
    const auto pose = [&](bool isOn, const std::optional<Vector3>& apex) {
        const double height =
            isOn && apex ? std::min(gear().tipHeight(), roomAbove(*apex, camera)) : 0.0;
        return height > 0.0 ? std::optional(TipGhosts::Pose{*apex, height}) : std::nullopt;
    };
    ghosts_.show(pose(options_.commandedTip, sample_->output.base.position),
                 pose(options_.trueTip, trueTip_),
                 {.radius = gear().tipRadius,
                  .shankHalfAngle = scene_->description.tip.shape().shankHalfAngle(),
                  .paraboloidReach = scale_.paraboloidReach,
                  .axes = {.right = camera.right(), .up = camera.up()},
                  .space = space()});
}

void ZoomPicture::setCrossHair(const std::optional<Vector2>& position, const QString& reading) {
    crossHair_ = position;
    reading_ = reading;
}

void ZoomPicture::showCrossHair() {
    if (!crossHair_ || !frame_) {
        cross_.hide();
        return;
    }
    cross_.show(scene_->surface, *crossHair_, terrain_.area().window, shape_.get(), space());
}

void ZoomPicture::showMarkers() {
    if (frame_) {
        markers_.show(scene_->description.markers, scene_->surface, terrain_.area().window,
                      space());
    } else {
        markers_.hide();
    }
}

void ZoomPicture::showTarget() {
    if (frame_ && targetPosition_ && holds(terrain_.area().window, targetPosition_->head<2>())) {
        target_.show(*targetPosition_, scene_->surface, kTargetArm * frame_->halfWidth(), space());
    } else {
        target_.hide();
    }
}

std::optional<Vector2> ZoomPicture::positionAt(const Vector2& pixel) const {
    return frame_ ? seenPosition(scene_->surface, rayThrough(*still_, pixel, space()),
                                 terrain_.area().window, shape_.get())
                  : std::nullopt;
}

SurfaceReading ZoomPicture::reading(const Vector2& position) const {
    return readingAt(*scene_, colors_.field(), shape_.get(), position);
}

void ZoomPicture::aim(const ViewCamera& camera, double aspect, const WordRoom& words) {
    cache_.invalidate();
    if (frame_) {
        camera.apply(still_->GetActiveCamera(), extent_.box(framed(), frame_->center()), aspect,
                     words);
    }
}

void ZoomPicture::setOptions(const ViewOptions& options) {
    options_ = options;
    cache_.invalidate();
    if (frame_) {
        extent_.forget();
        extent_.fit(framed(), headroom(), scale_.dent);
        terrain_.setBottom(extent_.bottom(framed()));
        Q_EMIT terrainPlaced();
    }
}

void ZoomPicture::setHalfWidth(double halfWidth) {
    extent_.forget();
    frame_->setHalfWidth(std::max(halfWidth, scale_.least));
    if (!sample_ && !sameWindow(frame_->window(), terrain_.area().window)) {
        placeTerrain({.window = frame_->window(), .hole = {}, .patch = {}});
    }
}

Vector2 ZoomPicture::drawnPosition(const Vector3& position) const {
    const Vector3 drawn = space().point(position);
    still_->SetWorldPoint(drawn.x(), drawn.y(), drawn.z(), 1.0);
    still_->WorldToDisplay();
    const double* display = still_->GetDisplayPoint();
    return {display[0], display[1]};
}

double ZoomPicture::metersPerPixel(double height) const {
    return 2.0 * still_->GetActiveCamera()->GetParallelScale() / height;
}

// What is written over the large view.

void ZoomPicture::showLabels(const ViewCamera& camera, double height, double pixelRatio) {
    if (!frame_) {
        labels_.hide();
        return;
    }
    labels_.setPixelRatio(pixelRatio);
    LabelContent content{.scaleBars = options_.scaleBars && !camera.hasPerspective(),
                         .metersPerPixel = metersPerPixel(height),
                         .heightPerPixel =
                             metersPerPixel(height) / (options_.heightScale * camera.heightSeen())};
    if (options_.labels) {
        content.notes = notes(camera);
        content.tipAbove = tipAbove(height, pixelRatio);
        content.force = writtenForce();
        content.forceEnd = force_.end();
        content.names = ghosts_.names();
        if (const auto target = target_.name()) {
            content.names.push_back(*target);
        }
        content.markers = markers_.names();
        content.reading = crossHair_ ? reading_.toStdString() : std::string();
        content.caption = caption_;
    }
    if (options_.axes) {
        content.axes = FrameAxes{.window = terrain_.area().window,
                                 .bottom = options_.heightScale * terrain_.bottom(),
                                 .toEye = camera.out()};
    }
    labels_.show(content);
}

std::string ZoomPicture::writtenForce() const {
    if (!writtenForce_.empty() || !sample_) {
        return writtenForce_;
    }
    return magnitudeText(sample_->output.estimate.force);
}

std::vector<std::string> ZoomPicture::notes(const ViewCamera& camera) const {
    return viewNotes({.heightScale = options_.heightScale,
                      .hasPerspective = camera.hasPerspective(),
                      .isFromBelow = camera.out().z() < 0.0,
                      .missesTrueTip = options_.trueTip && sample_ && !trueTip_,
                      .hidesDeformation = !options_.deformation,
                      .showsLever = gear().showsLever(),
                      .showsCap = gear().isCap(),
                      .tipRadius = scene_->belief.tipRadius(),
                      .pixel = scale_.pixel,
                      .width = 2.0 * frame_->halfWidth()});
}

std::string ZoomPicture::tipAbove(double height, double pixelRatio) const {
    if (shape_ == nullptr || drawnPosition(apexOf(shape_->contact())).y() < pixelRatio * height) {
        return {};
    }
    return tipAboveNote(-sample_->output.model.contact.indentation);
}

}  // namespace asperity
