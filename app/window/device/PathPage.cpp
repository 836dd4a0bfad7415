#include "app/window/device/PathPage.h"

#include "core/haptics/ZFeedback.h"
#include "core/scene/SceneDescription.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/PageParts.h"

#include <QComboBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity {

namespace {

constexpr double kNano = 1e9;  // lengths and forces are shown in nanometers, nanonewtons
constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kRadii = 10.0;        // length of a line, of the tip's radius at least
constexpr double kPixels = 4.0;        // same, of pixels at least
constexpr double kOfScan = 0.4;        // same, of the scan's width at most
constexpr double kUsualSpeed = 100.0;  // at which the film is held to 5 % [nm/s]
constexpr double kHighLoad = 5.0;      // of the setpoint
constexpr int kRasterLinesShown = 8;
constexpr int kMaxLines = 1000;
constexpr int kFormWidthOfPath = 330;  ///< at most [px]

NumberBox* pathNumber(const char* name, double low, double high, const QString& unit,
                      const QString& tip) {
    auto* box = named(new NumberBox, name, tip);
    box->setDecimals(6);
    box->setRange(low, high);
    box->setSuffix(unit);
    guardFromWheel(*box);
    return box;
}

/// The largest of 1, 2, 5, 10, ... that is not above a value.
double roundedDown(double value) {
    const double decade = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {5.0, 2.0}) {
        if (step * decade <= value) {
            return step * decade;
        }
    }
    return decade;
}

bool isLines(PlannedPath kind) { return kind != PlannedPath::Approach; }

}  // namespace

PathPage::PathPage(QWidget* parent)
    : QWidget(parent)
    , kind_(newList("pathKind", tr("Path that the tip follows from where it is")))
    , hold_(newList("pathHold", tr("Force: a feedback holds the load\nHeight: the lever stays at "
                                   "its height, or at that of the file")))
    , load_(pathNumber("pathLoad", kNano * kMinSetpoint, kNano * kMaxSetpoint, tr(" nN"),
                       tr("Force above that of the free lever that is held, or at which an "
                          "approach ends; at first the setpoint")))
    , length_(pathNumber("pathLength", 1e-3, 1e9, tr(" nm"), tr("Length of a line")))
    , direction_(pathNumber("pathDirection", -360.0, 360.0, tr(" °"),
                            tr("Direction of a line: 0° to the right of the scan, 90° up")))
    , speed_(
          pathNumber("pathSpeed", 1e-3, 1e9, tr(" nm/s"), tr("Speed along a line, or down and up")))
    , lines_(newNumber("pathLines", {}, 1, kMaxLines,
                       tr("Lines there and back, or repeats of an approach or a file")))
    , gain_(new GainSpinBox(kMinFeedbackGain, kMaxFeedbackGain))
    , file_(
          pushButton(tr("File…"), "pathPageFile", tr("Take the path of a CSV file"), Qt::TabFocus))
    , start_(pushButton(tr("Start"), "startPath",
                        tr("Engage where the tip is far, then follow the "
                           "path"),
                        Qt::TabFocus))
    , stop_(pushButton(tr("Stop"), "stopPath", tr("End the path; the tip stays"), Qt::TabFocus))
    , progress_(captionLabel(tr("Choose a path, then Start"), this))
    , heights_(new LinePlot({.title = tr("Height"), .unit = QStringLiteral("m"), .smallest = 1e-10},
                            this))
    , forces_(new LinePlot(
          {.title = tr("Lateral force"), .unit = QStringLiteral("N"), .smallest = 1e-10}, this)) {
    for (const PlannedPath kind : kValues<PlannedPath>) {
        kind_->addItem(QString::fromUtf8(nameOf(kind)));
    }
    hold_->addItems({tr("Force"), tr("Height")});
    named(gain_, "feedbackGain",
          tr("Share of the force's error that the feedback corrects in a tick"));
    guardFromWheel(*gain_);
    gain_->setValue(kDefaultFeedbackGain);
    direction_->setValue(0.0);
    named(progress_, "pathProgress", tr("Where the path is, or how it ended"));
    progress_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    heights_->setToolTip(
        tr("Height of the tip as the instrument records it: base plus deflection"));
    forces_->setToolTip(tr("Force on the tip along the line; half of retrace minus trace is "
                           "friction"));
    addParts();
    connectParts();
    setScan(1e-6, 1e-9, 15e-9);
    choose(PlannedPath::Slide);
    setRunning(false, {});
}

void PathPage::addParts() {
    auto* form = new QWidget(this);
    form->setMaximumWidth(kFormWidthOfPath);
    auto* grid = new QGridLayout(form);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(6);
    grid->setVerticalSpacing(2);
    const auto add = [&](int row, int column, const QString& name, QWidget* widget) {
        auto* caption = captionLabel(name, form);
        caption->setToolTip(widget->toolTip());
        widget->setAccessibleName(name);
        grid->addWidget(caption, row, 2 * column);
        grid->addWidget(widget, row, 2 * column + 1);
    };
    add(0, 0, tr("Path"), kind_);
    add(0, 1, tr("Hold"), hold_);
    add(1, 0, tr("Length"), length_);
    add(1, 1, tr("Load"), load_);
    add(2, 0, tr("Direction"), direction_);
    add(2, 1, tr("Speed"), speed_);
    add(3, 0, tr("Lines"), lines_);
    add(3, 1, tr("Gain"), gain_);
    grid->addWidget(newRow({start_, stop_, file_}), 4, 0, 1, 4);
    grid->addWidget(progress_, 5, 0, 1, 4);
    grid->setRowStretch(6, 1);
    auto* plots = new QVBoxLayout;
    plots->setSpacing(0);
    plots->addWidget(heights_, 1);
    plots->addWidget(forces_, 1);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 4, 6, 4);
    row->setSpacing(12);
    row->addWidget(form);
    row->addLayout(plots, 1);
}

void PathPage::connectParts() {
    connect(kind_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        const auto chosen = static_cast<std::size_t>(index);
        if (chosen < kValues<PlannedPath>.size()) {
            choose(kValues<PlannedPath>.at(chosen));
        } else {
            chooseFile(kind_->itemText(index));
        }
    });
    connect(hold_, qOverload<int>(&QComboBox::activated), this, [this](int index) {
        if (!request().isFile) {
            holdBefore_ = index;
        }
        showUse();
        Q_EMIT changed();
    });
    for (NumberBox* const box : {length_, direction_, speed_}) {
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PathPage::changed);
    }
    connect(load_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] {
        hasOwnLoad_ = true;
        load_->setMuted(false);
        Q_EMIT changed();
    });
    connect(lines_, qOverload<int>(&QSpinBox::valueChanged), this, &PathPage::changed);
    connect(gain_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &PathPage::gainChanged);
    connect(start_, &QPushButton::clicked, this, &PathPage::startChosen);
    connect(stop_, &QPushButton::clicked, this, &PathPage::stopChosen);
    connect(file_, &QPushButton::clicked, this, &PathPage::fileRequested);
}

PathRequest PathPage::request() const {
    const int planned = static_cast<int>(kValues<PlannedPath>.size());
    const int index = kind_->currentIndex();
    PathRequest request;
    request.isFile = index >= planned;
    request.kind = request.isFile ? PlannedPath::Slide
                                  : kValues<PlannedPath>.at(static_cast<std::size_t>(index));
    request.holdsForce = hold_->currentIndex() == 0;
    request.load = load_->value() / kNano;
    request.lines = {.length = length_->value() / kNano,
                     .speed = speed_->value() / kNano,
                     .direction = direction_->value() / kDegrees,
                     .lines = lines_->value()};
    if (request.kind == PlannedPath::Raster && request.lines.lines > 1) {
        request.lines.pitch = request.lines.length / (request.lines.lines - 1);
    }
    return request;
}

void PathPage::choose(PlannedPath kind) {
    const auto found = std::ranges::find(kValues<PlannedPath>, kind);
    hold_->setCurrentIndex(holdBefore_);
    kind_->setCurrentIndex(static_cast<int>(found - kValues<PlannedPath>.begin()));
    const QSignalBlocker blocker(lines_);
    lines_->setValue(kind == PlannedPath::Raster ? kRasterLinesShown : 1);
    suggestLoad();
    showUse();
    Q_EMIT changed();
}

void PathPage::chooseFile(const QString& name) {
    const int planned = static_cast<int>(kValues<PlannedPath>.size());
    if (kind_->count() > planned) {
        kind_->setItemText(planned, name);
    } else {
        kind_->addItem(name);
    }
    kind_->setCurrentIndex(planned);
    const QSignalBlocker blocker(lines_);
    lines_->setValue(1);
    hold_->setCurrentIndex(1);  // its heights are in the file
    showUse();
    Q_EMIT changed();
}

void PathPage::forgetFile() {
    const int planned = static_cast<int>(kValues<PlannedPath>.size());
    if (kind_->currentIndex() == planned) {
        choose(PlannedPath::Slide);
    }
    kind_->removeItem(planned);
}

void PathPage::setScan(double width, double pixel, double tipRadius) {
    const double length =
        kNano * std::min(std::max(kRadii * tipRadius, kPixels * pixel), kOfScan * width);
    const QSignalBlocker lengthBlocker(length_);
    const QSignalBlocker speedBlocker(speed_);
    length_->setValue(roundedDown(length));
    speed_->setValue(kUsualSpeed);
    Q_EMIT changed();
}

void PathPage::setSetpoint(double force) {
    setpoint_ = force;
    suggestLoad();
}

void PathPage::suggestLoad() {
    if (hasOwnLoad_) {
        return;
    }
    const QSignalBlocker blocker(load_);
    load_->setValue(kNano * setpoint_ * (request().kind == PlannedPath::Scratch ? kHighLoad : 1.0));
    load_->setMuted(true);
}

/// Enables the fields that the chosen path uses: a file has its own length, direction and speed,
/// and an approach has no line and holds nothing.
void PathPage::showUse() {
    const PathRequest now = request();
    const bool drawsLines = !now.isFile && isLines(now.kind);
    length_->setEnabled(drawsLines);
    direction_->setEnabled(drawsLines);
    speed_->setEnabled(!now.isFile);
    hold_->setEnabled(now.isFile || drawsLines);
    load_->setEnabled(now.holdsForce || (!now.isFile && !drawsLines));
    gain_->setEnabled(now.holdsForce && (now.isFile || drawsLines));
}

void PathPage::setRunning(bool running, const QString& progress) {
    stop_->setEnabled(running);
    if (!progress.isEmpty()) {
        progress_->setText(progress);
    }
}

void PathPage::setRefusal(const QString& why) {
    start_->setEnabled(why.isEmpty());
    start_->setToolTip(why.isEmpty() ? tr("Engage where the tip is far, then follow the path")
                                     : why);
}

void PathPage::hideEvent(QHideEvent* /*event*/) { Q_EMIT hidden(); }

}  // namespace asperity
