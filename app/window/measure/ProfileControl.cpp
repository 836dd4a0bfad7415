#include "app/window/measure/ProfileControl.h"

#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/measure/RoughnessControl.h"
#include "core/SiFormat.h"
#include "core/surface/measure/Profile.h"
#include "ui/shell/Menus.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

constexpr double kEndReach = 8.0;       ///< of the pointer to an end [px]
constexpr double kNear = 5.0;           ///< of the pointer to the line [px]
constexpr double kEndRadius = 4.0;      ///< radius of an end [px]
constexpr double kStop = 5.0;           ///< half a cursor's bar [px]
constexpr double kToolLineWidth = 1.8;  ///< [px]

/// Distance of a point to a line's stretch [px].
double distanceTo(const QLineF& line, const QPointF& point) {
    const QPointF along = line.p2() - line.p1();
    const double square = QPointF::dotProduct(along, along);
    const double share =
        square > 0.0 ? std::clamp(QPointF::dotProduct(point - line.p1(), along) / square, 0.0, 1.0)
                     : 0.0;
    return QLineF(line.pointAt(share), point).length();
}

constexpr int kMinSamples = 65;  ///< of a short line: the surface is smooth between its pixels

Vector2 vectorOf(const QPointF& position) { return {position.x(), position.y()}; }

/// Mean height of positions beside one another [m]; NaN: none of them holds data.
double meanHeight(const BSplineSurface& surface, const Vector2& middle, const Vector2& step,
                  int width) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < width; ++i) {
        const Vector2 at = middle + (i - 0.5 * (width - 1)) * step;
        if (surface.contains(at.x(), at.y()) && surface.isMeasured(at.x(), at.y())) {
            sum += surface.at(at.x(), at.y()).height;
            ++count;
        }
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

constexpr int kMaxWidth = 31;  ///< lines side by side

/// To four digits: a difference must show what the cursors do.
QString profileLengthText(double meters) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-12), "m");
    return QStringLiteral("%1 %2")
        .arg(scale.factor * meters, 0, 'g', 4)
        .arg(QString::fromStdString(scale.unit));
}

QString angleText(double radians) {
    const double hundredths = std::round(radians * 18000.0 / std::numbers::pi);
    return QStringLiteral("%1°").arg(0.01 * (hundredths + 0.0), 0, 'f', 2);  // never "-0.00"
}

/// Both in the prefix of the larger one; below a hundredth a deviation is not told from none.
QString withDeviation(const StepHeight& step, double zCalibration) {
    constexpr double kLastDigit = 0.01;
    const double all = std::hypot(step.deviation, zCalibration * step.height);
    const SiScale scale = siScaleFor(std::max({std::abs(step.height), all, 1e-12}), "m");
    const double deviation = scale.factor * all;
    const QString shown = deviation > 0.0 && deviation < kLastDigit
                              ? QStringLiteral("< %1").arg(kLastDigit)
                              : QString::number(deviation, 'g', 2);
    return QStringLiteral("%1 ± %2 %3")
        .arg(scale.factor * step.height, 0, 'g', 4)
        .arg(shown, QString::fromStdString(scale.unit));
}

Interval intervalOf(const PlotStretch& stretch) { return {stretch.from, stretch.to}; }

}  // namespace

void LineTool::setStops(const QVector<double>& shares) {
    stops_ = shares;
    Q_EMIT marksChanged();
}

void LineTool::paint(QPainter& painter, const OverviewMap& map) const {
    if (isEmpty()) {
        return;
    }
    const QLineF drawn = pixels(map);
    QPainterPath path;
    path.moveTo(drawn.p1());
    path.lineTo(drawn.p2());
    if (drawn.length() > 0.0) {
        const QPointF across = drawn.normalVector().unitVector().p2() - drawn.p1();
        for (const double share : stops_) {
            path.moveTo(drawn.pointAt(share) - kStop * across);
            path.lineTo(drawn.pointAt(share) + kStop * across);
        }
    }
    strokeOverWhite(painter, kLightPalette.blue, kToolLineWidth, path);
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(kLightPalette.blue));
    painter.drawEllipse(drawn.p1(), kEndRadius, kEndRadius);  // where the profile begins: filled
    painter.setPen(QPen(toQColor(kLightPalette.blue), kToolLineWidth));
    painter.setBrush(toQColor(kLightPalette.paper));
    painter.drawEllipse(drawn.p2(), kEndRadius, kEndRadius);
}

bool LineTool::isEmptyShape(const QLineF& points) const { return !(points.length() > 0.0); }

LineTool::Grip LineTool::gripAt(const QPointF& pixel, const OverviewMap& map) const {
    const QLineF drawn = pixels(map);
    const double toFirst = QLineF(drawn.p1(), pixel).length();
    const double toSecond = QLineF(drawn.p2(), pixel).length();
    if (std::min(toFirst, toSecond) <= kEndReach) {
        return toFirst < toSecond ? Grip{-1, -1} : Grip{1, 1};
    }
    return distanceTo(drawn, pixel) <= kNear ? kWhole : kNewShape;
}

/// Beside or above the other end, whichever is nearer.
QPointF LineTool::held(const QPointF& moving, const QPointF& fixed) const {
    const QPointF way = moving - fixed;
    return std::abs(way.x()) >= std::abs(way.y()) ? QPointF(moving.x(), fixed.y())
                                                  : QPointF(fixed.x(), moving.y());
}

Qt::CursorShape LineTool::handleCursor(const Grip& /*grip*/) const {
    return Qt::PointingHandCursor;
}

QString LineTool::hint() const {
    return tr("Drag: profile line, or one of its ends (Shift: horizontal or vertical)");
}

Profile meanProfile(const BSplineSurface& surface, const QLineF& line, int width) {
    const Vector2 from = vectorOf(line.p1());
    const Vector2 to = vectorOf(line.p2());
    const double pitchX = surface.grid().pitchX;
    const double pitchY = surface.grid().pitchY;
    const int samples = std::max(kMinSamples, usualSamples(pitchX, pitchY, from, to));
    if (width <= 1) {
        return profileOf(surface, from, to, samples);
    }
    const Vector2 along = (to - from).normalized();
    const Vector2 step = std::min(pitchX, pitchY) * Vector2(-along.y(), along.x());
    return profileOf(
        [&](double x, double y) {
            return meanHeight(surface, {x, y}, step, width);
        },
        from, to, samples);
}

ProfileControl::ProfileControl(Stage& stage)
    : Feature(stage), page_(new ProfilePage(&host_.widget())) {
    const QAction& entry = addScanTool(
        page_, tr("Profile"), 10, "profile",
        {.text = tr("&Profile line"),
         .tip = tr("Draw a line on the whole scan: heights, distance, angle, step height"),
         .shortcuts = {tr("Ctrl+L")}});
    connect(&entry, &QAction::triggered, this, [this] { page_->setDrawing(true); });
    bindTool(live_.overview().map(), line_, *page_, &ProfilePage::drawingChosen,
             &ProfilePage::setDrawing);
    for (const auto shown :
         {&RunControl::begun, &RunControl::recordingShown, &RunControl::liveShown}) {
        connect(&runs_, shown, this, [this] { runs_.isOnOtherScan() ? forget() : refresh(); });
    }
    runs_.beforeRecording([this]() -> std::function<void()> {
        return [this, line = line_.line()] {
            line_.setLine(line);
            refresh();
        };
    });
    connect(&line_, &LineTool::drawn, this, &ProfileControl::refresh);
    connect(page_, &ProfilePage::widthChosen, this, &ProfileControl::refresh);
    connect(page_, &ProfilePage::removeChosen, this, &ProfileControl::forget);
    connect(page_, &ProfilePage::stopsChanged, &line_, [this] { line_.setStops(page_->stops()); });
}

void ProfileControl::forget() {
    line_.clear();
    refresh();
}

/// Some milliseconds at most: a line has a few thousand samples.
void ProfileControl::refresh() {
    if (line_.isEmpty() || runs_.run() == nullptr) {
        page_->setProfile(std::nullopt);
        return;
    }
    const Scene& scene = runs_.scene();
    const Uncertainty& given = scene.description.uncertainty;
    page_->setProfile(meanProfile(scene.surface, line_.line(), page_->width()),
                      given.enabled ? given.heightCalibration : 0.0,
                      smoothingInWords(scene.description.sample));
}

ProfilePage::ProfilePage(QWidget* parent)
    : QWidget(parent)
    , plot_(new ProfilePlot(this))
    , readings_(new ReadingGrid(this))
    , draw_(pageButton(tr("Draw line"), "drawProfile",
                       tr("A drag on the whole scan draws the line, or moves it or its ends; off, "
                          "or Esc: a double click travels again"),
                       this))
    , remove_(pageButton(tr("Remove"), "removeProfile", tr("Removes the line"), this))
    , width_(new QSpinBox(this))
    , step_(new QCheckBox(tr("Step height"), this))
    , hint_(captionLabel(QString(), this)) {
    setToolTip(tr("Heights along a line, distance, angle and step height"));
    draw_->setCheckable(true);
    buildReadings();
    auto* middle = new QHBoxLayout;
    middle->setSpacing(10);
    middle->addWidget(plot_, 1);
    middle->addWidget(readings_);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    column->addWidget(buildBar());
    column->addLayout(middle, 1);
    connect(draw_, &QToolButton::toggled, this, &ProfilePage::drawingChosen);
    connect(remove_, &QToolButton::clicked, this, &ProfilePage::removeChosen);
    connect(width_, qOverload<int>(&QSpinBox::valueChanged), this, &ProfilePage::widthChosen);
    connect(step_, &QCheckBox::toggled, this, &ProfilePage::show);
    connect(plot_, &ProfilePlot::cursorDragged, this, &ProfilePage::moveCursor);
    connect(plot_, &ProfilePlot::stretchDragged, this, &ProfilePage::moveStretch);
    show();
}

QWidget* ProfilePage::buildBar() {
    width_->setObjectName(QStringLiteral("profileWidth"));
    width_->setRange(1, kMaxWidth);
    width_->setSuffix(tr(" px wide"));
    width_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    width_->setToolTip(tr("Each height is the mean over this many lines side by side, a pixel "
                          "apart"));
    step_->setObjectName(QStringLiteral("stepHeight"));
    step_->setToolTip(tr("Marks two stretches: how far the mean height of one is above that of the "
                         "other"));
    hint_->setObjectName(QStringLiteral("profileState"));
    hint_->setToolTip(tr("Smoothing of the heights: the profile is of the surface that the tip "
                         "touches"));
    step_->setFocusPolicy(Qt::TabFocus);
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QWidget* const control : {static_cast<QWidget*>(draw_), static_cast<QWidget*>(remove_),
                                   static_cast<QWidget*>(width_), static_cast<QWidget*>(step_)}) {
        row->addWidget(control);
    }
    row->addSpacing(8);
    row->addWidget(hint_, 1);
    return bar;
}

void ProfilePage::buildReadings() {
    readings_->add("profileLength", tr("length"), tr("Length of the line, seen from above"));
    readings_->add("cursorDistance", tr("A to B"), tr("Distance of the cursors along the line"));
    readings_->add("cursorRise", tr("height B − A"), tr("Height at cursor B above that at A"));
    readings_->add("cursorAngle", tr("angle"),
                   tr("Of the straight line from A to B to the scan's plane, up: positive"));
    readings_->add("stepReading", tr("step"),
                   tr("Mean height of the right stretch above that of the left one ± root of the "
                      "sum of both variances and that of the z calibration"));
    readings_->add("gratingReading", tr("grating"),
                   tr("Depth of a grating along the whole line, from the middle thirds of all "
                      "ridges and grooves (ISO 5436-1) ± standard deviation, by its residuals and "
                      "the z calibration"));
}

void ProfilePage::setProfile(const std::optional<Profile>& profile, double zCalibration,
                             const QString& smoothing) {
    profile_ = profile;
    zCalibration_ = zCalibration;
    smoothing_ = smoothing;
    show();
}

void ProfilePage::setDrawing(bool drawing) { draw_->setChecked(drawing); }

int ProfilePage::width() const { return width_->value(); }

QVector<double> ProfilePage::stops() const {
    return profile_ ? QVector<double>{cursors_[0], cursors_[1]} : QVector<double>();
}

void ProfilePage::moveCursor(int index, double distance) {
    cursors_[static_cast<std::size_t>(index)] = std::clamp(distance / profile_->length(), 0.0, 1.0);
    showCursors();
    Q_EMIT stopsChanged();
}

void ProfilePage::moveStretch(int index, int edge, double distance) {
    PlotStretch& stretch = stretches_[static_cast<std::size_t>(index)];
    (edge == 0 ? stretch.from : stretch.to) = std::clamp(distance / profile_->length(), 0.0, 1.0);
    showStep();
}

void ProfilePage::show() {
    hint_->setText(profile_ ? tr("Smoothing: %1").arg(smoothing_)
                            : tr("Draw a line on the whole scan: its profile is shown here"));
    remove_->setEnabled(profile_.has_value());
    step_->setEnabled(profile_.has_value());
    QVector<QPointF> points;
    for (std::size_t i = 0; profile_ && i < profile_->heights.size(); ++i) {
        points.append({profile_->distance(i), profile_->heights[i]});
    }
    plot_->setProfile(points);
    readings_->set("profileLength", profile_ ? profileLengthText(profile_->length()) : QString());
    showCursors();
    showStep();
    Q_EMIT stopsChanged();
}

void ProfilePage::showCursors() {
    if (!profile_) {
        for (const char* const reading : {"cursorDistance", "cursorRise", "cursorAngle"}) {
            readings_->set(reading, {});
        }
        return;
    }
    const double length = profile_->length();
    const ProfilePlot::Cursors positions{length * cursors_[0], length * cursors_[1]};
    plot_->setCursors(positions);
    const auto reading = readingBetween(*profile_, positions[0], positions[1]);
    // The reading is in the order along the line, the cursors may have changed sides.
    const double sign = positions[0] <= positions[1] ? 1.0 : -1.0;
    readings_->set("cursorDistance", profileLengthText(std::abs(positions[1] - positions[0])));
    readings_->set("cursorRise", reading ? profileLengthText(sign * reading->rise) : QString());
    readings_->set("cursorAngle", reading ? angleText(reading->angle) : QString());
}

ProfilePlot::Stretches ProfilePage::stretches() const {
    ProfilePlot::Stretches scaled = stretches_;
    for (PlotStretch& stretch : scaled) {
        stretch = {profile_->length() * stretch.from, profile_->length() * stretch.to};
    }
    return scaled;
}

void ProfilePage::showStep() {
    if (!profile_) {
        plot_->setStretches(std::nullopt);
        readings_->set("stepReading", {});
        readings_->set("gratingReading", {});
        return;
    }
    const auto grating = gratingHeight(*profile_);
    readings_->set("gratingReading", grating ? withDeviation(*grating, zCalibration_) : QString());
    if (!step_->isChecked()) {
        plot_->setStretches(std::nullopt);
        readings_->set("stepReading", {});
        return;
    }
    const ProfilePlot::Stretches scaled = stretches();
    plot_->setStretches(scaled);
    const auto step = stepHeight(*profile_, intervalOf(scaled[0]), intervalOf(scaled[1]));
    readings_->set("stepReading", step ? withDeviation(*step, zCalibration_) : QString());
}

}  // namespace asperity
