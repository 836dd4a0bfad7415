#include "ui/measure/ProfilePage.h"

#include "core/SiFormat.h"
#include "core/surface/measure/StepHeight.h"
#include "ui/Steady.h"
#include "ui/measure/PageParts.h"
#include "ui/measure/ReadingGrid.h"
#include "ui/panels/Card.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QSpinBox>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

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
    , hint_(captionLabel(tr("Draw a line on the whole scan: its profile is shown here"), this)) {
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

void ProfilePage::setProfile(const std::optional<Profile>& profile, double zCalibration) {
    profile_ = profile;
    zCalibration_ = zCalibration;
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
    hint_->setVisible(!profile_);
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
    const ProfilePlot::Cursors places{length * cursors_[0], length * cursors_[1]};
    plot_->setCursors(places);
    const auto reading = readingBetween(*profile_, places[0], places[1]);
    // The reading is in the order along the line, the cursors may have changed sides.
    const double sign = places[0] <= places[1] ? 1.0 : -1.0;
    readings_->set("cursorDistance", profileLengthText(std::abs(places[1] - places[0])));
    readings_->set("cursorRise", reading ? profileLengthText(sign * reading->rise) : QString());
    readings_->set("cursorAngle", reading ? angleText(reading->angle) : QString());
}

ProfilePlot::Stretches ProfilePage::stretches() const {
    ProfilePlot::Stretches places = stretches_;
    for (PlotStretch& stretch : places) {
        stretch = {profile_->length() * stretch.from, profile_->length() * stretch.to};
    }
    return places;
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
    const ProfilePlot::Stretches places = stretches();
    plot_->setStretches(places);
    const auto step = stepHeight(*profile_, intervalOf(places[0]), intervalOf(places[1]));
    readings_->set("stepReading", step ? withDeviation(*step, zCalibration_) : QString());
}

}  // namespace asperity
