#include "ui/view/ContactPlot.h"

#include "core/SiFormat.h"
#include "core/deformation/SurfaceField.h"
#include "core/scene/Scene.h"
#include "ui/view/ContactShape.h"
#include "ui/view/ViewFrame.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Ticks.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

// Pixels.
constexpr double kLeft = 58.0;
constexpr double kRight = 12.0;
constexpr double kTop = 26.0;
constexpr double kBottom = 38.0;
constexpr double kTick = 4.0;
constexpr double kArrowHead = 7.0;
constexpr int kTickRoom = 64;

constexpr double kTipHeight = 6.0;  // of the tip's outline, in half widths
constexpr double kWheelStep = 1.2;
constexpr double kNotch = 120.0;  // eighths of a degree
constexpr double kFill = 0.75;    // of the plot's height, by what fits
constexpr double kMaxFactor = 1000.0;
constexpr double kMarkReach = 7.0;   // of the contact's marks [px]
constexpr double kMaxBeside = 0.05;  // of the half width, by which a contact may miss the plane
constexpr double kMostBeside = 0.4;  // of the half width, of a contact from the middle
constexpr double kLabelGap = 8.0;    // between an arrow and its label [px]
constexpr double kFlattest = 0.8;    // of a plot that is as wide as the section: height over width

// Position of the surface at the contact, in parts of the plot's height from below.
constexpr double kUsualLevel = 0.4;
constexpr double kLowestLevel = 0.25;
constexpr double kHighestLevel = 0.6;
constexpr double kLowestContact = 0.08;  // same, of the contact in a deep dent

/// What the section shows of heights near the contact [m].
ValueRange heightsOf(const ContactSection& section) {
    ValueRange heights{section.contact.y(), section.contact.y()};
    for (const auto* line : {&section.rest, &section.deformed}) {
        for (const Vector2& point : *line) {
            heights.low = std::min(heights.low, point.y());
            heights.high = std::max(heights.high, point.y());
        }
    }
    return heights;
}

/// Height of the undeformed surface at a distance from the tip's axis, world z [m]; beyond the
/// scan's edge that of its nearest point.
double restHeight(const ContactSection& section, double along) {
    const auto isNearer = [along](const Vector2& one, const Vector2& other) {
        return std::abs(one.x() - along) < std::abs(other.x() - along);
    };
    const auto nearest = std::min_element(section.rest.begin(), section.rest.end(), isNearer);
    return nearest == section.rest.end() ? section.contact.y() : nearest->y();
}

/// Lowest point of the tip's outline, world z [m].
double apexHeight(const ContactSection& section) {
    const auto isLower = [](const Vector2& one, const Vector2& other) {
        return one.y() < other.y();
    };
    return std::min_element(section.tip.begin(), section.tip.end(), isLower)->y();
}

QString angleText(double azimuth) {
    return QStringLiteral("%1°").arg(azimuth * 180.0 / std::numbers::pi, 0, 'g', 3);
}

}  // namespace

ContactPlot::ContactPlot(QWidget* parent) : QWidget(parent) {
    setMouseTracking(true);
    setMinimumSize(200, 120);
    setToolTip(tr("Section through the tip: undeformed (dashed) and deformed surface, outline of "
                  "the tip, ends of the contact, force of the sample on the tip in this plane.\n"
                  "Ctrl + wheel: zoom"));
}

void ContactPlot::setScene(const Scene* scene) {
    scene_ = scene;
    halfSpace_.reset();
    section_.reset();
    sample_.reset();
    crossHair_.reset();
    writtenForce_.clear();
    evidence_.forget();
    middleHeight_.reset();
    chosenHalfWidth_.reset();
    if (scene_ != nullptr) {
        chooseScale();
    }
    update();
}

void ContactPlot::chooseScale() {
    const ViewScale scale = viewScale(*scene_);
    paraboloidReach_ = scale.paraboloidReach;
    forceScale_ = scale.force;
    halfWidth_ = chosenHalfWidth_.value_or(scale.section);
    leastHalfWidth_ = scale.leastSection;
    scaledFor_ = scene_->description.setpoint;
    middleHeight_.reset();
}

/// Turns the plane through the contact where it lies so far beside the plane that the tip in it
/// would be seen to hover.
void ContactPlot::turnToContact(const TipState& state) {
    const Vector2 offset = (state.closest.point - state.tip).head<2>();
    const Vector2 normal(-std::sin(plane_.azimuth), std::cos(plane_.azimuth));
    if (std::abs(normal.dot(offset)) > kMaxBeside * halfWidth_) {
        const double azimuth = std::atan2(offset.y(), offset.x());
        constexpr double kHalfTurn = std::numbers::pi;
        plane_.azimuth = azimuth > kHalfTurn / 2.0     ? azimuth - kHalfTurn
                         : azimuth <= -kHalfTurn / 2.0 ? azimuth + kHalfTurn
                                                       : azimuth;
    }
}

/// Moves what is seen as far from the tip's axis as the contact of a large tip on a slope needs.
void ContactPlot::follow(const TipState& state) {
    const Vector2 direction(std::cos(plane_.azimuth), std::sin(plane_.azimuth));
    const double along = (state.closest.point - state.tip).head<2>().dot(direction);
    const double room = kMostBeside * plane_.halfWidth;
    plane_.middle = std::clamp(0.0, along - room, along + room);
}

void ContactPlot::setHalfSpace(std::shared_ptr<const HalfSpaceAnswer> answer) {
    halfSpace_ = std::move(answer);
}

void ContactPlot::showSnapshot(const Snapshot& snapshot) {
    if (scene_ == nullptr) {
        return;
    }
    sample_ = snapshot.sample;
    if (scaledFor_ != scene_->description.setpoint) {
        chooseScale();
    }
    isForceKnown_ = evidence_.take(sample_->output.estimate, sample_->time);
    cut();
}

/// Rebuilds the section of the sample.
void ContactPlot::cut() {
    section_.reset();
    plane_.halfWidth = seenHalfWidth();
    if (sample_) {
        if (turns_ && isDrawable(sample_->output.model)) {
            turnToContact(sample_->output.model);
        }
        follow(sample_->output.model);
        section_ = sectionOf(*scene_, sample_->output.model);
    }
    if (section_) {
        fitScale();
    }
    update();
}

std::optional<ContactSection> ContactPlot::sectionOf(const Scene& scene,
                                                     const TipState& state) const {
    if (!isDrawable(state)) {
        return std::nullopt;
    }
    SectionPlane plane = plane_;
    plane.paraboloidReach = paraboloidReach_;
    if (scene_ != &scene) {  // while it is hidden it has none
        const ViewScale scale = viewScale(scene);
        plane.paraboloidReach = scale.paraboloidReach;
        plane.halfWidth = scale.section;
    }
    plane.tipHeight = kTipHeight * plane.halfWidth;
    const HalfSpaceAnswer* const answer = scene_ == &scene ? halfSpace_.get() : nullptr;
    return contactSection(scene, ContactDeformation(scene, state, scene.model.deformation, answer),
                          plane);
}

void ContactPlot::setAzimuth(std::optional<double> azimuth) {
    turns_ = !azimuth;
    plane_.azimuth = azimuth.value_or(plane_.azimuth);
    cut();
}

void ContactPlot::setHeightFactor(double factor) {
    heightFactor_ = factor;
    middleHeight_.reset();
    if (section_) {
        fitScale();
    }
    update();
}

void ContactPlot::setHalfWidth(double halfWidth) {
    if (scene_ != nullptr) {
        const double largest = 0.5 * std::max(scene_->surface.sizeX(), scene_->surface.sizeY());
        halfWidth_ = std::clamp(halfWidth, leastHalfWidth_, largest);
        chosenHalfWidth_ = halfWidth_;
        middleHeight_.reset();
        cut();
    }
}

QRectF ContactPlot::area() const { return QRectF(rect()).adjusted(kLeft, kTop, -kRight, -kBottom); }

/// More of the section in a plot that is wide and low: the tip above it would not be seen else.
double ContactPlot::seenHalfWidth() const {
    const QRectF inside = area();
    return halfWidth_ * std::max(1.0, kFlattest * inside.width() / std::max(inside.height(), 1.0));
}

/// Heights fill the plot where they shall.
void ContactPlot::fitScale() {
    const QRectF inside = area();
    metersPerPixel_ = 2.0 * plane_.halfWidth / std::max(inside.width(), 1.0);
    drawnFactor_ = heightFactor_;
    if (heightFactor_ <= 0.0) {
        const ValueRange heights = heightsOf(*section_);
        const double extent = std::max(heights.high - heights.low, 1e-12);
        const double fits = kFill * inside.height() * metersPerPixel_ / extent;
        drawnFactor_ = fits > 1.0 ? std::min(niceBelow(fits), kMaxFactor) : 1.0;
    }
    followSurface();
}

/// Keeps the surface at the contact between two levels, and a deep contact in sight. Where the tip
/// is does not matter else: its way up or down is seen.
void ContactPlot::followSurface() {
    const double seen = area().height() * metersPerPixel_ / drawnFactor_;
    const auto middleFor = [seen](double height, double share) {
        return height + (0.5 - share) * seen;
    };
    const double level = restHeight(*section_, section_->contact.x());
    const double middle =
        std::clamp(middleHeight_.value_or(middleFor(level, kUsualLevel)),
                   middleFor(level, kHighestLevel), middleFor(level, kLowestLevel));
    middleHeight_ = std::min(middle, middleFor(section_->contact.y(), kLowestContact));
}

QPointF ContactPlot::toPixel(const Vector2& point) const {
    const QRectF inside = area();
    return {inside.center().x() + (point.x() - plane_.middle) / metersPerPixel_,
            inside.center().y() -
                (point.y() - middleHeight_.value_or(0.0)) * drawnFactor_ / metersPerPixel_};
}

QPolygonF ContactPlot::drawn(const std::vector<Vector2>& points) const {
    QPolygonF polygon;
    for (const Vector2& point : points) {
        polygon << toPixel(point);
    }
    return polygon;
}

void ContactPlot::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.fillRect(rect(), theme::colors().paper);
    painter.setFont(theme::textFont(theme::kSmallSize));
    if (!section_) {
        painter.setPen(theme::colors().muted);
        painter.drawText(rect(), Qt::AlignCenter, tr("No tip to cut through"));
        return;
    }
    painter.setRenderHint(QPainter::Antialiasing);
    painter.save();
    painter.setClipRect(area());
    drawBodies(painter);
    drawContact(painter);
    drawForce(painter);
    drawTipAbove(painter);
    painter.restore();
    drawAxes(painter);
    drawLegend(painter);
    drawCrossHair(painter);
}

void ContactPlot::drawBodies(QPainter& painter) const {
    const QRectF inside = area();
    QPolygonF sample = drawn(section_->deformed);
    if (!sample.isEmpty()) {
        const QPointF first = sample.front();
        const QPointF last = sample.back();
        QPolygonF block = sample;
        block << QPointF(last.x(), inside.bottom() + 2.0)
              << QPointF(first.x(), inside.bottom() + 2.0);
        painter.setPen(Qt::NoPen);
        painter.setBrush(theme::colors().faint);
        painter.drawPolygon(block);
    }
    const QPolygonF tip = drawn(section_->tip);
    QColor body(theme::colors().tip);
    body.setAlphaF(0.35);
    painter.setPen(Qt::NoPen);
    painter.setBrush(body);
    painter.drawPolygon(tip);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(theme::colors().muted, 1.2, Qt::DashLine));
    painter.drawPolyline(drawn(section_->rest));
    painter.setPen(QPen(theme::colors().ink, 2.0));
    painter.drawPolyline(sample);
    painter.setPen(QPen(theme::colors().tip, 2.0));
    painter.drawPolyline(tip);
}

/// The ends of the contact, and its axis.
void ContactPlot::drawContact(QPainter& painter) const {
    if (!section_->rim) {
        return;
    }
    painter.setPen(QPen(theme::colors().accent, 2.0));
    for (const Vector2& end : *section_->rim) {
        const QPointF at = toPixel(end);
        painter.drawLine(at - QPointF(0.0, kMarkReach), at + QPointF(0.0, kMarkReach));
    }
}

/// As long as in the large view, in parts of the plot's height; its tail is at the contact.
void ContactPlot::drawForce(QPainter& painter) const {
    const ForceEstimate& estimate = sample_->output.estimate;
    const Vector3 force = estimate.force;
    const Vector2 inPlane(force.head<2>().dot(section_->direction), force.z());
    const double size = inPlane.norm();
    if (!isForceKnown_ || !(size > 0.0) || !std::isfinite(size)) {
        return;
    }
    const double length = arrowLength(size, forceScale_, 0.45 * area().height());
    if (length < kArrowHead) {
        return;
    }
    const QPointF from = toPixel(section_->contact);
    const QPointF way(inPlane.x() / size, -inPlane.y() / size);
    const QPointF to = from + length * way;
    const QPointF across(-way.y(), way.x());
    painter.setPen(QPen(theme::colors().force, 2.5));
    painter.drawLine(from, to - kArrowHead * way);
    painter.setBrush(theme::colors().force);
    painter.setPen(Qt::NoPen);
    painter.drawPolygon(QPolygonF({to, to - 1.6 * kArrowHead * way + 0.6 * kArrowHead * across,
                                   to - 1.6 * kArrowHead * way - 0.6 * kArrowHead * across}));
    painter.setPen(theme::colors().force);
    painter.setFont(theme::boldFont(theme::kTextSize));
    // The number of the large view and of the panel, however much of it lies in the plane.
    const std::string written = writtenForce_.empty() ? magnitudeText(force) : writtenForce_;
    const QString text = QStringLiteral("|F| ") + QString::fromStdString(written);
    const double rightmost = area().right() - painter.fontMetrics().horizontalAdvance(text);
    painter.drawText(
        QPointF(std::clamp(to.x() + kLabelGap, area().left(), std::max(rightmost, area().left())),
                std::max(to.y() + 4.0, area().top() + theme::kTextSize + 2.0)),
        text);
}

/// Says where a tip is that is not in sight.
void ContactPlot::drawTipAbove(QPainter& painter) const {
    const QRectF inside = area();
    if (section_->tip.empty() || toPixel({0.0, apexHeight(*section_)}).y() > inside.top()) {
        return;
    }
    const double above = apexHeight(*section_) - restHeight(*section_, 0.0);
    painter.setPen(theme::colors().tip);
    painter.setFont(theme::boldFont(theme::kTextSize));
    painter.drawText(inside.adjusted(0.0, 6.0, 0.0, 0.0), Qt::AlignHCenter | Qt::AlignTop,
                     tr("▲ tip %1 above").arg(siText(above, "m")));
}

void ContactPlot::drawAxes(QPainter& painter) const {
    const QRectF inside = area();
    painter.setFont(theme::textFont(theme::kSmallSize));
    painter.setPen(theme::colors().muted);
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(inside);
    const double halfHeight = 0.5 * inside.height() * metersPerPixel_ / drawnFactor_;
    const double middle = middleHeight_.value_or(0.0);
    const SiScale along = siScaleFor(plane_.halfWidth, "m");
    const SiScale up =
        siScaleFor(std::max(std::abs(middle - halfHeight), std::abs(middle + halfHeight)), "m");
    const auto shown = [](std::vector<double> ticks, double factor) {
        for (double& tick : ticks) {
            tick *= factor;
        }
        return tickLabels(ticks);
    };
    const std::vector<double> x =
        niceTicks(plane_.middle - plane_.halfWidth, plane_.middle + plane_.halfWidth,
                  std::max(2, static_cast<int>(inside.width()) / kTickRoom));
    const std::vector<std::string> xLabels = shown(x, along.factor);
    for (std::size_t i = 0; i < x.size(); ++i) {
        const double at = toPixel({x[i], 0.0}).x();
        painter.drawLine(QPointF(at, inside.bottom()), QPointF(at, inside.bottom() + kTick));
        painter.drawText(QRectF(at - kTickRoom, inside.bottom() + kTick, 2.0 * kTickRoom, 15.0),
                         Qt::AlignHCenter, QString::fromStdString(xLabels[i]));
    }
    const std::vector<double> z =
        niceTicks(middle - halfHeight, middle + halfHeight,
                  std::max(2, static_cast<int>(2.0 * inside.height()) / kTickRoom));
    const std::vector<std::string> zLabels = shown(z, up.factor);
    for (std::size_t i = 0; i < z.size(); ++i) {
        const double at = toPixel({0.0, z[i]}).y();
        painter.drawLine(QPointF(inside.left() - kTick, at), QPointF(inside.left(), at));
        painter.drawText(QRectF(0.0, at - 8.0, inside.left() - kTick - 2.0, 16.0),
                         Qt::AlignRight | Qt::AlignVCenter, QString::fromStdString(zLabels[i]));
    }
    const QString unit = QString::fromStdString(along.unit);
    const QString caption = tr("along the plane, from the tip's axis [%1]").arg(unit);
    const bool fits = painter.fontMetrics().horizontalAdvance(caption) < inside.width();
    painter.drawText(QRectF(inside.left(), height() - 17.0, inside.width(), 16.0), Qt::AlignHCenter,
                     fits ? caption : tr("from the axis [%1]").arg(unit));
    painter.drawText(QRectF(2.0, 4.0, kLeft + 60.0, 16.0), Qt::AlignLeft,
                     tr("z [%1]").arg(QString::fromStdString(up.unit)));
}

void ContactPlot::drawLegend(QPainter& painter) const {
    const TipContact& contact = tipContact(*scene_, sample_->output.model);
    QStringList parts{drawnFactor_ == 1.0 ? tr("true to scale")
                                          : tr("heights ×%1").arg(drawnFactor_),
                      contact.contactRadius > 0.0
                          ? tr("contact radius %1").arg(siText(contact.contactRadius, "m"))
                          : tr("no contact"),
                      tr("direction %1").arg(angleText(plane_.azimuth))};
    painter.setFont(theme::textFont(theme::kSmallSize));
    painter.setPen(theme::colors().ink);
    const QRectF line(kLeft, 4.0, width() - kLeft - kRight, 16.0);
    const auto text = [&parts] { return parts.join(QStringLiteral("   ·   ")); };
    while (parts.size() > 1 && painter.fontMetrics().horizontalAdvance(text()) > line.width()) {
        parts.removeLast();  // the panel and the box above say it, too
    }
    painter.drawText(line, Qt::AlignRight, text());
}

void ContactPlot::drawCrossHair(QPainter& painter) const {
    if (!crossHair_) {
        return;
    }
    const QRectF inside = area();
    const double along = (*crossHair_ - section_->axis).dot(section_->direction);
    const double at = toPixel({along, 0.0}).x();
    if (at < inside.left() || at > inside.right()) {
        return;
    }
    painter.setPen(QPen(theme::colors().marker, 1.0));
    painter.drawLine(QPointF(at, inside.top()), QPointF(at, inside.bottom()));
    if (!reading_) {
        return;
    }
    const double level = toPixel({along, reading_->position.z()}).y();
    const double off = std::abs((*crossHair_ - section_->positionAt(along)).norm());
    if (off < metersPerPixel_ && level > inside.top() && level < inside.bottom()) {
        painter.drawLine(QPointF(inside.left(), level), QPointF(inside.right(), level));
    }
    painter.setFont(theme::textFont(theme::kSmallSize));
    const QString text = textOf(*reading_);
    QRectF plate = QRectF(painter.fontMetrics().boundingRect(text)).adjusted(-4.0, -2.0, 4.0, 2.0);
    plate.moveBottomRight(inside.bottomRight() - QPointF(4.0, 4.0));
    QColor paper(theme::colors().paper);
    paper.setAlphaF(0.88);
    painter.fillRect(plate, paper);
    painter.setPen(theme::colors().ink);
    painter.drawText(plate, Qt::AlignCenter, text);
}

void ContactPlot::showCrossHair(const std::optional<Vector2>& position,
                                const std::optional<SurfaceReading>& reading) {
    crossHair_ = position;
    reading_ = reading;
    update();
}

void ContactPlot::mouseMoveEvent(QMouseEvent* event) {
    const QRectF inside = area();
    if (!section_ || !inside.contains(event->localPos())) {
        Q_EMIT pointerLeft();
        return;
    }
    const double along =
        plane_.middle + (event->localPos().x() - inside.center().x()) * metersPerPixel_;
    const Vector2 position = section_->positionAt(along);
    if (scene_->surface.contains(position.x(), position.y())) {
        Q_EMIT positionHovered(position.x(), position.y());
    } else {
        Q_EMIT pointerLeft();
    }
}

void ContactPlot::leaveEvent(QEvent* event) {
    Q_EMIT pointerLeft();
    QWidget::leaveEvent(event);
}

void ContactPlot::wheelEvent(QWheelEvent* event) {
    if (event->modifiers().testFlag(Qt::ControlModifier)) {
        setHalfWidth(halfWidth_ * std::pow(kWheelStep, -event->angleDelta().y() / kNotch));
        event->accept();
    } else {
        event->ignore();
    }
}

}  // namespace asperity
