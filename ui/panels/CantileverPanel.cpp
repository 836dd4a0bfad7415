#include "ui/panels/CantileverPanel.h"

#include "core/scene/Scene.h"
#include "ui/NumberText.h"
#include "ui/Theme.h"
#include "ui/panels/CantileverSketch.h"
#include "ui/panels/CopyablePlot.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinAngle = 1e-9;         ///< numbers below are shown in its prefix [rad]
constexpr double kMinDrawnLength = 1e-12;  ///< [m]
constexpr int kScaleIntervals = 100;       ///< of the histories that scale the drawing

CurvePlotSetup angleSetup() {
    return {.title = CantileverPanel::tr("Lever signals"),
            .unit = QStringLiteral("rad"),
            .smallest = 1e-6,
            .curves = {{CantileverPanel::tr("bending"), &ThemeColors::blue},
                       {CantileverPanel::tr("torsion"), &ThemeColors::orange}},
            .timeLabels = TimeLabels::Shown};
}

double largestOf(const CurveHistory& history) {
    const CurveExtent extent = history.extent();
    return std::max(std::abs(extent.low), std::abs(extent.high));
}

}  // namespace

CantileverPanel::CantileverPanel(QWidget* parent)
    : Card(tr("Cantilever"), parent)
    , deflections_(CurvePlot::kSpan, kScaleIntervals)
    , torsions_(CurvePlot::kSpan, kScaleIntervals)
    , angleScale_("rad", kMinAngle)
    , lengthScale_("m", kMinDrawnLength)
    , sketch_(new CantileverSketch(this))
    , plot_(new CurvePlot(angleSetup(), this)) {
    sketch_->setToolTip(tr("The cantilever from its side and from its free end, bent and twisted "
                           "by the estimated force, enlarged as stated; dashed: without force"));
    plot_->setToolTip(tr("Measured bending and torsion of the free end over the last 10 s"));
    buildNumbers();
    new CopyablePlot(*sketch_);
    body().addWidget(sketch_, 4);
    body().addWidget(plot_, 5);
    clear();
}

void CantileverPanel::buildNumbers() {
    const auto value = [this](const char* name, const char* widest) {
        return valueLabel(QString::fromUtf8(name), QString::fromUtf8(widest), this);
    };
    bending_ = value("bending", "-88.88 µrad");
    torsion_ = value("torsion", "-88.88 µrad");
    deflection_ = value("deflection", "-88.88 µm");
    lateral_ = value("lateral", "-88.88 µm");
    auto* grid = new QGridLayout;
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(1);
    struct Cell {
        QLabel* value;
        QString caption;
        QString meaning;
        int row;
        int column;
    };
    for (const Cell& cell :
         {Cell{bending_, tr("bending"), tr("Measured angle by which the free end is bent"), 0, 0},
          Cell{torsion_, tr("torsion"), tr("Measured angle by which the free end is twisted"), 1,
               0},
          Cell{deflection_, tr("deflection z"),
               tr("Displacement of the tip along z of the cantilever by the estimated force"), 0,
               3},
          Cell{lateral_, tr("sideways"),
               tr("Displacement of the tip across the cantilever by the estimated force"), 1, 3}}) {
        auto* caption = captionLabel(cell.caption, this);
        caption->setToolTip(cell.meaning);
        cell.value->setToolTip(cell.meaning);
        grid->addWidget(caption, cell.row, cell.column);
        grid->addWidget(cell.value, cell.row, cell.column + 1);
    }
    grid->setColumnStretch(2, 1);
    body().addLayout(grid);
}

void CantileverPanel::begin(const Scene& scene) { setCantilever(scene.belief.cantilever); }

void CantileverPanel::setCantilever(const Cantilever& cantilever) {
    cantilever_ = cantilever;
    sketch_->setCantilever(cantilever);
    setNote(siText(cantilever.stiffness(), "N/m") + tr(", length ") +
            siText(cantilever.geometry().length, "m"));
    clear();
}

void CantileverPanel::take(const TickSample& sample) noexcept {
    const LeverSignals& signals = sample.input.measurement.signals;
    plot_->take(sample.time, {signals.bending, signals.torsion});
    if (cantilever_) {
        const CantileverShape end = cantileverShape(*cantilever_, sample.output.estimate.force,
                                                    cantilever_->geometry().length);
        deflections_.add(sample.time, end.deflection);
        torsions_.add(sample.time, end.torsion);
    }
}

CantileverShape CantileverPanel::largestShape() const {
    return {.deflection = largestOf(deflections_), .torsion = largestOf(torsions_)};
}

void CantileverPanel::show(const Snapshot& snapshot) {
    const LeverSignals& signals = snapshot.sample.input.measurement.signals;
    const SiScale& angle =
        angleScale_.fit(std::max(std::abs(signals.bending), std::abs(signals.torsion)));
    bending_->setText(threeDigits(signals.bending, angle));
    torsion_->setText(threeDigits(signals.torsion, angle));
    if (cantilever_) {
        const Vector3 moved = tipDeflection(snapshot);
        const SiScale& length =
            lengthScale_.fit(std::max(std::abs(moved.y()), std::abs(moved.z())));
        deflection_->setText(threeDigits(moved.z(), length));
        lateral_->setText(threeDigits(moved.y(), length));
        sketch_->showForce(snapshot.sample.output.estimate.force, largestShape());
    }
    plot_->refresh();
}

Vector3 CantileverPanel::tipDeflection(const Snapshot& snapshot) const {
    const Vector3& force = snapshot.sample.output.estimate.force;
    return cantilever_->complianceInCantileverFrame() * (cantilever_->rotation() * force);
}

ShownNumbers CantileverPanel::numbers(const Snapshot& snapshot) const {
    const LeverSignals& signals = snapshot.sample.input.measurement.signals;
    const QString radian = QStringLiteral("rad");
    ShownNumbers numbers{{tr("bending"), signals.bending, {}, radian},
                         {tr("torsion"), signals.torsion, {}, radian}};
    if (cantilever_) {
        const Vector3 moved = tipDeflection(snapshot);
        numbers.push_back({tr("deflection z"), moved.z(), {}, QStringLiteral("m")});
        numbers.push_back({tr("deflection sideways"), moved.y(), {}, QStringLiteral("m")});
    }
    return numbers;
}

void CantileverPanel::clear() {
    for (QLabel* label : {bending_, torsion_, deflection_, lateral_}) {
        label->setText(QStringLiteral("–"));
    }
    deflections_.clear();
    torsions_.clear();
    sketch_->showForce(Vector3::Zero(), {});
    plot_->clear();
}

}  // namespace asperity
