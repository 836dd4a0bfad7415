#include "app/window/measure/RoughnessControl.h"

#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "core/SiFormat.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

const std::array<const char*, 6> kReadings = {"sa", "sq", "sz", "sdr", "meanHeight", "heightRange"};

/// To four digits; what is smaller than a femtometer is nothing.
QString roughnessLengthText(double meters) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-15), "m");
    return QStringLiteral("%1 %2")
        .arg(scale.factor * meters, 0, 'g', 4)
        .arg(QString::fromStdString(scale.unit));
}

QString countText(std::size_t count) {
    return QLocale::c().toString(static_cast<qulonglong>(count));
}

QString levelingText(const SampleDescription& sample) {
    return QString::fromStdString(textOf(sample.leveling)).replace('_', ' ');
}

QString smoothingText(const SampleDescription& sample) {
    if (sample.smoothingLength > 0.0) {
        return RoughnessControl::tr("Gaussian, standard deviation %1 nm")
            .arg(1e9 * sample.smoothingLength, 0, 'g', 3);
    }
    const double pixels = sample.smoothingPixels.value_or(0.0);
    return pixels > 0.0
               ? RoughnessControl::tr("Gaussian, standard deviation %1 px").arg(pixels, 0, 'g', 3)
               : RoughnessControl::tr("none");
}

}  // namespace

RoughnessPage::RoughnessPage(QWidget* parent)
    : QWidget(parent)
    , readings_(new ReadingGrid(this))
    , draw_(pageButton(tr("Draw rectangle"), "drawRectangle",
                       tr("A drag on the whole scan draws the rectangle, or moves it or its sides; "
                          "off, or Esc: a double click travels again"),
                       this))
    , whole_(pageButton(tr("Whole scan"), "wholeScan",
                        tr("Removes the rectangle: the roughness is that of the whole scan"), this))
    , state_(captionLabel(QString(), this))
    , subject_(new QLabel(this)) {
    setToolTip(tr("Sa, Sq, Sz and Sdr (ISO 25178) of the scan or a rectangle"));
    draw_->setCheckable(true);
    readings_->add("sa", tr("Sa"),
                   tr("Arithmetical mean height: mean of |z − mean| (ISO 25178-2)"));
    readings_->add("sq", tr("Sq"), tr("Root mean square height (ISO 25178-2)"));
    readings_->add("sz", tr("Sz"), tr("Maximum height: highest − lowest (ISO 25178-2)"));
    readings_->add("sdr", tr("Sdr"),
                   tr("Developed interfacial area ratio: area of the surface above that of its "
                      "outline (ISO 25178-2)"));
    readings_->add("meanHeight", tr("mean"), tr("Mean height"));
    readings_->add("heightRange", tr("from, to"), tr("Lowest and highest height"));
    state_->setObjectName(QStringLiteral("roughnessState"));
    state_->setToolTip(tr("Whether the roughness is being computed"));
    subject_->setObjectName(QStringLiteral("roughnessSubject"));
    subject_->setToolTip(tr("What the roughness is of: area, pixels with data, leveling and "
                            "smoothing of the scene"));
    subject_->setWordWrap(true);
    subject_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    subject_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(4);
    bar->addWidget(draw_);
    bar->addWidget(whole_);
    bar->addSpacing(8);
    bar->addWidget(state_, 1);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(24);
    middle->addWidget(readings_);
    middle->addWidget(subject_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(6);
    column->addLayout(bar);
    column->addLayout(middle, 1);
    connect(draw_, &QToolButton::toggled, this, &RoughnessPage::drawingChosen);
    connect(whole_, &QToolButton::clicked, this, &RoughnessPage::wholeChosen);
    setRectangle(false);
    clear({});
}

void RoughnessPage::setResult(const Subject& subject, const Roughness& roughness) {
    readings_->set("sa", roughnessLengthText(roughness.sa));
    readings_->set("sq", roughnessLengthText(roughness.sq));
    readings_->set("sz", roughnessLengthText(roughness.sz));
    readings_->set("sdr", QStringLiteral("%1 %").arg(100.0 * roughness.sdr, 0, 'g', 4));
    readings_->set("meanHeight", roughnessLengthText(roughness.mean));
    readings_->set("heightRange", tr("%1, %2").arg(roughnessLengthText(roughness.lowest),
                                                   roughnessLengthText(roughness.highest)));
    const std::size_t left = subject.pixels - roughness.pixels;
    QStringList lines;
    lines << (subject.isRectangle ? tr("Rectangle, %1 × %2") : tr("Whole scan, %1 × %2"))
                 .arg(roughnessLengthText(subject.width), roughnessLengthText(subject.height));
    lines << tr("%1 pixels; excluded: %2 without data")
                 .arg(countText(roughness.pixels), countText(left));
    lines << tr("Leveling: %1").arg(subject.leveling);
    lines << tr("Smoothing: %1").arg(subject.smoothing);
    subject_->setText(lines.join(QLatin1Char('\n')));
    state_->clear();
}

void RoughnessPage::clear(const QString& reason) {
    for (const char* const reading : kReadings) {
        readings_->set(reading, {});
    }
    subject_->clear();
    state_->setText(reason.isEmpty() ? tr("No scan is open") : reason);
}

void RoughnessPage::setProgress(double share) {
    state_->setText(tr("Computing: %1 %").arg(std::lround(100.0 * share)));
}

void RoughnessPage::setDrawing(bool drawing) { draw_->setChecked(drawing); }

void RoughnessPage::setRectangle(bool drawn) { whole_->setEnabled(drawn); }

QString RoughnessPage::subject() const { return subject_->text(); }

void RoughnessPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    Q_EMIT shown();
}

RoughnessControl::RoughnessControl(Stage& stage)
    : Feature(stage)
    , page_(new RoughnessPage(&host_.widget()))
    , work_({.progressed = [this](double share) { page_->setProgress(share); },
             .finished =
                 [this](Result& result) { page_->setResult(result.subject, result.roughness); },
             .failed =
                 [this](const std::exception_ptr& reason) { page_->clear(reasonOf(reason)); }}) {
    addScanTool(page_, tr("Roughness"), 20, "roughness",
                {.text = tr("&Roughness"),
                 .tip = tr("Sa, Sq, Sz and Sdr of the scan or a rectangle"),
                 .shortcuts = {tr("Ctrl+U")}});
    bindTool(live_.overview().map(), rectangle_, *page_, &RoughnessPage::drawingChosen,
             &RoughnessPage::setDrawing);
    connect(&runs_, &RunControl::begun, this,
            [this] { runs_.isOnOtherScan() ? forget() : refresh(); });
    connect(&rectangle_, &RectangleTool::drawn, this, &RoughnessControl::refresh);
    connect(page_, &RoughnessPage::wholeChosen, this, &RoughnessControl::forget);
    connect(page_, &RoughnessPage::shown, this, [this] {
        if (due_) {
            refresh();
        }
    });
}

void RoughnessControl::forget() {
    rectangle_.clear();
    refresh();
}

RoughnessControl::Result RoughnessControl::compute(const Scene& scene, const QRectF& rectangle,
                                                   Progress& progress) {
    const BSplineSurface& surface = scene.surface;
    const HeightRows rows = rowsOf(surface);
    const PixelRectangle pixels = rectangle.isEmpty()
                                      ? allPixels(rows)
                                      : pixelsBetween(rows, {rectangle.left(), rectangle.top()},
                                                      {rectangle.right(), rectangle.bottom()});
    return {.subject = {.width = pixels.columns * surface.grid().pitchX,
                        .height = pixels.rows * surface.grid().pitchY,
                        .pixels = static_cast<std::size_t>(pixels.columns) *
                                  static_cast<std::size_t>(pixels.rows),
                        .isRectangle = !rectangle.isEmpty(),
                        .leveling = levelingText(scene.description.sample),
                        .smoothing = smoothingText(scene.description.sample)},
            .roughness = roughnessOf(rows, pixels, &progress)};
}

void RoughnessControl::refresh() {
    page_->setRectangle(!rectangle_.isEmpty());
    work_.cancel();
    due_ = !page_->isVisible();
    if (runs_.run() == nullptr) {
        page_->clear({});
    } else if (!due_) {
        page_->setProgress(0.0);
        work_.start([loaded = runs_.run()->shared(),
                     rectangle = rectangle_.rectangle()](Progress& progress) {
            return compute(loaded->scene, rectangle, progress);
        });
    }
}

}  // namespace asperity
