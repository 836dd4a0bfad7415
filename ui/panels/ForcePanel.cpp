#include "ui/panels/ForcePanel.h"

#include "core/Units.h"
#include "ui/Theme.h"

#include <QGridLayout>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr double kMinForce = 10e-12;  ///< numbers below are shown in its prefix [N]
constexpr double kMinLength = 1e-9;   ///< lengths are in nm or larger units [m]
constexpr int kGroupDistance = 7;     ///< between groups of numbers [px]

const std::array<QString, 3> kAxes = {QStringLiteral("X"), QStringLiteral("Y"),
                                      QStringLiteral("Z")};

CurvePlotSetup forceSetup() {
    return {.title = QStringLiteral("Force on the tip"),
            .unit = QStringLiteral("N"),
            .smallest = 0.2e-9,
            .curves = {{QStringLiteral("Fx"), theme::kBlue},
                       {QStringLiteral("Fy"), theme::kOrange},
                       {QStringLiteral("Fz"), theme::kGreen}}};
}

CurvePlotSetup heightSetup() {
    return {.title = QStringLiteral("Height z of the tip"),
            .unit = QStringLiteral("m"),
            .smallest = 0.2e-9,
            .curves = {{QStringLiteral("z"), theme::kInk}},
            .zero = ZeroLine::None,
            .timeLabels = TimeLabels::Shown};
}

QString text(double value, const SiScale& scale) {
    return QString::fromStdString(threeDigitText(value, scale));
}

QString placeText(double value, const SiScale& scale, int decimals) {
    return QString::fromStdString(scaledText(value, scale, decimals));
}

/// Lengths in micrometers need more decimals: a tenth of a nanometer must show.
/// @param largest of the lengths shown [m]
int decimalsOf(double largest, const SiScale& scale) {
    const bool fine = scale.factor > 1e8;
    return fine ? 2 : std::abs(largest * scale.factor) < 100.0 ? 4 : 3;
}

}  // namespace

ForcePanel::ForcePanel(QWidget* parent)
    : Card(QStringLiteral("Force and position"), parent)
    , forceScale_("N", kMinForce)
    , placeScale_("m", kMinLength)
    , heightScale_("m", kMinLength)
    , gapScale_("m", kMinLength)
    , radiusScale_("m", kMinLength)
    , forcePlot_(new CurvePlot(forceSetup(), this))
    , heightPlot_(new CurvePlot(heightSetup(), this)) {
    setNote(QStringLiteral("estimate ± standard deviation"));
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
    forcePlot_->setObjectName(QStringLiteral("forcePlot"));
    heightPlot_->setObjectName(QStringLiteral("heightPlot"));
    body().addWidget(forcePlot_, 5);
    body().addWidget(heightPlot_, 4);
    clear();
}

void ForcePanel::buildForces(QGridLayout& grid) {
    const std::array<QRgb, 3> colors = {theme::kBlue, theme::kOrange, theme::kGreen};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int row = static_cast<int>(axis);
        auto* name = new QLabel(QStringLiteral("F") + kAxes.at(axis).toLower(), this);
        name->setFont(theme::boldFont());
        QPalette palette = name->palette();
        palette.setColor(QPalette::WindowText, colors.at(axis));
        name->setPalette(palette);
        const QString objectName = QStringLiteral("force") + kAxes.at(axis);
        force_.at(axis) = valueLabel(objectName, QStringLiteral("-88.88 µN"), this);
        sigma_.at(axis) =
            valueLabel(objectName + QStringLiteral("Sigma"), QStringLiteral("± 88.88"), this);
        grid.addWidget(name, row, 0);
        grid.addWidget(force_.at(axis), row, 1);
        grid.addWidget(sigma_.at(axis), row, 2);
    }
    magnitude_ = valueLabel(QStringLiteral("forceMagnitude"), QStringLiteral("-88.88 µN"), this);
    grid.addWidget(captionLabel(QStringLiteral("|F|"), this), 3, 0);
    grid.addWidget(magnitude_, 3, 1);
}

void ForcePanel::buildPosition(QGridLayout& grid) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const int row = static_cast<int>(axis);
        tip_.at(axis) =
            valueLabel(QStringLiteral("tip") + kAxes.at(axis), QStringLiteral("-88.8888 µm"), this);
        grid.addWidget(captionLabel(kAxes.at(axis).toLower(), this), row, 4);
        grid.addWidget(tip_.at(axis), row, 5);
    }
}

void ForcePanel::buildContact(QGridLayout& grid) {
    gap_ = valueLabel(QStringLiteral("gap"), QStringLiteral("-88.88 µm"), this);
    contactRadius_ = valueLabel(QStringLiteral("contactRadius"), QStringLiteral("-88.88 µm"), this);
    gap_->setToolTip(QStringLiteral("Between tip and surface; negative: indented"));
    grid.addWidget(captionLabel(QStringLiteral("gap"), this), 0, 7, Qt::AlignRight);
    grid.addWidget(gap_, 1, 7, Qt::AlignRight);
    grid.addWidget(captionLabel(QStringLiteral("contact radius"), this), 2, 7, Qt::AlignRight);
    grid.addWidget(contactRadius_, 3, 7, Qt::AlignRight);
}

void ForcePanel::take(const TickSample& sample) noexcept {
    const Vector3& force = sample.output.estimate.force;
    forcePlot_->take(sample.time, {force.x(), force.y(), force.z()});
    heightPlot_->take(sample.time, {sample.output.tip.z()});
}

void ForcePanel::show(const Snapshot& snapshot) {
    const TickOutput& output = snapshot.sample.output;
    showForces(output.estimate);
    showPosition(output.tip);
    showContact(output.model.contact);
    forcePlot_->refresh();
    heightPlot_->refresh();
}

void ForcePanel::showForces(const ForceEstimate& estimate) {
    const Vector3 sigma = estimate.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
    const SiScale& scale = forceScale_.fit(std::max(estimate.force.norm(), sigma.maxCoeff()));
    for (int axis = 0; axis < 3; ++axis) {
        const auto index = static_cast<std::size_t>(axis);
        force_.at(index)->setText(text(estimate.force[axis], scale));
        // Same prefix as the force: the unit need not stand twice.
        sigma_.at(index)->setText(QStringLiteral("± ") +
                                  text(sigma[axis], {scale.factor, ""}).trimmed());
    }
    magnitude_->setText(text(estimate.force.norm(), scale));
}

void ForcePanel::showPosition(const Vector3& tip) {
    const double largest = std::max(std::abs(tip.x()), std::abs(tip.y()));
    const SiScale& place = placeScale_.fit(largest);
    const int decimals = decimalsOf(largest, place);
    const SiScale& height = heightScale_.fit(tip.z());
    tip_[0]->setText(placeText(tip.x(), place, decimals));
    tip_[1]->setText(placeText(tip.y(), place, decimals));
    tip_[2]->setText(placeText(tip.z(), height, decimalsOf(tip.z(), height)));
}

void ForcePanel::showContact(const ContactState& contact) {
    const double gap = -contact.indentation;
    gap_->setText(text(gap, gapScale_.fit(gap)));
    contactRadius_->setText(text(contact.contactRadius, radiusScale_.fit(contact.contactRadius)));
}

void ForcePanel::clear() {
    for (QLabel* label : {force_[0], force_[1], force_[2], magnitude_, tip_[0], tip_[1], tip_[2],
                          gap_, contactRadius_}) {
        label->setText(QStringLiteral("–"));
    }
    for (QLabel* label : sigma_) {
        label->clear();
    }
    forcePlot_->clear();
    heightPlot_->clear();
}

}  // namespace asperity
