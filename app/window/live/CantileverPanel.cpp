#include "app/window/live/CantileverPanel.h"

#include "core/scene/Scene.h"
#include "ui/plot/CopyablePlot.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QGridLayout>
#include <QLocale>
#include <QPainter>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kSideShare = 0.66;        ///< of the width, for the side view
constexpr double kClampWidth = 14.0;       ///< [px]
constexpr double kMinBeamThickness = 3.0;  ///< [px]
constexpr double kMaxArrowLength = 26.0;   ///< [px]
constexpr double kArrowShare = 0.28;       ///< of the height, at most
constexpr double kDropShare = 0.55;        ///< of the height, for the resting beam and its tip
constexpr double kMinDeflection = 2e-10;   ///< noise below this stays small [m]
constexpr double kMinTorsion = 5e-7;       ///< [rad]
constexpr double kMaxShownTorsion = 0.4;   ///< [rad]
constexpr int kBeamPieces = 32;

double captionHeight() { return QFontMetricsF(theme::textFont(theme::kSmallSize)).height() + 1.0; }

/// From the cantilever's x, z to the drawing: turned by the mount tilt, free end down.
struct SideMap {
    QPointF origin;  ///< of the beam's axis at the clamp [px]
    double scale;    ///< [px/m]
    double sine;
    double cosine;

    [[nodiscard]] QPointF turned(double x, double z) const {
        return {(x * cosine) + (z * sine), (x * sine) - (z * cosine)};
    }
    [[nodiscard]] QPointF at(double x, double z) const { return origin + scale * turned(x, z); }
};

/// What the drawing of a bent beam is made of [px].
struct BeamDrawing {
    QPolygonF axis;
    QPolygonF tip;  ///< its base's corners, then its apex
};

/// The beam under a force (lab frame [N]), its deflection times `factor`.
BeamDrawing bentBeam(const Cantilever& cantilever, const Vector3& force, double factor,
                     const SideMap& map) {
    const CantileverGeometry& beam = cantilever.geometry();
    BeamDrawing drawing;
    for (int i = 0; i <= kBeamPieces; ++i) {
        const double x = beam.length * i / kBeamPieces;
        drawing.axis << map.at(x, factor * cantileverShape(cantilever, force, x).deflection);
    }
    const CantileverShape end = cantileverShape(cantilever, force, beam.length);
    const double slope = std::atan(factor * end.slope);
    // The tip stands on the free end and turns with it.
    const double half = 0.35 * beam.tipHeight;
    const QPointF along = half * map.scale * map.turned(std::cos(slope), std::sin(slope));
    const QPointF down = beam.tipHeight * map.scale * map.turned(std::sin(slope), -std::cos(slope));
    const QPointF root = drawing.axis.last() - along;
    drawing.tip << root - along << root + along << root + down;
    return drawing;
}

QString timesText(double factor) {
    return QStringLiteral(" ×") + QLocale(QLocale::English).toString(factor, 'f', 0);
}

void drawArrow(QPainter& painter, const QPointF& from, const QPointF& way) {
    const double length = std::hypot(way.x(), way.y());
    if (length < 3.0) {
        return;
    }
    const QPointF ahead = way / length;
    const QPointF aside(-ahead.y(), ahead.x());
    const QPointF head = from + way;
    const double headLength = std::min(8.0, length);
    painter.setPen(QPen(theme::colors().force, 2.0));
    painter.drawLine(from, head - ahead * headLength);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colors().force);
    const QPointF back = head - headLength * ahead;
    const QPointF half = 0.5 * headLength * aside;
    painter.drawPolygon(QPolygonF({head, back + half, back - half}));
}

/// Where an arrow begins, moved along it until its head is above `bottom` [px].
QPointF inSight(const QPointF& from, const QPointF& way, double bottom) {
    const double hidden = from.y() + way.y() - bottom;
    return hidden > 0.0 && way.y() > 0.0 ? from - (hidden / way.y()) * way : from;
}

void drawClamp(QPainter& painter, const QPointF& beamStart) {
    const QRectF block(beamStart.x() - kClampWidth, beamStart.y() - 14.0, kClampWidth, 28.0);
    painter.setPen(Qt::NoPen);
    painter.fillRect(block, theme::colors().faint);
    painter.fillRect(block, QBrush(theme::colors().muted, Qt::BDiagPattern));
    painter.setPen(QPen(theme::colors().muted, 1.5));
    painter.drawLine(block.topRight(), block.bottomRight());
}

QPen ghostPen() {
    QPen pen(theme::colors().muted, 1.0);
    pen.setDashPattern({4.0, 3.0});
    return pen;
}

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

CantileverSketch::CantileverSketch(QWidget* parent)
    : QWidget(parent), bendingFactor_(kMinDeflection), torsionFactor_(kMinTorsion) {
    setMinimumSize(200, 64);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void CantileverSketch::setCantilever(const Cantilever& cantilever) {
    cantilever_ = cantilever;
    showForce(Vector3::Zero(), {});
}

void CantileverSketch::showForce(const Vector3& force, const CantileverShape& largest) {
    force_ = force.allFinite() ? force : Vector3::Zero();
    largest_ = largest;
    fitFactors();
    update();
}

void CantileverSketch::resizeEvent(QResizeEvent* /*event*/) { fitFactors(); }

CantileverSketch::View CantileverSketch::sideView() const {
    const CantileverGeometry& beam = cantilever_->geometry();
    const QRectF box(0.0, captionHeight(), kSideShare * width(), height() - captionHeight());
    const double run = beam.length * std::cos(beam.mountTilt);
    const double drop = (beam.length * std::sin(std::abs(beam.mountTilt))) + beam.tipHeight;
    return {box,
            std::min((box.width() - kClampWidth - 22.0) / run, kDropShare * box.height() / drop)};
}

CantileverSketch::View CantileverSketch::endView() const {
    const CantileverGeometry& beam = cantilever_->geometry();
    const QRectF box(kSideShare * width(), captionHeight(), (1.0 - kSideShare) * width(),
                     height() - captionHeight());
    return {box, std::min(0.6 * box.width() / beam.width,
                          0.6 * box.height() / (beam.tipHeight + (2.0 * beam.thickness)))};
}

void CantileverSketch::fitFactors() {
    if (!cantilever_) {
        return;
    }
    const CantileverGeometry& beam = cantilever_->geometry();
    const View side = sideView();
    const double drop = (beam.length * std::sin(std::abs(beam.mountTilt))) + beam.tipHeight;
    const double room = std::max(6.0, ((side.box.height() - (drop * side.scale)) / 2.0) - 6.0);
    bendingFactor_.fit(largest_.deflection, room / side.scale);
    torsionFactor_.fit(largest_.torsion, kMaxShownTorsion);
}

void CantileverSketch::paintEvent(QPaintEvent* /*event*/) {
    if (!cantilever_) {
        return;
    }
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setFont(theme::textFont(theme::kSmallSize));
    drawSide(painter, sideView());
    drawEnd(painter, endView());
}

void CantileverSketch::drawSide(QPainter& painter, const View& view) const {
    const CantileverGeometry& beam = cantilever_->geometry();
    const double tilt = beam.mountTilt;
    const double drop = ((beam.length * std::sin(tilt)) + beam.tipHeight) * view.scale;
    const SideMap map{view.box.center() - QPointF((view.box.width() / 2.0) - kClampWidth, drop / 2),
                      view.scale, std::sin(tilt), std::cos(tilt)};
    painter.setPen(theme::colors().muted);
    painter.drawText(QRectF(0.0, 0.0, view.box.width(), captionHeight()), Qt::AlignLeft,
                     tr("from the side, bending") + timesText(bendingFactor()));

    const BeamDrawing resting = bentBeam(*cantilever_, Vector3::Zero(), 0.0, map);
    painter.setPen(ghostPen());
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(resting.axis);
    painter.drawPolyline(resting.tip);

    const BeamDrawing bent = bentBeam(*cantilever_, force_, bendingFactor(), map);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colors().tip.darker(125));
    painter.drawPolygon(bent.tip);
    painter.setPen(QPen(theme::colors().tip,
                        std::max(kMinBeamThickness, beam.thickness * view.scale), Qt::SolidLine,
                        Qt::FlatCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPolyline(bent.axis);
    drawClamp(painter, map.origin);
    const QPointF way = forceArrow(map.sine, map.cosine);
    drawArrow(painter, inSight(bent.tip.last(), way, view.box.bottom() - 1.0), way);
}

QPointF CantileverSketch::forceArrow(double sine, double cosine) const {
    const Vector3 local = cantilever_->rotation() * force_;
    const double size = std::hypot(local.x(), local.z());
    const double reference =
        cantilever_->stiffness() * std::max(std::abs(largest_.deflection), kMinDeflection);
    if (size <= 0.0) {
        return {};
    }
    const double longest = std::min(kMaxArrowLength, kArrowShare * height());
    const double length = longest * std::min(1.0, size / reference) / size;
    const SideMap turn{{}, length, sine, cosine};
    return turn.at(local.x(), local.z());
}

void CantileverSketch::drawEnd(QPainter& painter, const View& view) const {
    const CantileverGeometry& beam = cantilever_->geometry();
    painter.setPen(theme::colors().muted);
    painter.drawText(QRectF(view.box.left(), 0.0, view.box.width(), captionHeight()),
                     Qt::AlignHCenter, tr("torsion") + timesText(torsionFactor()));
    const double half = beam.width / 2.0 * view.scale;
    const double thick = std::max(kMinBeamThickness, beam.thickness * view.scale);
    const double height = beam.tipHeight * view.scale;
    const QRectF section(-half, -thick / 2.0, 2.0 * half, thick);
    const QPolygonF tip({{-0.35 * height, 0.0}, {0.35 * height, 0.0}, {0.0, height}});

    painter.save();
    painter.translate(view.box.center().x(), view.box.center().y() - (height / 2.0));
    painter.setPen(ghostPen());
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(section.adjusted(0.7, 0.7, -0.7, -0.7));  // hidden while nothing is twisted
    painter.drawPolyline(tip);
    const double torsion = cantileverShape(*cantilever_, force_, beam.length).torsion;
    // Seen from the free end with y to the right, a positive turn about x is anticlockwise.
    painter.rotate(-torsion * torsionFactor() * 180.0 / M_PI);
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme::colors().tip.darker(125));
    painter.drawPolygon(tip);
    painter.setBrush(theme::colors().tip);
    painter.drawRect(section);
    painter.restore();
}

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
