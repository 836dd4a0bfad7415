#include "app/window/measure/RoughnessControl.h"

#include "app/reports/MeasureReport.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/measure/TableExport.h"
#include "core/SiFormat.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/FlowLayout.h"
#include "ui/widgets/PageParts.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QStackedWidget>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

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

/// Words of the menu of exports, and the file that the dialog offers.
struct ExportTexts {
    RoughnessPage::Table table;
    const char* name;
    const char* text;
    const char* tip;
    const char* file;
};

constexpr std::array<ExportTexts, 3> kExports{
    {{RoughnessPage::Table::Numbers, "exportNumbers",
      QT_TRANSLATE_NOOP("RoughnessPage", "&Numbers…"),
      QT_TRANSLATE_NOOP("RoughnessPage", "Writes the numbers as a row, as asperity measure --csv"),
      "roughness.csv"},
     {RoughnessPage::Table::Histogram, "exportHistogram",
      QT_TRANSLATE_NOOP("RoughnessPage", "&Histogram…"),
      QT_TRANSLATE_NOOP("RoughnessPage", "Writes the histogram of heights and the areal material "
                                         "ratio"),
      "histogram.csv"},
     {RoughnessPage::Table::Spectrum, "exportSpectrum",
      QT_TRANSLATE_NOOP("RoughnessPage", "&Power spectrum…"),
      QT_TRANSLATE_NOOP("RoughnessPage", "Writes the power spectral density over frequency"),
      "spectrum.csv"}}};

}  // namespace

RoughnessPage::RoughnessPage(QWidget* parent)
    : QWidget(parent)
    , readings_(new ReadingGrid(this, kReadingRows))
    , draw_(pageButton(tr("Draw rectangle"), "drawRectangle",
                       tr("A drag on the whole scan draws the rectangle, or moves it or its sides; "
                          "off, or Esc: a double click travels again"),
                       this))
    , whole_(pageButton(tr("Whole scan"), "wholeScan",
                        tr("Removes the rectangle: the roughness is that of the whole scan"), this))
    , smoothed_(newSmoothedBox("measureSmoothed", this))
    , kind_(newList("roughnessCurve", tr("Which curve of the heights is shown")))
    , export_(pageButton(tr("Export"), "exportRoughness",
                         tr("Writes numbers or curves to a table, in SI units"), this))
    , state_(captionLabel(QString(), this))
    , subject_(new QLabel(this))
    , plots_(new QStackedWidget(this))
    , histogram_(new RoughnessPlot(RoughnessPlot::Kind::Histogram, this))
    , spectrum_(new RoughnessPlot(RoughnessPlot::Kind::Spectrum, this)) {
    setToolTip(tr("Roughness (ISO 25178) of the scan or a rectangle"));
    draw_->setCheckable(true);
    addReadings();
    addExports();
    kind_->addItems({tr("Histogram"), tr("Power spectrum")});
    kind_->setAccessibleName(tr("Curve"));
    plots_->addWidget(histogram_);
    plots_->addWidget(spectrum_);
    state_->setObjectName(QStringLiteral("roughnessState"));
    state_->setToolTip(tr("Whether the roughness is being computed"));
    subject_->setObjectName(QStringLiteral("roughnessSubject"));
    subject_->setToolTip(tr("What the roughness is of: area, pixels with data, leveling, and "
                            "smoothing of what was measured"));
    subject_->setWordWrap(true);
    subject_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    subject_->setMinimumHeight(2 * subject_->fontMetrics().lineSpacing());
    subject_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* middle = new QHBoxLayout;
    middle->setSpacing(24);
    middle->addWidget(readings_);
    middle->addWidget(plots_, 1);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(6);
    column->addWidget(buildBar());
    column->addLayout(middle, 1);
    column->addWidget(subject_);
    connect(draw_, &QToolButton::toggled, this, &RoughnessPage::drawingChosen);
    connect(whole_, &QToolButton::clicked, this, &RoughnessPage::wholeChosen);
    connect(kind_, qOverload<int>(&QComboBox::currentIndexChanged), plots_,
            &QStackedWidget::setCurrentIndex);
    setRectangle(false);
    clear({});
}

QWidget* RoughnessPage::buildBar() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QWidget* const control : {static_cast<QWidget*>(draw_), static_cast<QWidget*>(whole_),
                                   static_cast<QWidget*>(smoothed_), static_cast<QWidget*>(kind_),
                                   static_cast<QWidget*>(export_)}) {
        row->addWidget(control);
    }
    row->addWidget(state_, 1);
    return bar;
}

void RoughnessPage::addExports() {
    auto* menu = new QMenu(export_);
    menu->setToolTipsVisible(true);
    for (const ExportTexts& texts : kExports) {
        QAction* const entry = menu->addAction(tr(texts.text));
        entry->setObjectName(QString::fromLatin1(texts.name));
        entry->setToolTip(tr(texts.tip));
        connect(entry, &QAction::triggered, this,
                [this, table = texts.table] { Q_EMIT exportChosen(table); });
    }
    export_->setMenu(menu);
    export_->setPopupMode(QToolButton::InstantPopup);
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
    const std::size_t all = static_cast<std::size_t>(subject.pixels.columns) *
                            static_cast<std::size_t>(subject.pixels.rows);
    QStringList parts;
    parts << (subject.isRectangle ? tr("Rectangle, %1 × %2") : tr("Whole scan, %1 × %2"))
                 .arg(roughnessLengthText(subject.width), roughnessLengthText(subject.height));
    parts << tr("%1 pixels; excluded: %2 without data")
                 .arg(countText(roughness.pixels), countText(all - roughness.pixels));
    parts << tr("Leveling: %1").arg(subject.leveling);
    parts << tr("Smoothing: %1").arg(subject.smoothing);
    if (!subject.calibration.isEmpty()) {
        parts << tr("Calibration: %1").arg(subject.calibration);
    }
    if (texture.step > 1) {
        parts << tr("Sal, Str: of one pixel in %1 a side").arg(texture.step);
    }
    subject_->setText(parts.join(QStringLiteral(" · ")));
    state_->clear();
    export_->setEnabled(true);
    showCurves(numbers);
}

void RoughnessPage::showCurves(const Numbers& numbers) {
    const HeightHistogram& histogram = numbers.histogram;
    QVector<QPointF> bins;
    for (std::size_t i = 0; i < histogram.counts.size(); ++i) {
        bins.append({histogram.middle(i), static_cast<double>(histogram.counts[i]) /
                                              static_cast<double>(numbers.roughness.pixels)});
    }
    histogram_->setPoints(bins);
    QVector<QPointF> rings;
    for (const SpectrumRing& ring : numbers.spectrum.rings) {
        rings.append({ring.frequency, ring.density});
    }
    spectrum_->setPoints(rings);
}

void RoughnessPage::clear(const QString& reason) {
    for (const char* const reading : kReadings) {
        readings_->set(reading, {});
    }
    subject_->clear();
    state_->setText(reason);
    export_->setEnabled(false);
    histogram_->setPoints({});
    spectrum_->setPoints({});
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
    , heights_(stage.get<MeasuredHeights>())
    , page_(new RoughnessPage(&host_.widget()))
    , work_({.progressed = [this](double share) { page_->setProgress(share); },
             .finished = [this](Result& result) { show(result); },
             .failed = [this](const std::exception_ptr& reason) { clear(reasonOf(reason)); }}) {
    addScanTool(page_, tr("Roughness"), 20, "roughness",
                {.text = tr("&Roughness"),
                 .tip = tr("Roughness (ISO 25178) of the scan or a rectangle"),
                 .shortcuts = {tr("Ctrl+U")}});
    bindTool(live_.overview().map(), rectangle_, *page_, &RoughnessPage::drawingChosen,
             &RoughnessPage::setDrawing);
    heights_.follow(page_->smoothed());
    for (const auto shown :
         {&RunControl::begun, &RunControl::recordingShown, &RunControl::liveShown}) {
        connect(&runs_, shown, this, [this] {
            if (runs_.isOnOtherScan()) {
                clear({});
                forget();
            } else {
                refresh();
            }
        });
    }
    runs_.beforeRecording([this]() -> std::function<void()> {
        return [this, rectangle = rectangle_.rectangle()] {
            rectangle_.setRectangle(rectangle);
            refresh();
        };
    });
    connect(&heights_, &MeasuredHeights::changed, this, &RoughnessControl::refresh);
    connect(&rectangle_, &RectangleTool::drawn, this, &RoughnessControl::refresh);
    connect(page_, &RoughnessPage::wholeChosen, this, &RoughnessControl::forget);
    connect(page_, &RoughnessPage::exportChosen, this, &RoughnessControl::askForFile);
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

RoughnessControl::Result RoughnessControl::measure(std::shared_ptr<const MeasuredScan> scan,
                                                   const QRectF& rectangle, Progress& progress) {
    const HeightRows rows = scan->rows();
    const PixelRectangle pixels = rectangle.isEmpty()
                                      ? allPixels(rows)
                                      : pixelsBetween(rows, {rectangle.left(), rectangle.top()},
                                                      {rectangle.right(), rectangle.bottom()});
    Result result{.scan = scan,
                  .subject = {.width = pixels.columns * rows.pitchX,
                              .height = pixels.rows * rows.pitchY,
                              .pixels = pixels,
                              .isRectangle = !rectangle.isEmpty(),
                              .leveling = scan->leveling(),
                              .smoothing = scan->smoothing(),
                              .calibration = scan->calibration()},
                  .numbers = {}};
    ProgressPart first(&progress, 0.0, 0.2);
    result.numbers.roughness = roughnessOf(rows, pixels, &first);
    ProgressPart second(&progress, 0.2, 0.3);
    result.numbers.histogram = histogramOf(rows, pixels, result.numbers.roughness, &second);
    ProgressPart third(&progress, 0.3, 0.8);
    result.numbers.texture = textureOf(rows, pixels, &third);
    ProgressPart fourth(&progress, 0.8, 1.0);
    result.numbers.spectrum = powerSpectrumOf(rows, pixels, &fourth);
    return result;
}

void RoughnessControl::refresh() {
    page_->setRectangle(!rectangle_.isEmpty());
    work_.cancel();
    due_ = !page_->isVisible();
    if (due_) {
        return;
    }
    const std::shared_ptr<const MeasuredScan> scan = heights_.scan();
    if (scan == nullptr) {
        clear(heights_.state());
        return;
    }
    page_->setProgress(0.0);
    work_.start([scan, rectangle = rectangle_.rectangle()](Progress& progress) {
        return measure(scan, rectangle, progress);
    });
}

void RoughnessControl::show(const Result& result) {
    result_ = result;
    page_->setResult(result.subject, result.numbers);
}

void RoughnessControl::clear(const QString& reason) {
    result_.reset();
    page_->clear(reason);
}

void RoughnessControl::askForFile(RoughnessPage::Table table) {
    if (result_) {
        askForTable(host_, tr("Export the roughness"),
                    QString::fromLatin1(kExports.at(static_cast<std::size_t>(table)).file),
                    [table, result = *result_](const std::filesystem::path& file) {
                        write(file, table, result);
                    });
    }
}

void RoughnessControl::writeTo(const std::filesystem::path& file, RoughnessPage::Table table) {
    writeTableTo(host_, file,
                 [&](const std::filesystem::path& path) { write(path, table, result_.value()); });
}

void RoughnessControl::write(const std::filesystem::path& file, RoughnessPage::Table table,
                             const Result& result) {
    const RoughnessPage::Numbers& numbers = result.numbers;
    const PixelRectangle& pixels = result.subject.pixels;
    const MeasuredScan& scan = *result.scan;
    const auto comments = [&](const char* what) {
        std::vector<std::string> lines = scan.provenance(what);
        lines.push_back("area: " + std::to_string(pixels.columns) + " x " +
                        std::to_string(pixels.rows) + " pixels from column " +
                        std::to_string(pixels.column) + ", row " + std::to_string(pixels.row));
        return lines;
    };
    if (table == RoughnessPage::Table::Histogram) {
        writeHistogram(file, comments("histogram of heights"), numbers.histogram);
    } else if (table == RoughnessPage::Table::Spectrum) {
        writeSpectrum(file, comments("power spectrum"), numbers.spectrum);
    } else {
        RoughnessTable row(file, comments("roughness (ISO 25178-2)"));
        row.add(scan.file(), {.channel = scan.channel(),
                              .columns = pixels.columns,
                              .rows = pixels.rows,
                              .sizeX = result.subject.width,
                              .sizeY = result.subject.height,
                              .rectangle = pixels,
                              .roughness = numbers.roughness,
                              .texture = numbers.texture});
        row.close();
    }
}

}  // namespace asperity
