#include "app/window/curve/MeasuredCurveControl.h"

#include "app/window/live/ForcePanel.h"
#include "app/window/live/LivePanels.h"
#include "core/io/curves/ForceCurveFile.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// Of the range of distances and forces: a point nearer to the last one is not drawn.
constexpr double kStep = 1.0 / 400.0;
constexpr double kShownWay = 0.4;  ///< of a contact's width: how much of the way to it is shown

struct Extent {
    double low = 0.0;
    double high = 0.0;

    void hold(const std::vector<double>& values) {
        for (const double value : values) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
    [[nodiscard]] double size() const { return high - low; }
};

QVector<QPointF> thinned(const std::vector<double>& distances, const std::vector<double>& forces,
                         double distanceStep, double forceStep) {
    QVector<QPointF> points;
    for (std::size_t i = 0; i < forces.size(); ++i) {
        const QPointF point(distances[i], forces[i]);
        if (points.isEmpty() || std::abs(point.x() - points.back().x()) >= distanceStep ||
            std::abs(point.y() - points.back().y()) >= forceStep) {
            points.append(point);
        }
    }
    return points;
}

QString detailsOf(const AlignedForceCurve& curve, const QString& name) {
    const auto text = [](double value, const char* unit) { return siText(value, unit); };
    return MeasuredCurveControl::tr(
               "%1\nBaseline taken off: %2 at the contact, tilt %3\nNoise about it: %4\n"
               "Lever: %5\nContact: where the approach last passes zero force")
        .arg(name, text(curve.baselineForce, "N"), text(curve.baselineSlope, "N/m"),
             text(curve.noise, "N"), text(curve.stiffness, "N/m"));
}

}  // namespace

MeasuredCurve drawnCurve(const AlignedForceCurve& curve, const QString& name) {
    Extent separations;
    Extent bases;
    Extent forces;
    for (const AlignedBranch* const branch : {&curve.approach, &curve.retract}) {
        separations.hold(branch->separation);
        bases.hold(branch->baseDistance);
        forces.hold(branch->force);
    }
    const double forceStep = std::max(kStep * forces.size(), curve.noise);
    const auto drawn = [&](const AlignedBranch& branch) {
        return MeasuredBranchPoints{
            thinned(branch.separation, branch.force, kStep * separations.size(), forceStep),
            thinned(branch.baseDistance, branch.force, kStep * bases.size(), forceStep)};
    };
    const double deepest = std::min(separations.low, bases.low);
    const double free = kShownWay * (curve.lastPull - deepest);
    return {name, detailsOf(curve, name), drawn(curve.approach), drawn(curve.retract),
            AxisRange{deepest, curve.lastPull + free}};
}

MeasuredCurveControl::MeasuredCurveControl(Stage& stage)
    : Feature(stage)
    , panel_(live_.forces().cycles())
    , work_({.progressed = [](double) {},
             .finished =
                 [this](MeasuredCurve& curve) {
                     panel_.setMeasured(curve);
                     host_.tell(tr("Measured curve: %1").arg(curve.name));
                     Q_EMIT loaded();
                 },
             .failed = complaintIn(host_)}) {
    connect(&panel_, &CyclePanel::measuredCurveWanted, this, &MeasuredCurveControl::ask);
    const QAction& entry =
        host_.menus().add({MenuName::Measure, 0, 70}, "drawCurve",
                          {.text = tr("Draw a measured &curve…"),
                           .tip = tr("A measured force–distance curve over those of the run"),
                           .shortcuts = {tr("Ctrl+D")}});
    connect(&entry, &QAction::triggered, this, &MeasuredCurveControl::ask);
}

void MeasuredCurveControl::ask() {
    if (runs_.run() == nullptr) {
        return;
    }
    const QString file =
        askWhatToOpen(&host_.widget(), {.kind = FileKind::Curve,
                                        .title = tr("Draw a measured force–distance curve"),
                                        .filters = tr("Force curves (*.jpk-force *.jpk-force-map "
                                                      "*.jpk-qi-data *.jpk-qi-series *.ibw *.spm "
                                                      "*.nid *.csv *.txt *.tsv *.dat *.zip);;"
                                                      "All files (*)")});
    if (!file.isEmpty()) {
        load(file.toStdString());
    }
}

void MeasuredCurveControl::load(const std::filesystem::path& file) {
    const double stiffness = 1.0 / runs_.scene().belief.cantilever.compliance()(2, 2);
    const QString name = shownPath(file.filename());
    work_.start([file, name, stiffness](Progress& /*progress*/) {
        return drawnCurve(alignedCurve(readForceCurve(file), stiffness), name);
    });
}

}  // namespace asperity
