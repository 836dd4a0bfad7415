#include "app/window/measure/RoughnessControl.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "core/SiFormat.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"

#include <QAction>
#include <QCheckBox>
#include <QHBoxLayout>
#include <QLocale>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <variant>

namespace asperity {

namespace {

const std::array<const char*, 13> kReadings = {"sa",  "sq",         "sz",         "sp",  "sv",
                                               "ssk", "sku",        "sdq",        "sdr", "sal",
                                               "str", "meanHeight", "heightRange"};

constexpr int kReadingRows = 7;  // what fits below the large view

/// To four digits; what is smaller than a femtometer is nothing.
QString roughnessLengthText(double meters) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-15), "m");
    return QStringLiteral("%1 %2")
        .arg(scale.factor * meters, 0, 'g', 4)
        .arg(QString::fromStdString(scale.unit));
}

QString roughnessNumberText(const std::optional<double>& number) {
    return number ? QString::number(*number, 'g', 4) : QString();
}

QString countText(std::size_t count) {
    return QLocale::c().toString(static_cast<qulonglong>(count));
}

QString levelingText(const SampleDescription& sample) {
    return QString::fromStdString(textOf(sample.leveling)).replace('_', ' ');
}

/// Whether the surface has other heights than the leveled scan, which its file still has.
bool hasSmoothedScan(const SampleDescription& sample) {
    return !sample.shape &&
           (sample.smoothingLength > 0.0 || sample.smoothingPixels.value_or(0.0) > 0.0);
}

}  // namespace

QString smoothingInWords(const SampleDescription& sample) {
    if (sample.smoothingLength > 0.0) {
        return RoughnessControl::tr("Gaussian, standard deviation %1 nm")
            .arg(1e9 * sample.smoothingLength, 0, 'g', 3);
    }
    const double pixels = sample.smoothingPixels.value_or(0.0);
    return pixels > 0.0
               ? RoughnessControl::tr("Gaussian, standard deviation %1 px").arg(pixels, 0, 'g', 3)
               : RoughnessControl::tr("none");
}

RoughnessPage::RoughnessPage(QWidget* parent)
    : QWidget(parent)
    , readings_(new ReadingGrid(this, kReadingRows))
    , draw_(pageButton(tr("Draw rectangle"), "drawRectangle",
                       tr("A drag on the whole scan draws the rectangle, or moves it or its sides; "
                          "off, or Esc: a double click travels again"),
                       this))
    , whole_(pageButton(tr("Whole scan"), "wholeScan",
                        tr("Removes the rectangle: the roughness is that of the whole scan"), this))
    , smoothed_(named(new QCheckBox(tr("Smoothed, as the tip meets it"), this), "measureSmoothed",
                      tr("Measures the surface that the tip touches, with the smoothing of the "
                         "scene; off: the leveled heights of the scan")))
    , state_(captionLabel(QString(), this))
    , subject_(new QLabel(this)) {
    setToolTip(tr("Roughness (ISO 25178) of the scan or a rectangle"));
    draw_->setCheckable(true);
    addReadings();
    state_->setObjectName(QStringLiteral("roughnessState"));
    state_->setToolTip(tr("Whether the roughness is being computed"));
    subject_->setObjectName(QStringLiteral("roughnessSubject"));
    subject_->setToolTip(tr("What the roughness is of: area, pixels with data, leveling, and "
                            "smoothing of what was measured"));
    subject_->setWordWrap(true);
    subject_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    subject_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* bar = new QHBoxLayout;
    bar->setSpacing(4);
    bar->addWidget(draw_);
    bar->addWidget(whole_);
    bar->addWidget(smoothed_);
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
    connect(smoothed_, &QCheckBox::toggled, this, &RoughnessPage::smoothedChosen);
    setRectangle(false);
    clear({});
}

void RoughnessPage::addReadings() {
    readings_->add("sa", tr("Sa"),
                   tr("Arithmetical mean height: mean of |z − mean| (ISO 25178-2)"));
    readings_->add("sq", tr("Sq"), tr("Root mean square height (ISO 25178-2)"));
    readings_->add("sz", tr("Sz"), tr("Maximum height: highest − lowest (ISO 25178-2)"));
    readings_->add("sp", tr("Sp"), tr("Maximum peak height: highest − mean (ISO 25178-2)"));
    readings_->add("sv", tr("Sv"), tr("Maximum pit height: mean − lowest (ISO 25178-2)"));
    readings_->add("meanHeight", tr("mean"), tr("Mean height"));
    readings_->add("heightRange", tr("from, to"), tr("Lowest and highest height"));
    readings_->add("ssk", tr("Ssk"),
                   tr("Skewness: mean of (z − mean)³ over Sq³; negative: pits (ISO 25178-2)"));
    readings_->add("sku", tr("Sku"),
                   tr("Kurtosis: mean of (z − mean)⁴ over Sq⁴; 3: a normal distribution "
                      "(ISO 25178-2)"));
    readings_->add("sdq", tr("Sdq"), tr("Root mean square gradient (ISO 25178-2)"));
    readings_->add("sdr", tr("Sdr"),
                   tr("Developed interfacial area ratio: area of the surface above that of its "
                      "outline (ISO 25178-2)"));
    readings_->add("sal", tr("Sal"),
                   tr("Autocorrelation length: shortest distance at which the autocorrelation "
                      "falls to 0.2; –: not within half of a side (ISO 25178-2)"));
    readings_->add("str", tr("Str"),
                   tr("Texture aspect ratio: Sal over the longest such distance, 1: the same in "
                      "all directions; –: not within half of a side (ISO 25178-2)"));
}

void RoughnessPage::setResult(const Subject& subject, const Numbers& numbers) {
    const Roughness& roughness = numbers.roughness;
    const Texture& texture = numbers.texture;
    readings_->set("sa", roughnessLengthText(roughness.sa));
    readings_->set("sq", roughnessLengthText(roughness.sq));
    readings_->set("sz", roughnessLengthText(roughness.sz));
    readings_->set("sp", roughnessLengthText(roughness.sp));
    readings_->set("sv", roughnessLengthText(roughness.sv));
    readings_->set("ssk", roughnessNumberText(roughness.ssk));
    readings_->set("sku", roughnessNumberText(roughness.sku));
    readings_->set("sdq", roughnessNumberText(roughness.sdq));
    readings_->set("sdr", QStringLiteral("%1 %").arg(100.0 * roughness.sdr, 0, 'g', 4));
    readings_->set("sal", texture.sal ? roughnessLengthText(*texture.sal) : QString());
    readings_->set("str", roughnessNumberText(texture.str));
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
    if (texture.step > 1) {
        lines << tr("Sal, Str: of one pixel in %1 a side").arg(texture.step);
    }
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

bool RoughnessPage::isSmoothed() const { return smoothed_->isChecked(); }

QString RoughnessPage::subject() const { return subject_->text(); }

void RoughnessPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    Q_EMIT shown();
}

RoughnessControl::RoughnessControl(Stage& stage)
    : Feature(stage)
    , page_(new RoughnessPage(&host_.widget()))
    , work_(
          {.progressed = [this](double share) { page_->setProgress(share); },
           .finished = [this](Result& result) { page_->setResult(result.subject, result.numbers); },
           .failed =
               [this](const std::exception_ptr& reason) { page_->clear(reasonOf(reason)); }}) {
    addScanTool(page_, tr("Roughness"), 20, "roughness",
                {.text = tr("&Roughness"),
                 .tip = tr("Roughness (ISO 25178) of the scan or a rectangle"),
                 .shortcuts = {tr("Ctrl+U")}});
    bindTool(live_.overview().map(), rectangle_, *page_, &RoughnessPage::drawingChosen,
             &RoughnessPage::setDrawing);
    for (const auto shown :
         {&RunControl::begun, &RunControl::recordingShown, &RunControl::liveShown}) {
        connect(&runs_, shown, this, [this] { runs_.isOnOtherScan() ? forget() : refresh(); });
    }
    runs_.beforeRecording([this]() -> std::function<void()> {
        return [this, rectangle = rectangle_.rectangle()] {
            rectangle_.setRectangle(rectangle);
            refresh();
        };
    });
    connect(&rectangle_, &RectangleTool::drawn, this, &RoughnessControl::refresh);
    connect(page_, &RoughnessPage::wholeChosen, this, &RoughnessControl::forget);
    connect(page_, &RoughnessPage::smoothedChosen, this, &RoughnessControl::refresh);
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

RoughnessControl::Result RoughnessControl::measure(const HeightRows& rows, const QRectF& rectangle,
                                                   Progress& progress) {
    const PixelRectangle pixels = rectangle.isEmpty()
                                      ? allPixels(rows)
                                      : pixelsBetween(rows, {rectangle.left(), rectangle.top()},
                                                      {rectangle.right(), rectangle.bottom()});
    ProgressPart first(&progress, 0.0, 0.3);
    const Roughness roughness = roughnessOf(rows, pixels, &first);
    ProgressPart second(&progress, 0.3, 1.0);
    return {.subject = {.width = pixels.columns * rows.pitchX,
                        .height = pixels.rows * rows.pitchY,
                        .pixels = static_cast<std::size_t>(pixels.columns) *
                                  static_cast<std::size_t>(pixels.rows),
                        .isRectangle = !rectangle.isEmpty(),
                        .leveling = QString(),
                        .smoothing = QString()},
            .numbers = {.roughness = roughness, .texture = textureOf(rows, pixels, &second)}};
}

RoughnessControl::Result RoughnessControl::compute(const Scene& scene, const QRectF& rectangle,
                                                   bool smoothed, Progress& progress) {
    const SampleDescription& sample = scene.description.sample;
    Result result;
    if (!smoothed && hasSmoothedScan(sample)) {
        ProgressPart reading(&progress, 0.0, 0.4);
        const auto scan = leveledScan(sample, &reading);
        ProgressPart measuring(&progress, 0.4, 1.0);
        result = std::visit(
            [&](const auto& map) { return measure(rowsOf(map), rectangle, measuring); }, scan);
        result.subject.smoothing = tr("none; the tip meets: %1").arg(smoothingInWords(sample));
    } else {
        result = measure(rowsOf(scene.surface), rectangle, progress);
        result.subject.smoothing = smoothingInWords(sample);
    }
    result.subject.leveling = levelingText(sample);
    return result;
}

void RoughnessControl::refresh() {
    page_->setRectangle(!rectangle_.isEmpty());
    work_.cancel();
    due_ = !page_->isVisible();
    if (runs_.run() == nullptr) {
        page_->clear({});
    } else if (!due_) {
        page_->setProgress(0.0);
        work_.start([loaded = runs_.shared(), rectangle = rectangle_.rectangle(),
                     smoothed = page_->isSmoothed()](Progress& progress) {
            return compute(loaded->scene, rectangle, smoothed, progress);
        });
    }
}

}  // namespace asperity
