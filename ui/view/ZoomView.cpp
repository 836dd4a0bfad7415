#include "ui/view/ZoomView.h"

#include "ui/widgets/Theme.h"

#include <vtkOpenGLRenderWindow.h>

#include <cmath>
#include <utility>

namespace asperity {

namespace {

constexpr double kZoomStep = 1.2;
constexpr double kTurnPerPixel = 0.006;  // [rad]

constexpr int kLetters = 100;  // any size: how much larger letters are than for 96 dots an inch

constexpr int kSettlingTime = 200;  // [ms]
constexpr int kFrameTime = 15;      // [ms]
constexpr int kReadingTime = 100;   // between two readings: faster than numbers are read [ms]
constexpr int kRunningTime = 100;   // after which snapshots come no more [ms]

}  // namespace

ZoomView::ZoomView(QWidget* parent) : GestureWidget(parent), picture_(&renderWindow()) {
    connect(&picture_, &ZoomPicture::terrainPlaced, this, &ZoomView::disturb);
    connect(&picture_, &ZoomPicture::frameChanged, this, &ZoomView::frameChanged);
    connect(&picture_, &ZoomPicture::scalesChanged, this, &ZoomView::scalesChanged);
    connectGestures();
    settling_.setSingleShot(true);
    settling_.setInterval(kSettlingTime);
    connect(&settling_, &QTimer::timeout, this, [this] {
        terrainDue_ = true;
        renderSoon();
    });
    frameDue_.setSingleShot(true);
    frameDue_.setInterval(kFrameTime);
    connect(&frameDue_, &QTimer::timeout, this, &ZoomView::renderNow);
    theme::follow(this, [this] {
        picture_.showTheme();
        terrainDue_ = true;
        renderSoon();
    });
}

ZoomView::~ZoomView() = default;

void ZoomView::connectGestures() {
    connect(this, &ZoomView::zoomed, this,
            [this](double steps) { setHalfWidth(halfWidth() * std::pow(kZoomStep, -steps)); });
    connect(this, &ZoomView::turned, this, [this](const QPointF& pixels) {
        camera_.turn(-kTurnPerPixel * pixels.x(), kTurnPerPixel * pixels.y());
        showTurned();
    });
    connect(this, &ZoomView::dragged, this, [this](const QPointF& pixels) {
        if (picture_.frame()) {
            const double scale = picture_.metersPerPixel(height());
            const Vector3 move = camera_.horizontalMove(scale * pixels.x(), -scale * pixels.y());
            Q_EMIT tipDragged(move.x(), move.y());
        }
    });
    connect(this, &ZoomView::hovered, this, [this](const QPointF& pixel) {
        if (const std::optional<Vector2> position = positionAt(pixel)) {
            Q_EMIT positionHovered(position->x(), position->y());
        } else {
            Q_EMIT pointerLeft();
        }
    });
    connect(this, &ZoomView::unhovered, this, &ZoomView::pointerLeft);
}

void ZoomView::setScene(const Scene* scene) {
    picture_.setScene(scene);
    picture_.showLabels(camera_, height(), drawnRatio());
    Q_EMIT scalesChanged();
    Q_EMIT frameChanged();
    frameDue_.start();
}

void ZoomView::showSnapshot(const Snapshot& snapshot) {
    if (picture_.frame()) {
        picture_.setSample(snapshot.sample, snapshot.trueTip);
        contactDue_ = true;
        sinceSnapshot_.start();
        if (picture_.crossHair() && sinceReading_.hasExpired(kReadingTime)) {
            read();
            Q_EMIT readingChanged();
        }
        renderNow();
    }
}

void ZoomView::setHalfSpace(std::shared_ptr<const HalfSpaceAnswer> answer) {
    picture_.setHalfSpace(std::move(answer));
}

std::optional<ScanWindow> ZoomView::window() const {
    return picture_.frame() ? std::optional(picture_.frame()->window()) : std::nullopt;
}

double ZoomView::halfWidth() const {
    return picture_.frame() ? picture_.frame()->halfWidth() : 0.0;
}

void ZoomView::setHalfWidth(double halfWidth) {
    if (picture_.frame()) {
        picture_.setHalfWidth(halfWidth);
        renderSoon();
    }
}

void ZoomView::resetCamera() {
    const bool perspective = camera_.hasPerspective();
    camera_.reset();
    camera_.setPerspective(perspective);
    disturb();
    setHalfWidth(picture_.scale().usual);
}

void ZoomView::lookFrom(ViewDirection side) {
    camera_.lookFrom(side);
    disturb();
    renderSoon();
}

void ZoomView::setDirection(double azimuth, double elevation) {
    camera_.setDirection(azimuth, elevation);
    disturb();
    renderSoon();
}

void ZoomView::setPerspective(bool perspective) {
    camera_.setPerspective(perspective);
    disturb();
    renderSoon();
}

void ZoomView::setOptions(const ViewOptions& options) {
    picture_.setOptions(options);
    renderSoon();
}

void ZoomView::setLook(const SurfaceLook& look, const SurfaceField& field) {
    picture_.setLook(look, field);
    renderSoon();
}

ColorScale ZoomView::colorScale() const {
    return picture_.frame() ? picture_.colors().scale() : ColorScale{};
}

ColorScale ZoomView::displacementScale() const {
    return picture_.frame() ? picture_.colors().displacementScale() : ColorScale{};
}

void ZoomView::showCrossHair(const std::optional<Vector2>& position) {
    picture_.setCrossHair(position, {});
    read();
    const bool framesCome = sinceSnapshot_.isValid() && !sinceSnapshot_.hasExpired(kRunningTime);
    if (!framesCome) {
        renderSoon();
    }
}

/// Shows the reading at the cross-hair in the next frame.
void ZoomView::read() {
    if (const std::optional<Vector2> at = picture_.crossHair(); at && picture_.frame()) {
        picture_.setCrossHair(at, textOf(picture_.reading(*at)));
        sinceReading_.start();
    }
}

std::optional<SurfaceReading> ZoomView::reading(const Vector2& position) const {
    return picture_.frame() ? std::optional(picture_.reading(position)) : std::nullopt;
}

std::optional<Vector2> ZoomView::positionAt(const QPointF& pixel) const {
    const double ratio = drawnRatio();
    return picture_.positionAt({ratio * pixel.x(), ratio * (height() - pixel.y())});
}

QPointF ZoomView::onScreen(const Vector3& position) const {
    const Vector2 drawn = picture_.drawnPosition(position);
    const double ratio = drawnRatio();
    return {drawn.x() / ratio, height() - drawn.y() / ratio};
}

void ZoomView::setCacheEnabled(bool enabled) {
    cacheEnabled_ = enabled;
    renderSoon();
}

void ZoomView::resizeEvent(QResizeEvent* event) {
    GestureWidget::resizeEvent(event);
    aim();
    renderSoon();
}

void ZoomView::showEvent(QShowEvent* event) {
    GestureWidget::showEvent(event);
    renderSoon();
}

void ZoomView::aim() {
    const double letters = theme::scaled(kLetters) / static_cast<double>(kLetters);
    picture_.aim(camera_, static_cast<double>(width()) / height(),
                 wordRoom(width() / letters, height() / letters));
}

/// Something of the still layer moves: for a while it is drawn coarsely.
void ZoomView::disturb() {
    settling_.start();
    terrainDue_ = true;
    aim();
}

void ZoomView::showTurned() {
    sinceTurn_.start();
    disturb();
    renderSoon();
}

bool ZoomView::isTurning() const {
    return settling_.isActive() && sinceTurn_.isValid() && !sinceTurn_.hasExpired(kSettlingTime);
}

bool ZoomView::isSettled() const {
    return !settling_.isActive() && !frameDue_.isActive() && !contactDue_ && !terrainDue_;
}

/// A frame within a few milliseconds, unless another one is drawn before.
void ZoomView::renderSoon() {
    contactDue_ = true;
    if (!frameDue_.isActive()) {
        frameDue_.start();
    }
}

void ZoomView::renderNow() {
    frameDue_.stop();
    setCoarse(isTurning());
    if (makeBuffers()) {
        QTimer::singleShot(0, this, &ZoomView::renderNow);
        return;
    }
    if (std::exchange(contactDue_, false)) {
        picture_.showSample(camera_, isDragging());
    }
    const bool isMoving = settling_.isActive();
    if (std::exchange(terrainDue_, false)) {
        picture_.showTerrain(camera_, isMoving ? TerrainDetail::Coarse : TerrainDetail::Fine);
    }
    picture_.cache().setEnabled(cacheEnabled_ && !isTurning());
    picture_.showLabels(camera_, height(), drawnRatio());
    if (drawFrame()) {
        Q_EMIT frameRendered();
    }
}

}  // namespace asperity
