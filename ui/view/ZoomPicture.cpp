#include "ui/view/ZoomPicture.h"

#include "ui/view/DrapedGrid.h"
#include "vtkplugins/pictures/SceneParts.h"

#include <vtkCamera.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkRenderer.h>

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
constexpr double kGuideReach = 0.4;
constexpr double kOverlap = 0.015;  // of patch and terrain

// In sizes of tip and arrow.
constexpr double kTipTop = 1.15;
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
    , force_(through_)
    , guide_(through_)
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
    still_->SetBackground(palette::kPaper.fractions().data());
    live_->PreserveDepthBufferOn();
}

ZoomPicture::~ZoomPicture() = default;

void ZoomPicture::setScene(const Scene* scene) {
    scene_ = scene;
    sample_.reset();
    halfSpace_.reset();
    frame_.reset();
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
        contact_.hide();
        tip_.hide();
        force_.hide();
        guide_.hide();
    }
}

void ZoomPicture::showTerrain(const ViewCamera& camera, TerrainDetail detail) {
    if (frame_) {
        terrain_.show(detail, colors_, Shading(camera));
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
    const bool otherColors = colors_.fitHeights(heights[0], heights[1]);
    const FrameBox box = frameBox();
    terrain_.setBottom(box.middle.z() - box.below);
    Q_EMIT terrainPlaced();
    if (otherColors) {
        Q_EMIT scalesChanged();
    }
    if (otherWindow) {
        Q_EMIT frameChanged();
    }
}

/// Heights are those of the colors: they seldom change, so that the picture seldom jumps.
FrameBox ZoomPicture::frameBox() const {
    const Vector2& center = frame_->center();
    const AxisRange& heights = colors_.heightRange();
    const double middle = 0.5 * (heights.low + heights.high);
    return {.middle = {center.x(), center.y(), middle},
            .halfWidth = frame_->halfWidth(),
            .below = middle - heights.low + kBlockDepth * frame_->halfWidth(),
            .above = heights.high - middle,
            .tipTop = heights.high - middle +
                      kTipTop * gearSize(frame_->halfWidth(), scene_->belief.tipRadius())};
}

void ZoomPicture::showContact(const TickSample& sample, const ViewCamera& camera) {
    const TipState& state = sample.output.model;
    const ContactShape shape(*scene_, state, terrain_.place().patch, kPatchSamples,
                             halfSpace_.get());
    const double largest = shape.largestDisplacement();
    if (colors_.fitDisplacement(largest)) {
        Q_EMIT scalesChanged();
    }
    const double factor =
        magnification_.fit(largest, -state.contact.indentation, shape.contact().tipRadius);
    const double gear = gearSize(frame_->halfWidth(), shape.contact().tipRadius);
    const ScanWindow window = terrain_.place().window;
    const double width = std::max(window.right - window.left, window.top - window.bottom);
    const Shading shading(camera);
    contact_.show(*scene_, shape,
                  {.colors = colors_,
                   .shading = shading,
                   .magnification = factor,
                   .gridSpacing = gridSpacing(width),
                   .gridArea = terrain_.place().patch,
                   .window = window,
                   .bottom = terrain_.bottom()});
    tip_.show(shape, factor, {.top = kTipTop * gear, .toEye = camera.out(), .shading = shading});
    guide_.show(sample.input.settings.guide, kGuideReach * frame_->halfWidth());
    force_.show(sample.output.estimate, drawnAt(shape, shape.contact().closest, factor),
                sample.time, kArrowRoom * gear);
}

void ZoomPicture::showLabels(int height, double pixelRatio) {
    if (!frame_) {
        labels_.hide();
        return;
    }
    labels_.setPixelRatio(pixelRatio);
    labels_.show({.metersPerPixel = metersPerPixel(height),
                  .magnification = sample_ ? magnification_.factor() : 1.0,
                  .force = sample_ ? sample_->output.estimate.force.stableNorm() : 0.0,
                  .forceEnd = force_.end()});
}

void ZoomPicture::aim(const ViewCamera& camera, double aspect) {
    cache_.invalidate();
    if (frame_) {
        camera.apply(still_->GetActiveCamera(), frameBox(), aspect);
    }
}

void ZoomPicture::setHalfWidth(double halfWidth) {
    frame_->setHalfWidth(std::max(halfWidth, scale_.least));
    if (!sample_ && !sameWindow(frame_->window(), terrain_.place().window)) {
        placeTerrain({.window = frame_->window(), .hole = {}, .patch = {}});
    }
}

Vector2 ZoomPicture::drawnPlace(const Vector3& place) const {
    still_->SetWorldPoint(place.x(), place.y(), place.z(), 1.0);
    still_->WorldToDisplay();
    const double* display = still_->GetDisplayPoint();
    return {display[0], display[1]};
}

double ZoomPicture::metersPerPixel(int height) const {
    return 2.0 * still_->GetActiveCamera()->GetParallelScale() / height;
}

}  // namespace asperity
