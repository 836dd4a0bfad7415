#include "ui/panels/FidelityPanel.h"

#include "core/words/ModelWords.h"
#include "ui/CoreWords.h"
#include "ui/NumberText.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/NumberBox.h"
#include "ui/panels/PercentText.h"
#include "ui/panels/RefusalLine.h"
#include "ui/panels/TradeOffChart.h"
#include "ui/panels/WheelGuard.h"

#include <QHBoxLayout>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kFidelityGap = 6;  ///< [px]
constexpr int kKeyWidth = 300;   ///< [px]

/// A card that is filled from outside.
class OpenCard : public Card {
public:
    using Card::body;
    using Card::Card;
};

/// Whether both reckon with the same force; a chart shows no other ways to decouple.
bool isSameTick(ForceModelOptions a, const ForceModelOptions& b) {
    a.decoupling = b.decoupling;
    return a == b;
}

TradeOffPoints pointsOf(const TradeOff& study) {
    TradeOffPoints shown{.points = {}, .forceScale = study.reference.forceScale};
    for (const TickResult& result : study.ticks) {
        shown.points.push_back({.time = result.median,
                                .error = result.forceErrorRms,
                                .name = coreWords(nameOf(result.options)),
                                .onFront = result.onFront});
    }
    return shown;
}

/// @param error of the force [N] @param scale of the force [N]
QString errorText(double error, double scale) {
    if (error < kNoticedShare * scale) {
        return FidelityPanel::tr("below %1 % of the force").arg(percentText(kNoticedShare));
    }
    return FidelityPanel::tr("%1 nN (%2 % of the force)")
        .arg(1e9 * error, 0, 'g', 2)
        .arg(percentText(error / scale));
}

}  // namespace

FidelityPanel::FidelityPanel(QWidget* parent)
    : QWidget(parent, Qt::Tool)
    , terms_(new TermTable(this))
    , summary_(new QLabel(this))
    , tolerance_(new NumberBox(this))
    , automatic_(new QPushButton(tr("All automatic"), this))
    , chart_(new TradeOffChart(this))
    , key_(new QLabel(this))
    , measure_(new QPushButton(this)) {
    setWindowTitle(tr("Fidelity"));
    summary_->setObjectName(QStringLiteral("fidelitySummary"));
    summary_->setWordWrap(true);
    tolerance_->setObjectName(QStringLiteral("tolerance"));
    automatic_->setObjectName(QStringLiteral("allAutomatic"));
    measure_->setObjectName(QStringLiteral("measure"));
    refuseMeasuring({});
    summary_->setToolTip(tr("Error and computing time of the model options that are in use"));
    chart_->setToolTip(tr("Median time of a tick and force error of each model option"));
    key_->setToolTip(tr("The numbered points: no other option is both faster and more accurate"));
    terms_->setToolTip(tr("Terms of the model: on or off, and what leaving one out changes"));
    key_->setObjectName(QStringLiteral("chartKey"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kFidelityGap, kFidelityGap, kFidelityGap, kFidelityGap);
    column->setSpacing(kFidelityGap);
    column->addWidget(termCard());
    column->addWidget(chartCard(), 1);
    connectInputs();
    setMeasuring(std::nullopt);
    showTradeOff(std::nullopt);
    theme::follow(this, [this] { key_->setText(keyText()); });
    resize(1080, 760);
}

QWidget* FidelityPanel::termCard() {
    auto* card = new OpenCard(tr("Terms of the model"), this);
    tolerance_->setRange(0.0, 100.0);
    tolerance_->setDecimals(2);
    tolerance_->setSuffix(tr(" %"));
    tolerance_->setToolTip(tr("Error of each force, work, stiffness and position, and of the "
                              "surface, that terms left out may cause"));
    guardFromWheel(*tolerance_);
    automatic_->setToolTip(
        tr("Law, terms, closest points and deformation as the scene requires within 5 %"));
    auto* row = new QHBoxLayout;
    row->addWidget(summary_, 1);
    row->addWidget(captionLabel(tr("Tolerance"), this));
    row->addWidget(tolerance_);
    row->addWidget(automatic_);
    card->body().addWidget(terms_);
    card->body().addLayout(row);
    auto* refusal = new RefusalLine(this);
    refusal->setMinimumHeight(refusal->fontMetrics().lineSpacing());
    refusal->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    card->body().addWidget(refusal);
    return card;
}

QWidget* FidelityPanel::chartCard() {
    auto* card = new OpenCard(tr("Model options: click a point to use it"), this);
    key_->setTextFormat(Qt::RichText);
    key_->setWordWrap(true);
    key_->setFixedWidth(theme::scaled(kKeyWidth));
    key_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    key_->setFont(theme::textFont(theme::kSmallSize));
    auto* side = new QVBoxLayout;
    side->addWidget(key_, 1);
    side->addWidget(measure_, 0, Qt::AlignRight);
    auto* row = new QHBoxLayout;
    row->setSpacing(2 * kFidelityGap);
    row->addWidget(chart_, 1);
    row->addLayout(side);
    card->body().addLayout(row, 1);
    return card;
}

void FidelityPanel::connectInputs() {
    connect(terms_, &TermTable::termChosen, this, &FidelityPanel::termChosen);
    connect(tolerance_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this](double percent) { Q_EMIT toleranceChosen(percent / 100.0); });
    connect(automatic_, &QPushButton::clicked, this, &FidelityPanel::automaticRequested);
    connect(measure_, &QPushButton::clicked, this, [this] {
        if (measuring_) {
            Q_EMIT stopRequested();
        } else {
            Q_EMIT measureRequested();
        }
    });
    connect(chart_, &TradeOffChart::picked, this, [this](int index) {
        const ForceModelOptions options = study_->ticks.at(static_cast<std::size_t>(index)).options;
        Q_EMIT optionsPicked(options);
    });
}

void FidelityPanel::showModel(const SceneNeeds& needs, const ModelChoices& choices) {
    terms_->show(needs, choices);
    const QSignalBlocker blocker(tolerance_);
    tolerance_->setValue(100.0 * needs.tolerance);
    summary_->setText(
        needs.pending ? tr("Finding out what this scene requires; until then the model has "
                           "everything.")
                      : tr("Model at a setpoint of %1: %2; a tick takes %3 µs instead of %4 µs.")
                            .arg(siText(needs.setpoint, "N"), coreWords(modelErrorText(needs)))
                            .arg(1e6 * needs.modelTick, 0, 'f', 2)
                            .arg(1e6 * needs.fullTick, 0, 'f', 2));
    now_ = ofForce(needs.model);
    showCurrent();
}

void FidelityPanel::showTradeOff(const std::optional<TradeOff>& study) {
    study_ = study;
    const QString hint =
        measuring_ ? tr("measuring…")
                   : tr("Measure the cost and force error of each contact law, solver and "
                        "closest-point search on this scene.");
    chart_->setPoints(study_ ? pointsOf(*study_) : TradeOffPoints{}, hint);
    showCurrent();
}

void FidelityPanel::refuseMeasuring(const QString& reason) {
    measure_->setEnabled(reason.isEmpty());
    measure_->setToolTip(reason.isEmpty()
                             ? tr("Measure time and force error of each model option on this scene")
                             : reason);
}

void FidelityPanel::setMeasuring(std::optional<double> fraction) {
    const bool changed = fraction.has_value() != measuring_.has_value();
    measuring_ = fraction;
    measure_->setText(fraction ? tr("Stop (%1 %)").arg(qRound(100.0 * *fraction)) : tr("Measure"));
    if (changed) {
        showTradeOff(study_);
    }
}

void FidelityPanel::showCurrent() {
    int current = -1;
    if (study_) {
        const auto found = std::ranges::find_if(
            study_->ticks, [this](const TickResult& r) { return isSameTick(r.options, now_); });
        if (found != study_->ticks.end()) {
            current = static_cast<int>(found - study_->ticks.begin());
        }
    }
    chart_->setCurrent(current);
    key_->setText(keyText());
}

/// What the numbers in the chart stand for, and the ring.
QString FidelityPanel::keyText() const {
    QString text = tr("<p><span style='color:%1'><b>◯</b></span> now: %2</p>")
                       .arg(theme::colors().orange.name(), coreWords(nameOf(now_)));
    if (!study_) {
        return text;
    }
    const TradeOffPoints shown = pointsOf(*study_);
    int number = 0;
    for (const int index : frontOf(shown.points)) {
        const TradeOffPoint& point = shown.points.at(static_cast<std::size_t>(index));
        text += tr("<p><span style='color:%1'><b>%2</b></span>&nbsp; %3<br>%4 µs, %5</p>")
                    .arg(theme::colors().accent.name())
                    .arg(++number)
                    .arg(point.name)
                    .arg(1e6 * point.time, 0, 'f', 2)
                    .arg(errorText(point.error, shown.forceScale));
    }
    return text;
}

}  // namespace asperity
