#include "app/window/curve/CurveFitPage.h"

#include "app/curves/FitScene.h"
#include "app/window/curve/CurveFitForm.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QSignalBlocker>
#include <QSpinBox>
#include <QSplitter>
#include <QTabWidget>
#include <QTableWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace asperity {

namespace {

constexpr QSize kRoomSize(1180, 700);  // [px]
constexpr int kLeftWidth = 470;        // [px]

/// What people call a value of fit.json.
struct ValueName {
    const char* key;
    const char* name;
};
constexpr std::array kValueNames{
    ValueName{"youngs_modulus_pa", "Young's modulus"},
    ValueName{"long_term_modulus_pa", "long-term modulus"},
    ValueName{"relaxing_modulus_pa", "relaxing modulus"},
    ValueName{"relaxation_time_s", "relaxation time"},
    ValueName{"youngs_modulus_sqrt_radius_pa_m05", "modulus × √radius"},
    ValueName{"e_star_pa", "reduced modulus"},
    ValueName{"work_of_adhesion_j_m2", "work of adhesion"},
    ValueName{"work_of_adhesion_approach_j_m2", "work on approach"},
    ValueName{"work_of_adhesion_ratio", "ratio of works"},
    ValueName{"work_of_adhesion_radius_n", "work × radius"},
    ValueName{"cohesive_range_m", "cohesive range"},
    ValueName{"pull_off_force_n", "pull-off force"},
    ValueName{"contact_point_m", "contact point"},
    ValueName{"baseline_force_n", "baseline"},
    ValueName{"baseline_slope_n_m", "tilt of the baseline"},
    ValueName{"drag_n_s", "drag C"},
    ValueName{"drag_offset_m", "drag offset"},
    ValueName{"invols_gain", "InvOLS over the file's"},
    ValueName{"stiffness_n_m", "spring constant"},
    ValueName{"tip_radius_m", "tip radius"},
    ValueName{"tip_angle_rad", "tip angle"},
    ValueName{"film_thickness_m", "film thickness"},
    ValueName{"poisson_ratio", "Poisson's ratio"}};

QString nameOfValue(const std::string& key) {
    const auto row = std::ranges::find(
        kValueNames, key, [](const ValueName& value) { return std::string(value.key); });
    if (row != kValueNames.end()) {
        return coreWords(row->name);
    }
    QString name = QString::fromStdString(key);
    return name.replace(QLatin1Char('_'), QLatin1Char(' '));
}

QString numberText(double number, const std::string& unit) {
    return QString::fromStdString(unit.empty() ? formatted("%.3g", number)
                                               : formatSi(number, unit.c_str()));
}

QString deviationText(double deviation, const std::string& unit) {
    return deviation > 0.0 && std::isfinite(deviation) ? numberText(deviation, unit)
                                                       : QStringLiteral("–");
}

/// @param stretched column that takes the room that is left
QTableWidget* newTable(const char* name, const QString& tip, const QStringList& titles,
                       int stretched) {
    auto* const table = named(new QTableWidget(0, titles.size()), name, tip);
    table->setHorizontalHeaderLabels(titles);
    table->verticalHeader()->hide();
    table->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setSectionResizeMode(stretched, QHeaderView::Stretch);
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->setShowGrid(false);
    table->setAlternatingRowColors(true);
    return table;
}

void addCells(QTableWidget& table, const QStringList& cells) {
    const int row = table.rowCount();
    table.insertRow(row);
    for (int column = 0; column < cells.size(); ++column) {
        auto* const item = new QTableWidgetItem(cells[column]);
        item->setToolTip(cells[column]);
        table.setItem(row, column, item);
    }
}

QVector<QPointF> pointsOf(const std::vector<double>& x, const std::vector<double>& y) {
    QVector<QPointF> points;
    points.reserve(static_cast<int>(x.size()));
    for (std::size_t i = 0; i < std::min(x.size(), y.size()); ++i) {
        points.append({x[i], y[i]});
    }
    return points;
}

/// Distance of the base to where tip and sample first touch [m].
std::vector<double> baseDistance(const CurveIdentification& found, const ComparedBranch& branch) {
    const IdentifiedValue* const contact = found.find("contact_point_m");
    std::vector<double> distance(branch.measured.base.size());
    for (std::size_t i = 0; i < distance.size(); ++i) {
        distance[i] = (contact != nullptr ? contact->value : 0.0) - branch.measured.base[i];
    }
    return distance;
}

std::vector<double> differenceOf(const std::vector<double>& one, const std::vector<double>& other) {
    std::vector<double> difference(std::min(one.size(), other.size()));
    for (std::size_t i = 0; i < difference.size(); ++i) {
        difference[i] = one[i] - other[i];
    }
    return difference;
}

/// Separation of a tip whose lever bends under these forces [m].
std::vector<double> separationOf(const std::vector<double>& distance,
                                 const std::vector<double>& force, double stiffness) {
    std::vector<double> separation(std::min(distance.size(), force.size()));
    for (std::size_t i = 0; i < separation.size(); ++i) {
        separation[i] = distance[i] + (force[i] / stiffness);
    }
    return separation;
}

AxisRange extentOf(const DrawnCycle& measured) {
    AxisRange range{std::numeric_limits<double>::infinity(),
                    -std::numeric_limits<double>::infinity()};
    for (const auto* points : {&measured.approach, &measured.retract}) {
        for (const QPointF& point : *points) {
            range = {std::min(range.low, point.x()), std::max(range.high, point.x())};
        }
    }
    return range.low < range.high ? range : AxisRange{-1e-9, 1e-9};
}

/// Where tip and sample act on each other: five times as wide as the indentation.
AxisRange nearContact(const DrawnCycle& measured) {
    constexpr double kFar = 4.0;
    const AxisRange all = extentOf(measured);
    return all.low < 0.0 ? AxisRange{1.1 * all.low, std::min(all.high, -kFar * all.low)} : all;
}

/// "approach fitted, retract predicted".
QString rolesOf(const CurveIdentification& found) {
    const auto role = [](bool isFitted) {
        return isFitted ? CurveFitPage::tr("fitted") : CurveFitPage::tr("predicted");
    };
    return CurveFitPage::tr("approach %1, retract %2")
        .arg(role(found.fitsApproach), role(found.fitsRetract));
}

}  // namespace

CurveFitPage::CurveFitPage(QWidget* parent)
    : QWidget(parent, Qt::Tool)
    , open_(newButton(tr("Open…"), "openCurves", tr("A file of measured force curves")))
    , columns_(
          newButton(tr("Columns…"), "curveColumns", tr("Say which column of a text table is what")))
    , file_(named(new QLabel(tr("No file")), "curveFile", tr("The open file")))
    , index_(newNumber("curveIndex", {}, 0, 0, tr("Which curve of the file")))
    , place_(named(new QLabel, "curvePlace", tr("Where the curve is in its file")))
    , form_(new CurveFitForm(this))
    , step_(newList("curveStep", tr("What is drawn: from the stored curve to its fit")))
    , plot_(new ForceDistancePlot(this))
    , verdict_(named(new QLabel, "curveVerdict", tr("How well curve and simulation agree")))
    , reasons_(named(new QLabel, "curveReasons",
                     tr("Reasons for the verdict, and what limits the values")))
    , values_(newTable(
          "curveValues",
          tr("Values, with their deviations by the noise of the curve and by the calibration of "
             "lever and tip"),
          {tr("Quantity"), tr("Value"), tr("± noise"), tr("± calibration"), tr("Source")}, 0))
    , steps_(newTable("curveSteps",
                      tr("Steps of the preparation, in their order, and what each one found"),
                      {tr("Step"), tr("Done"), tr("Found")}, 2))
    , save_(newButton(tr("Save…"), "saveFit",
                      tr("fit.json, tables, picture and scene into a folder")))
    , scene_(newButton(tr("Save and open as scene…"), "openFit",
                       tr("A flat sample as found, under the same tip and lever"))) {
    setObjectName(QStringLiteral("curveFitPage"));
    setWindowTitle(tr("Measured curves"));
    step_->addItems({tr("as stored"), tr("without baseline"), tr("over the separation"),
                     tr("residual of the simulation")});
    step_->setCurrentIndex(static_cast<int>(Step::Separation));
    addParts();
    connectParts();
    setFile({});
    resize(theme::scaled(kRoomSize.width()), theme::scaled(kRoomSize.height()));
}

QWidget* CurveFitPage::newFileRow() {
    auto* const row = new QWidget(this);
    auto* const line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    for (QWidget* const part : std::initializer_list<QWidget*>{open_, columns_, file_}) {
        line->addWidget(part, part == file_ ? 1 : 0);
    }
    file_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    line->addWidget(new QLabel(tr("Curve"), row));
    line->addWidget(index_);
    line->addWidget(place_);
    return row;
}

QWidget* CurveFitPage::newButtonRow() {
    auto* const row = new QWidget(this);
    auto* const line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->addWidget(save_);
    line->addWidget(scene_);
    line->addStretch(1);
    return row;
}

void CurveFitPage::addParts() {
    verdict_->setWordWrap(true);
    reasons_->setWordWrap(true);
    reasons_->setTextInteractionFlags(Qt::TextSelectableByMouse);
    plot_->setToolTip(tr("Force on the tip over its distance, positive: repulsive"));
    plot_->heading().addWidget(captionLabel(tr("measured in color, simulated in ink"), this));
    plot_->heading().addWidget(step_);
    auto* const tabs = new QTabWidget(this);
    tabs->addTab(values_, tr("Found"));
    tabs->addTab(steps_, tr("Steps"));
    auto* const left = new QWidget(this);
    auto* const column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(form_);
    column->addWidget(verdict_);
    column->addWidget(reasons_);
    column->addWidget(tabs, 1);
    column->addWidget(newButtonRow());
    auto* const sides = new QSplitter(this);
    sides->addWidget(left);
    sides->addWidget(plot_);
    sides->setStretchFactor(1, 1);
    sides->setSizes({theme::scaled(kLeftWidth), theme::scaled(kRoomSize.width() - kLeftWidth)});
    sides->setChildrenCollapsible(false);
    auto* const all = new QVBoxLayout(this);
    all->addWidget(newFileRow());
    all->addWidget(sides, 1);
}

void CurveFitPage::connectParts() {
    connect(open_, &QPushButton::clicked, this, &CurveFitPage::openChosen);
    connect(columns_, &QPushButton::clicked, this, &CurveFitPage::columnsChosen);
    connect(save_, &QPushButton::clicked, this, &CurveFitPage::saveChosen);
    connect(scene_, &QPushButton::clicked, this, &CurveFitPage::sceneChosen);
    connect(index_, qOverload<int>(&QSpinBox::valueChanged), this, &CurveFitPage::changed);
    connect(form_, &CurveFitForm::changed, this, &CurveFitPage::changed);
    connect(step_, qOverload<int>(&QComboBox::currentIndexChanged), this, [this] {
        plot_->forgetRange();
        draw();
    });
}

void CurveFitPage::setFile(const OpenedCurves& file) {
    grid_ = file.grid;
    file_->setText(file.count > 0 ? file.name : tr("No file"));
    file_->setToolTip(file.count > 0 ? file.name : tr("The open file"));
    const QSignalBlocker blocker(index_);
    index_->setRange(0, file.count > 0 ? static_cast<int>(file.count - 1) : 0);
    index_->setValue(0);
    index_->setEnabled(file.count > 1);
    index_->setKeyboardTracking(false);
    curve_.reset();
    plot_->forgetRange();
    setComplaint({});
    showPlace();
}

/// "of 256, column 3 and row 5 from below".
void CurveFitPage::showPlace() {
    QString text = index_->maximum() > 0 ? tr("of %1").arg(index_->maximum() + 1) : QString();
    if (curve_ && curve_->cell) {
        text += tr(", column %1, row %2 from below")
                    .arg(curve_->cell->column + 1)
                    .arg(curve_->cell->row + 1);
    }
    place_->setText(text);
}

std::size_t CurveFitPage::index() const { return static_cast<std::size_t>(index_->value()); }

void CurveFitPage::setWorking() {
    save_->setEnabled(false);
    scene_->setEnabled(false);
}

void CurveFitPage::setComplaint(const QString& reason) {
    curve_.reset();
    setWorking();
    verdict_->setText(QString());
    reasons_->setText(reason);
    fillValues();
    fillSteps();
    draw();
}

void CurveFitPage::setCurve(const FittedCurve& curve) {
    curve_ = curve;
    const CurveIdentification& found = curve.found;
    const bool isRefused = found.verdict == FitVerdict::Refused;
    const QString verdict = coreWords(nameOf(found.verdict));
    verdict_->setText(isRefused
                          ? QStringLiteral("<b>%1</b>").arg(verdict)
                          : QStringLiteral("<b>%1</b>: %2; %3")
                                .arg(verdict, QString::fromStdString(found.model).toHtmlEscaped(),
                                     rolesOf(found)));
    QStringList reasons;
    for (const std::string& reason : found.reasons) {
        reasons.append(QString::fromStdString(reason));
    }
    reasons_->setText(reasons.join(QLatin1Char('\n')));
    save_->setEnabled(true);
    const std::string noScene = refusalOfScene(curve);
    scene_->setEnabled(noScene.empty());
    scene_->setToolTip(noScene.empty() ? tr("A flat sample as found, under the same tip and lever")
                                       : QString::fromStdString(noScene));
    showPlace();
    fillValues();
    fillSteps();
    draw();
}

void CurveFitPage::fillValues() {
    values_->setRowCount(0);
    if (!curve_) {
        return;
    }
    for (const IdentifiedValue& value : curve_->found.parameters) {
        addCells(*values_, {nameOfValue(value.key), numberText(value.value, value.unit),
                            deviationText(value.std, value.unit),
                            deviationText(value.stdCalibration, value.unit),
                            coreWords(nameOf(value.source))});
    }
}

void CurveFitPage::fillSteps() {
    steps_->setRowCount(0);
    if (!curve_) {
        return;
    }
    for (const PreparationStep& step : curve_->found.steps) {
        QStringList found;
        for (const IdentifiedValue& value : step.values) {
            found.append(nameOfValue(value.key) + QLatin1Char(' ') +
                         numberText(value.value, value.unit));
        }
        if (!step.note.empty()) {
            found.append(QString::fromStdString(step.note));
        }
        addCells(*steps_, {nameOfValue(step.key), step.on ? tr("on") : tr("off"),
                           found.join(QStringLiteral(", "))});
    }
}

void CurveFitPage::draw() {
    if (!curve_ || curve_->found.verdict == FitVerdict::Refused) {
        plot_->setCycles({}, {-1e-9, 1e-9});
        return;
    }
    const CurveIdentification& found = curve_->found;
    const auto step = static_cast<Step>(step_->currentIndex());
    const IdentifiedValue* const lever = found.find("stiffness_n_m");
    const double stiffness = lever != nullptr ? lever->value : 1.0;
    DrawnCycle measured;
    DrawnMeasurement simulated{.name = tr("simulated"), .approach = {}, .retract = {}};
    const auto add = [&](const ComparedBranch& branch, QVector<QPointF>& color,
                         QVector<QPointF>& ink) {
        const std::vector<double> distance = baseDistance(found, branch);
        switch (step) {
        case Step::Stored:
            color = pointsOf(distance, branch.measured.force);
            break;
        case Step::Corrected:
            color = pointsOf(distance, branch.corrected);
            ink = pointsOf(distance, branch.forward);
            break;
        case Step::Separation:
            color = pointsOf(branch.separation, branch.corrected);
            ink = pointsOf(separationOf(distance, branch.forward, stiffness), branch.forward);
            break;
        case Step::Residual:
            color = pointsOf(distance, differenceOf(branch.corrected, branch.forward));
            break;
        }
    };
    add(found.approach, measured.approach, simulated.approach);
    add(found.retract, measured.retract, simulated.retract);
    plot_->setCycles({measured},
                     step == Step::Separation ? nearContact(measured) : extentOf(measured),
                     simulated.approach.isEmpty() ? DrawnMeasurement{} : simulated);
}

}  // namespace asperity
