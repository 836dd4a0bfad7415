#include "app/window/live/ForcePanel.h"

#include "app/window/live/CyclePanel.h"
#include "app/window/live/CycleTable.h"
#include "core/Units.h"
#include "core/scene/Scene.h"
#include "ui/plot/PlotNavigation.h"
#include "ui/widgets/LabStyle.h"
#include "ui/widgets/ReadingBudget.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QGridLayout>
#include <QHelpEvent>
#include <QStackedLayout>
#include <QTabBar>
#include <QToolButton>
#include <QToolTip>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinForce = 10e-12;      ///< numbers below are shown in its prefix [N]
constexpr double kMinShownLength = 1e-9;  ///< lengths are in nm or larger units [m]
constexpr int kGroupDistance = 7;         ///< between groups of numbers [px]

const std::array<QString, 3> kAxes = {QStringLiteral("X"), QStringLiteral("Y"),
                                      QStringLiteral("Z")};

CurvePlotSetup forceSetup() {
    return {.title = ForcePanel::tr("Force on the tip"),
            .unit = QStringLiteral("N"),
            .smallest = 0.2e-9,
            .curves = {{QStringLiteral("Fx"), &ThemeColors::blue},
                       {QStringLiteral("Fy"), &ThemeColors::orange},
                       {QStringLiteral("Fz"), &ThemeColors::green}}};
}

CurvePlotSetup heightSetup() {
    return {.title = ForcePanel::tr("Height z of the tip"),
            .unit = QStringLiteral("m"),
            .smallest = 0.2e-9,
            .curves = {{QStringLiteral("z"), &ThemeColors::ink}},
            .zero = ZeroLine::None,
            .timeLabels = TimeLabels::Shown};
}

/// A standard deviation beside its value, whose unit it has; never "0" where it is not.
QString sigmaText(double sigma, const SiScale& scale) {
    const QString digits = threeDigits(sigma, {scale.factor, ""}).trimmed();
    const bool isBelowDigits = sigma > 0.0 && digits == QStringLiteral("0");
    return isBelowDigits ? QStringLiteral("< 0.01") : QStringLiteral("± ") + digits;
}

QString positionText(double value, const SiScale& scale, int decimals) {
    return QString::fromStdString(scaledText(value, scale, decimals));
}

/// What the distance between tip and surface is called in a state, and its value [m].
struct NamedDistance {
    QString name;
    double value = 0.0;
};

/// Adhesion may hold a tip in contact above the undeformed surface, which it has pulled up.
NamedDistance distanceOf(const ContactState& contact) {
    if (contact.region() != TipRegion::Contact) {
        return {ForcePanel::tr("gap"), -contact.indentation};
    }
    return contact.indentation < 0.0
               ? NamedDistance{ForcePanel::tr("neck height"), -contact.indentation}
               : NamedDistance{ForcePanel::tr("indentation"), contact.indentation};
}

/// Lengths in micrometers need more decimals: a tenth of a nanometer must show.
/// @param largest of the lengths shown [m]
int decimalsOf(double largest, const SiScale& scale) {
    const bool fine = scale.factor > 1e8;
    return fine ? 2 : std::abs(largest * scale.factor) < 100.0 ? 4 : 3;
}

}  // namespace

ForcePanel::ForcePanel(QWidget* parent)
    : Card(tr("Force and position"), parent)
    , forceScale_("N", kMinForce)
    , positionScale_("m", kMinShownLength)
    , heightScale_("m", kMinShownLength)
    , distanceScale_("m", kMinShownLength)
    , radiusScale_("m", kMinShownLength)
    , forcePlot_(new CurvePlot(forceSetup(), this))
    , heightPlot_(new CurvePlot(heightSetup(), this))
    , cycles_(new CyclePanel(this))
    , tabs_(new QTabBar(this))
    , pause_(new QToolButton(this)) {
    buildNumbers();
    buildCurves();
    clear();
}

void ForcePanel::buildNumbers() {
    auto* grid = new QGridLayout;
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setHorizontalSpacing(4);
    grid->setVerticalSpacing(1);
    buildForces(*grid);
    buildPosition(*grid);
    buildContact(*grid);
    for (const int gapColumn : {3, 6}) {
        grid->setColumnMinimumWidth(gapColumn, kGroupDistance);
        grid->setColumnStretch(gapColumn, 1);
    }
    body().addLayout(grid);
}

/// One of two pages, chosen in the heading: no height is lost to tabs.
void ForcePanel::buildCurves() {
    forcePlot_->setObjectName(QStringLiteral("forcePlot"));
    forcePlot_->setToolTip(
        tr("Estimated force on the tip over the last 10 s; z points out of the sample") +
        QLatin1Char('\n') + PlotNavigation::help());
    heightPlot_->setObjectName(QStringLiteral("heightPlot"));
    heightPlot_->setToolTip(tr("Height z of the tip's apex in the scan over the last 10 s") +
                            QLatin1Char('\n') + PlotNavigation::help());
    auto* overTime = new QWidget(this);
    auto* column = new QVBoxLayout(overTime);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(body().spacing());
    column->addWidget(forcePlot_, 5);
    column->addWidget(heightPlot_, 4);
    auto* pages = new QStackedLayout;
    pages->addWidget(cycles_);
    pages->addWidget(overTime);
    tabs_->setObjectName(QStringLiteral("curveTabs"));
    tabs_->addTab(tr("vs. distance"));
    tabs_->addTab(tr("vs. time"));
    tabs_->setTabToolTip(0, tr("Force–distance curves of the last approaches and retracts"));
    tabs_->setTabToolTip(1, tr("Force and height of the tip over the last 10 s") +
                                QLatin1Char('\n') + PlotNavigation::help());
    tabs_->setFont(theme::textFont(theme::kSmallSize));
    tabs_->setDrawBase(false);
    tabs_->setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    connect(tabs_, &QTabBar::currentChanged, pages, &QStackedLayout::setCurrentIndex);
    addToHeading(tabs_);
    pause_->setObjectName(QStringLiteral("pausePlots"));
    pause_->setText(tr("Pause"));
    pause_->setProperty("compact", true);
    theme::follow(pause_, [this] { pause_->setIcon(controlIcon(ControlIcon::PauseCurves)); });
    pause_->setCheckable(true);
    pause_->setFont(theme::textFont(theme::kSmallSize));
    pause_->setFocusPolicy(Qt::TabFocus);
    pause_->setToolTip(tr("Freezes the curves while the loop continues. Off: they jump to now"));
    connect(pause_, &QToolButton::toggled, this, &ForcePanel::setPaused);
    addToHeading(pause_);
    body().addLayout(pages, 1);
}

void ForcePanel::setPaused(bool paused) {
    pause_->setChecked(paused);
    forcePlot_->setPaused(paused);
    heightPlot_->setPaused(paused);
    cycles_->setPaused(paused);
}

void ForcePanel::buildForces(QGridLayout& grid) {
    const std::array<QColor ThemeColors::*, 3> colors = {&ThemeColors::blue, &ThemeColors::orange,
                                                         &ThemeColors::green};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int row = static_cast<int>(axis);
        auto* name = new QLabel(this);
        name->setFont(theme::boldFont());
        theme::follow(name, [name, axis, color = colors.at(axis)] {
            name->setText(QStringLiteral("<span style='color:%1'>▌</span>F%2")
                              .arg((theme::colors().*color).name(), kAxes.at(axis).toLower()));
        });
        const QString objectName = QStringLiteral("force") + kAxes.at(axis);
        force_.at(axis) = valueLabel(objectName, QStringLiteral("-88.88 µN"), this);
        sigma_.at(axis) =
            valueLabel(objectName + QStringLiteral("Sigma"), QStringLiteral("± 88.88"), this);
        const QString meaning =
            tr("Estimate from the two lever signals, mean of a tenth of a second, ± one standard "
               "deviation of a single tick, by noise, model and calibration together");
        for (QLabel* const label : {name, force_.at(axis), sigma_.at(axis)}) {
            label->setToolTip(meaning);
            explain(*label, [this, axis] {
                return forceDetails(QStringLiteral("F") + kAxes.at(axis).toLower(),
                                    Vector3::Unit(static_cast<int>(axis)));
            });
        }
        grid.addWidget(name, row, 0);
        grid.addWidget(force_.at(axis), row, 1);
        grid.addWidget(sigma_.at(axis), row, 2);
    }
    magnitude_ = valueLabel(QStringLiteral("forceMagnitude"), QStringLiteral("-88.88 µN"), this);
    auto* caption = captionLabel(QStringLiteral("|F|"), this);
    for (QLabel* const label : {caption, magnitude_}) {
        label->setToolTip(tr("Magnitude of the estimated force on the tip"));
        explain(*label, [this] {
            return forceDetails(QStringLiteral("|F|"), shown_->estimate.force.stableNormalized());
        });
    }
    grid.addWidget(caption, 3, 0);
    grid.addWidget(magnitude_, 3, 1);
}

void ForcePanel::buildPosition(QGridLayout& grid) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int row = static_cast<int>(axis);
        tip_.at(axis) =
            valueLabel(QStringLiteral("tip") + kAxes.at(axis), QStringLiteral("-88.8888 µm"), this);
        auto* caption = captionLabel(kAxes.at(axis).toLower(), this);
        for (QLabel* const label : {caption, tip_.at(axis)}) {
            label->setToolTip(
                tr("Position of the tip's apex in the scan: x to the right, y up from "
                   "the lower left corner, z out of the sample"));
        }
        grid.addWidget(caption, row, 4);
        grid.addWidget(tip_.at(axis), row, 5);
    }
}

void ForcePanel::buildContact(QGridLayout& grid) {
    distanceName_ = captionLabel(tr("gap"), this);
    distanceName_->setObjectName(QStringLiteral("distanceName"));
    distanceName_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    distanceName_->setMinimumWidth(
        distanceName_->fontMetrics().horizontalAdvance(tr("contact radius")));
    distance_ = valueLabel(QStringLiteral("distance"), QStringLiteral("-88.88 µm"), this);
    contactRadius_ = valueLabel(QStringLiteral("contactRadius"), QStringLiteral("-88.88 µm"), this);
    const QString meaning =
        tr("From the tip to the undeformed surface: gap before contact, indentation in contact, "
           "neck height where adhesion pulls the surface up");
    for (QLabel* const label : {distanceName_, distance_}) {
        label->setToolTip(meaning);
        explain(*label, [this] { return contactText(); });
    }
    grid.addWidget(distanceName_, 0, 7, Qt::AlignRight);
    grid.addWidget(distance_, 1, 7, Qt::AlignRight);
    auto* caption = captionLabel(tr("contact radius"), this);
    for (QLabel* const label : {caption, contactRadius_}) {
        label->setToolTip(tr("Radius of the circle in which tip and sample touch, as the contact "
                             "law has it"));
        explain(*label, [this] { return contactText(); });
    }
    grid.addWidget(caption, 2, 7, Qt::AlignRight);
    grid.addWidget(contactRadius_, 3, 7, Qt::AlignRight);
}

/// @param text in front of the label's tool tip
void ForcePanel::explain(QLabel& label, std::function<QString()> text) {
    label.installEventFilter(this);
    details_.emplace_back(&label, std::move(text));
}

QString ForcePanel::details(const QLabel* label) const {
    const auto found = std::find_if(details_.begin(), details_.end(),
                                    [&](const auto& one) { return one.first == label; });
    const QString text = found == details_.end() || !shown_ ? QString() : found->second();
    return text.isEmpty() ? text : text + QLatin1Char('\n') + label->toolTip();
}

bool ForcePanel::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ToolTip) {
        auto* const label = qobject_cast<QLabel*>(watched);
        const QString text = details(label);
        if (!text.isEmpty()) {
            QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text, label);
            return true;
        }
    }
    return Card::eventFilter(watched, event);
}

QString ForcePanel::forceDetails(const QString& name, const Vector3& way) const {
    const ForceEstimate& estimate = shown_->estimate;
    const double sigma = std::sqrt(std::max(0.0, way.dot(estimate.covariance * way)));
    return namedBudget(name, shownForce(scene_, estimate.force.dot(way), sigma), "N");
}

QString ForcePanel::contactText() const {
    return scene_ != nullptr ? contactDetails(*scene_, *shown_) : QString();
}

QString ForcePanel::magnitude() const { return magnitude_->text(); }

void ForcePanel::take(const TickSample& sample) noexcept {
    const Vector3& force = sample.output.estimate.force;
    forcePlot_->take(sample.time, {force.x(), force.y(), force.z()});
    heightPlot_->take(sample.time, {sample.output.tip.z()});
    cycles_->take(sample);
}

void ForcePanel::show(const Snapshot& snapshot) {
    const TickOutput& output = snapshot.sample.output;
    shown_ = output;
    showForces(output.estimate);
    showPosition(output.tip);
    showContact(output.model.contact);
    forcePlot_->refresh();
    heightPlot_->refresh();
    cycles_->refresh();
}

void ForcePanel::showForces(const ForceEstimate& estimate) {
    Vector3 sigma = estimate.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    for (int axis = 0; axis < 3; ++axis) {
        sigma[axis] = shownForce(scene_, estimate.force[axis], sigma[axis]).total();
    }
    const SiScale& scale = forceScale_.fit(std::max(estimate.force.norm(), sigma.maxCoeff()));
    for (int axis = 0; axis < 3; ++axis) {
        const auto index = static_cast<std::size_t>(axis);
        force_.at(index)->setText(threeDigits(estimate.force[axis], scale));
        sigma_.at(index)->setText(sigmaText(sigma[axis], scale));
    }
    magnitude_->setText(threeDigits(estimate.force.norm(), scale));
}

void ForcePanel::showPosition(const Vector3& tip) {
    const double largest = std::max(std::abs(tip.x()), std::abs(tip.y()));
    const SiScale& scale = positionScale_.fit(largest);
    const int decimals = decimalsOf(largest, scale);
    const SiScale& height = heightScale_.fit(tip.z());
    tip_[0]->setText(positionText(tip.x(), scale, decimals));
    tip_[1]->setText(positionText(tip.y(), scale, decimals));
    tip_[2]->setText(positionText(tip.z(), height, decimalsOf(tip.z(), height)));
}

void ForcePanel::showContact(const ContactState& contact) {
    const NamedDistance distance = distanceOf(contact);
    distanceName_->setText(distance.name);
    distance_->setText(threeDigits(distance.value, distanceScale_.fit(distance.value)));
    contactRadius_->setText(
        threeDigits(contact.contactRadius, radiusScale_.fit(contact.contactRadius)));
}

ShownNumbers ForcePanel::numbers(const Snapshot& snapshot) const {
    const TickOutput& output = snapshot.sample.output;
    const Vector3 sigma = output.estimate.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const QString newton = QStringLiteral("N");
    const QString meter = QStringLiteral("m");
    ShownNumbers numbers;
    for (int axis = 0; axis < 3; ++axis) {
        const Budget budget = shownForce(scene_, output.estimate.force[axis], sigma[axis]);
        numbers.push_back({QStringLiteral("F") + kAxes.at(static_cast<std::size_t>(axis)).toLower(),
                           budget.value, budget.noise, newton, budget.model()});
    }
    numbers.push_back({QStringLiteral("|F|"), output.estimate.force.norm(), {}, newton});
    for (int axis = 0; axis < 3; ++axis) {
        numbers.push_back({tr("tip %1").arg(kAxes.at(static_cast<std::size_t>(axis)).toLower()),
                           output.tip[axis],
                           {},
                           meter});
    }
    const NamedDistance distance = distanceOf(output.model.contact);
    numbers.push_back({distance.name, distance.value, {}, meter});
    numbers.push_back({tr("contact radius"), output.model.contact.contactRadius, {}, meter});
    const ShownNumbers ofCycles = cycles_->table().numbers();
    numbers.insert(numbers.end(), ofCycles.begin(), ofCycles.end());
    return numbers;
}

void ForcePanel::clearNumbers() {
    for (QLabel* label : {force_[0], force_[1], force_[2], magnitude_, tip_[0], tip_[1], tip_[2],
                          distance_, contactRadius_}) {
        label->setText(QStringLiteral("–"));
    }
    for (QLabel* label : sigma_) {
        label->clear();
    }
    distanceName_->setText(tr("gap"));
    forcePlot_->clear();
    heightPlot_->clear();
    shown_.reset();
}

void ForcePanel::clear() {
    clearNumbers();
    cycles_->end();
    scene_ = nullptr;
}

void ForcePanel::forgetCycles() { cycles_->clear(); }

std::function<void()> ForcePanel::keptCurves() {
    return [forces = forcePlot_->keptCurves(), heights = heightPlot_->keptCurves(),
            cycles = cycles_->keptCycles()] {
        forces();
        heights();
        cycles();
    };
}

void ForcePanel::rewind() {
    clearNumbers();
    cycles_->restart();
}

void ForcePanel::begin(const Scene& scene) {
    const std::string& name = scene.description.sample.material.name;
    scene_ = &scene;
    cycles_->begin(QString::fromStdString(name).replace('_', ' '), &scene);
}

}  // namespace asperity
