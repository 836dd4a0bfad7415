#include "app/window/measure/ProfileControl.h"

#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/measure/TableExport.h"
#include "core/SiFormat.h"
#include "core/surface/measure/Profile.h"
#include "ui/shell/Menus.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/FlowLayout.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QPainter>
#include <QPainterPath>
#include <QPixmap>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace asperity {

namespace {

constexpr double kEndReach = 8.0;        ///< of the pointer to an end [px]
constexpr double kNear = 5.0;            ///< of the pointer to the line [px]
constexpr double kEndRadius = 4.0;       ///< radius of an end [px]
constexpr double kStop = 5.0;            ///< half a cursor's bar [px]
constexpr double kToolLineWidth = 1.8;   ///< [px]
constexpr double kOtherLineWidth = 1.4;  ///< [px]

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
double meanHeight(const HeightField& heights, const Vector2& middle, const Vector2& step,
                  int width) {
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < width; ++i) {
        const Vector2 at = middle + (i - 0.5 * (width - 1)) * step;
        const double height = heights.at(at.x(), at.y());
        if (isFiniteHeight(height)) {
            sum += height;
            ++count;
        }
    }
    return count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
}

constexpr int kMaxWidth = 31;    ///< lines side by side
constexpr int kMaxLines = 6;     ///< whose colors are told apart
constexpr int kLineSwatch = 10;  ///< of a line's color in the list [px]

QString lineName(int color) { return ProfilePage::tr("Line %1").arg(color + 1); }

QIcon swatch(const QColor& color) {
    QPixmap square(kLineSwatch, kLineSwatch);
    square.fill(color);
    return square;
}

Color mapColor(int color) { return seriesColor(kLightPalette, static_cast<std::size_t>(color)); }

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

void LineTool::setLine(const MarkedLine& line) {
    color_ = line.color;
    setPoints(line.line);
}

void LineTool::setOthers(const QVector<MarkedLine>& others) {
    others_ = others;
    Q_EMIT marksChanged();
}

void LineTool::paint(QPainter& painter, const OverviewMap& map) const {
    for (const MarkedLine& other : others_) {
        QPainterPath path;
        path.moveTo(map.toPixel(other.line.p1()));
        path.lineTo(map.toPixel(other.line.p2()));
        strokeOverWhite(painter, mapColor(other.color), kOtherLineWidth, path);
    }
    if (isEmpty()) {
        return;
    }
    const QColor color = toQColor(mapColor(color_));
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
    strokeOverWhite(painter, mapColor(color_), kToolLineWidth, path);
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(color);
    painter.drawEllipse(drawn.p1(), kEndRadius, kEndRadius);  // where the profile begins: filled
    painter.setPen(QPen(color, kToolLineWidth));
    painter.setBrush(toQColor(kLightPalette.paper));
    painter.drawEllipse(drawn.p2(), kEndRadius, kEndRadius);
}

int LineTool::otherAt(const MapPointer& pointer, const OverviewMap& map) const {
    if (!isEmpty() && !gripAt(pointer.pixel, map).isNew) {
        return -1;
    }
    for (int i = 0; i < others_.size(); ++i) {
        const QLineF drawn(map.toPixel(others_[i].line.p1()), map.toPixel(others_[i].line.p2()));
        if (distanceTo(drawn, pointer.pixel) <= kNear) {
            return i;
        }
    }
    return -1;
}

void LineTool::press(const MapPointer& pointer, const OverviewMap& map) {
    const int other = otherAt(pointer, map);
    if (other >= 0) {
        Q_EMIT otherPressed(other);
    }
    ShapeTool::press(pointer, map);
}

Qt::CursorShape LineTool::cursor(const MapPointer& pointer, const OverviewMap& map) const {
    return otherAt(pointer, map) >= 0 ? Qt::PointingHandCursor : ShapeTool::cursor(pointer, map);
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

Profile meanProfile(const HeightField& heights, const QLineF& line, int width) {
    const Vector2 from = vectorOf(line.p1());
    const Vector2 to = vectorOf(line.p2());
    const int samples =
        std::max(kMinSamples, usualSamples(heights.pitchX, heights.pitchY, from, to));
    const Vector2 along = (to - from).normalized();
    const Vector2 step = std::min(heights.pitchX, heights.pitchY) * Vector2(-along.y(), along.x());
    return profileOf(
        [&](double x, double y) {
            return meanHeight(heights, {x, y}, step, width);
        },
        from, to, samples);
}

ProfileControl::ProfileControl(Stage& stage)
    : Feature(stage)
    , heights_(stage.get<MeasuredHeights>())
    , page_(new ProfilePage(&host_.widget())) {
    const QAction& entry = addScanTool(
        page_, tr("Profile"), 10, "profile",
        {.text = tr("&Profile line"),
         .tip = tr("Draw a line on the whole scan: heights, distance, angle, step height"),
         .shortcuts = {tr("Ctrl+L")}});
    connect(&entry, &QAction::triggered, this, [this] { page_->setDrawing(true); });
    bindTool(live_.overview().map(), line_, *page_, &ProfilePage::drawingChosen,
             &ProfilePage::setDrawing);
    heights_.follow(page_->smoothed());
    for (const auto shown :
         {&RunControl::begun, &RunControl::recordingShown, &RunControl::liveShown}) {
        connect(&runs_, shown, this, [this] { runs_.isOnOtherScan() ? forget() : refresh(); });
    }
    runs_.beforeRecording([this]() -> std::function<void()> {
        return [this, lines = lines_, selected = selected_] {
            lines_ = lines;
            select(selected);
        };
    });
    connect(&heights_, &MeasuredHeights::changed, this, &ProfileControl::refresh);
    connect(&line_, &LineTool::drawn, this, &ProfileControl::take);
    // The others are all lines but the selected one.
    connect(&line_, &LineTool::otherPressed, this,
            [this](int other) { select(selected_ < 0 || other < selected_ ? other : other + 1); });
    connect(page_, &ProfilePage::addChosen, this, &ProfileControl::beginLine);
    connect(page_, &ProfilePage::lineChosen, this, &ProfileControl::select);
    connect(page_, &ProfilePage::widthChosen, this, &ProfileControl::refresh);
    connect(page_, &ProfilePage::removeChosen, this, &ProfileControl::remove);
    connect(page_, &ProfilePage::stopsChanged, &line_, [this] { line_.setStops(page_->stops()); });
    connect(page_, &ProfilePage::exportChosen, this, [this] {
        askForTable(host_, tr("Export the profiles"), QStringLiteral("profiles.csv"),
                    [this](const std::filesystem::path& file) { write(file); });
    });
}

void ProfileControl::forget() {
    lines_.clear();
    select(-1);
}

int ProfileControl::freeColor() const {
    int color = 0;
    while (std::any_of(lines_.begin(), lines_.end(),
                       [color](const MarkedLine& line) { return line.color == color; })) {
        ++color;
    }
    return color;
}

/// The line as the user draws or moves it.
void ProfileControl::take() {
    if (selected_ < 0) {
        selected_ = lines_.size();
        lines_.append({line_.line(), freeColor()});
        showLines();
    }
    lines_[selected_].line = line_.line();
    refresh();
}

void ProfileControl::beginLine() {
    select(-1);
    page_->setDrawing(true);
}

void ProfileControl::select(int index) {
    selected_ = index;
    showLines();
    refresh();
}

void ProfileControl::remove() {
    if (selected_ >= 0) {
        lines_.removeAt(selected_);
        select(lines_.size() - 1);
    }
}

void ProfileControl::showLines() {
    QVector<MarkedLine> others = lines_;
    if (selected_ >= 0) {
        others.removeAt(selected_);
    }
    line_.setOthers(others);
    line_.setLine(selected_ >= 0 ? lines_[selected_] : MarkedLine{{}, freeColor()});
    page_->setLines(lines_, selected_);
}

/// Some milliseconds at most: a line has a few thousand samples.
void ProfileControl::refresh() {
    profiles_.clear();
    provenance_.clear();
    std::vector<ProfilePage::Shown> shown;
    QString words = tr("Draw a line on the whole scan: its profile is shown here");
    double zCalibration = 0.0;
    const std::shared_ptr<const MeasuredScan> scan = lines_.isEmpty() ? nullptr : heights_.scan();
    if (scan != nullptr) {
        const Uncertainty& given = runs_.scene().description.uncertainty;
        zCalibration = given.enabled ? given.heightCalibration : 0.0;
        words = tr("Smoothing: %1").arg(scan->smoothing());
        for (const MarkedLine& line : lines_) {
            profiles_.push_back({lineName(line.color).toStdString(),
                                 meanProfile(scan->field(), line.line, page_->width())});
            shown.push_back({profiles_.back(), line.color});
        }
        provenance_ = scan->provenance("profiles");
        provenance_.push_back("heights: means over " + std::to_string(page_->width()) +
                              " lines side by side, a pixel apart");
    } else if (!lines_.isEmpty()) {
        words = heights_.state();
    }
    page_->setProfiles(shown, shown.empty() ? -1 : selected_, zCalibration, words);
}

void ProfileControl::writeTo(const std::filesystem::path& file) {
    writeTableTo(host_, file, [this](const std::filesystem::path& path) { write(path); });
}

void ProfileControl::write(const std::filesystem::path& file) {
    writeProfiles(file, provenance_, profiles_);
}

ProfilePage::ProfilePage(QWidget* parent)
    : QWidget(parent)
    , plot_(new ProfilePlot(this))
    , readings_(new ReadingGrid(this))
    , draw_(pageButton(tr("Draw line"), "drawProfile",
                       tr("A drag on the whole scan draws the line, or moves it or its ends; off, "
                          "or Esc: a double click travels again"),
                       this))
    , add_(pageButton(tr("Add"), "addProfile",
                      tr("The next drag draws a further line, up to %1").arg(kMaxLines), this))
    , remove_(pageButton(tr("Remove"), "removeProfile", tr("Removes the selected line"), this))
    , list_(newList("profileLines", tr("The selected line: its numbers are shown, and a drag moves "
                                       "it; a press on another line selects that")))
    , width_(new QSpinBox(this))
    , step_(new QCheckBox(tr("Step height"), this))
    , smoothed_(newSmoothedBox("profileSmoothed", this))
    , export_(pageButton(tr("Export…"), "exportProfiles",
                         tr("Writes all profiles to a table, in SI units"), this))
    , hint_(captionLabel(QString(), this)) {
    setToolTip(tr("Heights along lines, distance, angle and step height"));
    draw_->setCheckable(true);
    buildReadings();
    hint_->setObjectName(QStringLiteral("profileState"));
    hint_->setToolTip(tr("Smoothing of the heights"));
    hint_->setWordWrap(true);
    hint_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Ignored);
    auto* side = new QVBoxLayout;
    side->addWidget(readings_);
    side->addWidget(hint_, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(10);
    middle->addWidget(plot_, 1);
    middle->addLayout(side);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    column->addWidget(buildBar());
    column->addLayout(middle, 1);
    connect(draw_, &QToolButton::toggled, this, &ProfilePage::drawingChosen);
    connect(add_, &QToolButton::clicked, this, &ProfilePage::addChosen);
    connect(remove_, &QToolButton::clicked, this, &ProfilePage::removeChosen);
    connect(list_, qOverload<int>(&QComboBox::activated), this, &ProfilePage::lineChosen);
    connect(export_, &QToolButton::clicked, this, &ProfilePage::exportChosen);
    connect(width_, qOverload<int>(&QSpinBox::valueChanged), this, &ProfilePage::widthChosen);
    connect(step_, &QCheckBox::toggled, this, &ProfilePage::show);
    connect(plot_, &ProfilePlot::cursorDragged, this, &ProfilePage::moveCursor);
    connect(plot_, &ProfilePlot::stretchDragged, this, &ProfilePage::moveStretch);
    setLines({}, -1);
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
    step_->setFocusPolicy(Qt::TabFocus);
    list_->setAccessibleName(tr("Selected line"));
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QWidget* const control :
         {static_cast<QWidget*>(draw_), static_cast<QWidget*>(add_), static_cast<QWidget*>(remove_),
          static_cast<QWidget*>(list_), static_cast<QWidget*>(width_), static_cast<QWidget*>(step_),
          static_cast<QWidget*>(smoothed_), static_cast<QWidget*>(export_)}) {
        row->addWidget(control);
    }
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

void ProfilePage::setLines(const QVector<MarkedLine>& lines, int selected) {
    const QSignalBlocker quiet(list_);
    list_->clear();
    for (const MarkedLine& line : lines) {
        list_->addItem(swatch(toQColor(mapColor(line.color))), lineName(line.color));
    }
    list_->setCurrentIndex(selected);
    list_->setEnabled(!lines.isEmpty());
    add_->setEnabled(!lines.isEmpty() && lines.size() < kMaxLines);
    remove_->setEnabled(selected >= 0);
}

void ProfilePage::setProfiles(const std::vector<Shown>& profiles, int selected, double zCalibration,
                              const QString& words) {
    profile_.reset();
    if (selected >= 0) {
        profile_ = profiles.at(static_cast<std::size_t>(selected)).profile.profile;
    }
    zCalibration_ = zCalibration;
    hint_->setText(words);
    export_->setEnabled(!profiles.empty());
    QVector<ProfileCurve> curves;
    for (const auto& [named, color] : profiles) {
        ProfileCurve curve{QString::fromStdString(named.name), color, {}};
        for (std::size_t i = 0; i < named.profile.heights.size(); ++i) {
            curve.points.append({named.profile.distance(i), named.profile.heights[i]});
        }
        curves.append(curve);
    }
    plot_->setCurves(curves, selected);
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
    step_->setEnabled(profile_.has_value());
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
