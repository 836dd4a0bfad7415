#include "app/window/fidelity/FidelityPanel.h"

#include "app/window/fidelity/TradeOffChart.h"
#include "core/words/ModelWords.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QStandardItemModel>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

enum Column : int { Term, Choice, Now, Effect, Time, Why, ColumnCount };
enum ChoiceItem : int { Auto, On, Off };

ChoiceItem itemOf(const std::optional<bool>& choice) {
    if (!choice) {
        return Auto;
    }
    return *choice ? On : Off;
}

std::optional<bool> choiceOf(int item) {
    return item == Auto ? std::nullopt : std::optional(item == On);
}

bool isMeasured(const TermNeed& need) { return need.effect != 0.0 || need.time != 0.0; }

/// "7.0 %, pull-off force".
QString effectText(const TermNeed& need) {
    if (!isMeasured(need)) {
        return QStringLiteral("–");
    }
    const QString number = percentText(need.effect);
    return isOfSurface(need.term)
               ? TermTable::tr("%1 % of the indentation").arg(number)
               : TermTable::tr("%1 %, %2").arg(number, coreWords(nameOf(need.quantity)));
}

QString termTimeText(const TermNeed& need) {
    if (!isMeasured(need)) {
        return QStringLiteral("–");
    }
    return isOfSurface(need.term) ? TermTable::tr("%1 ms a patch").arg(1e3 * need.time, 0, 'f', 2)
                                  : TermTable::tr("%1 µs a tick").arg(1e6 * need.time, 0, 'f', 2);
}

constexpr int kFidelityGap = 6;  ///< [px]
constexpr int kFidelityWidth = 1080;
constexpr int kFidelityHeight = 760;  ///< with all details [px]
constexpr int kKeyWidth = 300;        ///< [px]

/// A card that is filled from outside.
class OpenCard : public Card {
public:
    using Card::body;
    using Card::Card;
};

/// Returns whether both reckon with the same force; a chart shows no other ways to decouple.
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

/// Returns one sentence on the model in use: who chose its terms, what they omit, what it costs.
QString briefText(const RequiredTerms& needs, const ModelChoices& choices, double period) {
    if (needs.pending) {
        return FidelityPanel::tr("Finding out which terms this scene needs; until then the model "
                                 "has all of them.");
    }
    const QString how = choices == allAutomatic(choices) ? FidelityPanel::tr("All automatic")
                                                         : FidelityPanel::tr("Partly set by hand");
    const double error = needs.statedError();
    const QString worth =
        !needs.measured ? FidelityPanel::tr("what the omitted terms change is not measured")
        : error == 0.0  ? FidelityPanel::tr("no term that changes what you read is omitted")
                        : FidelityPanel::tr("omitted terms change what you read by at most %1 %")
                             .arg(percentText(error));
    return FidelityPanel::tr("%1: %2; a tick takes %3 of %4 µs.")
        .arg(how, worth)
        .arg(1e6 * needs.modelTick, 0, 'g', 2)
        .arg(1e6 * period, 0, 'f', 0);
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

TermTable::TermTable(QWidget* parent)
    : QTableWidget(static_cast<int>(kModelTerms.size()), ColumnCount, parent), choices_() {
    setHorizontalHeaderLabels(
        {tr("Term"), tr("Choice"), tr("Now"), tr("Effect if left out"), tr("Cost"), tr("Reason")});
    for (int row = 0; row < rowCount(); ++row) {
        addRow(row);
    }
    verticalHeader()->hide();
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    horizontalHeader()->setSectionResizeMode(Why, QHeaderView::Stretch);
    setEditTriggers(NoEditTriggers);
    setSelectionMode(NoSelection);
    setFocusPolicy(Qt::NoFocus);
    setShowGrid(false);
    setAlternatingRowColors(true);
    setWordWrap(true);
    theme::follow(this, [this] {
        for (int row = 0; row < rowCount(); ++row) {
            colorNow(row);
        }
    });
}

void TermTable::addRow(int row) {
    const ModelTerm term = kModelTerms.at(static_cast<std::size_t>(row));
    for (int column = 0; column < ColumnCount; ++column) {
        setItem(row, column, new QTableWidgetItem);
    }
    setText(row, Term, coreWords(nameOf(term)));
    auto* combo = new QComboBox(this);
    combo->setObjectName(QString::fromUtf8(nameOf(term)));
    combo->setEnabled(false);
    combo->setToolTip(
        tr("Whether %1 is in the model; auto: as the scene needs it").arg(coreWords(nameOf(term))));
    combo->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    guardFromWheel(*combo);
    // activated() comes from people only.
    connect(combo, qOverload<int>(&QComboBox::activated), this,
            [this, term](int item) { choose(term, item); });
    combo->addItems({tr("auto"), tr("on"), tr("off")});
    setCellWidget(row, Choice, combo);
    choices_.at(static_cast<std::size_t>(row)) = combo;
}

void TermTable::show(const RequiredTerms& needs, const ModelChoices& choices) {
    for (int row = 0; row < rowCount(); ++row) {
        const auto need = std::ranges::find(
            needs.terms, kModelTerms.at(static_cast<std::size_t>(row)), &TermNeed::term);
        const bool isKnown = need != needs.terms.end();
        const std::string why = isKnown ? whyOf(*need, needs) : "";
        showNeed(row, isKnown ? *need : TermNeed{}, why);
        showChoice(row, choices);
        setPossible(row, !isKnown || need->possible);
        // Few samples have them: elsewhere they would be so many lines that say nothing.
        setRowHidden(row,
                     isKnown && !need->possible &&
                         std::ranges::find(kMaterialTerms, need->term) != kMaterialTerms.end());
    }
    resizeColumnToContents(Choice);
    fitHeight();
}

void TermTable::showNeed(int row, const TermNeed& need, const std::string& reason) {
    setText(row, Now, need.on ? tr("on") : tr("off"));
    item(row, Now)->setData(Qt::UserRole, need.on);
    colorNow(row);
    setText(row, Effect, effectText(need));
    setText(row, Time, termTimeText(need));
    const QString why = coreWords(reason);
    setText(row, Why, why);
    item(row, Why)->setToolTip(why);
}

void TermTable::colorNow(int row) {
    const bool on = item(row, Now)->data(Qt::UserRole).toBool();
    item(row, Now)->setForeground(on ? theme::colors().ink : theme::colors().muted);
}

void TermTable::showChoice(int row, const ModelChoices& choices) {
    const auto index = static_cast<std::size_t>(row);
    QComboBox& combo = *choices_.at(index);
    lawIsGiven_ = choices.law.has_value();
    const bool byLaw = lawIsGiven_ && isOfLaw(kModelTerms.at(index));
    combo.setItemText(Auto, byLaw ? tr("set by the law") : tr("auto"));
    combo.setCurrentIndex(itemOf(asperity::choiceOf(kModelTerms.at(index), choices)));
    combo.setEnabled(true);
}

void TermTable::setPossible(int row, bool possible) {
    const auto index = static_cast<std::size_t>(row);
    auto& entries = dynamic_cast<QStandardItemModel&>(*choices_.at(index)->model());
    entries.item(On)->setEnabled(possible);
    entries.item(On)->setToolTip(possible ? QString()
                                          : coreWords(whyImpossible(kModelTerms.at(index))));
}

/// Taking again what the law says changes nothing.
void TermTable::choose(ModelTerm term, int item) {
    const bool byLaw = lawIsGiven_ && isOfLaw(term);
    if (!byLaw || item != Auto) {
        Q_EMIT termChosen(term, choiceOf(item));
    }
}

void TermTable::setText(int row, int column, const QString& text) {
    item(row, column)->setText(text);
}

void TermTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    fitHeight();
}

void TermTable::showEvent(QShowEvent* event) {
    QTableWidget::showEvent(event);
    fitHeight();
}

void TermTable::fitHeight() {
    if (!isVisible()) {
        return;  // nobody has said how wide it is
    }
    resizeRowsToContents();
    setFixedHeight(horizontalHeader()->height() + verticalHeader()->length() + 2 * frameWidth());
}

FidelityPanel::FidelityPanel(QWidget* parent)
    : QWidget(parent, Qt::Tool)
    , brief_(new QLabel(this))
    , details_(new QPushButton(tr("Details"), this))
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
    terms_->setToolTip(tr("Terms of the model: on or off, and the effect of omitting one"));
    key_->setObjectName(QStringLiteral("chartKey"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kFidelityGap, kFidelityGap, kFidelityGap, kFidelityGap);
    column->setSpacing(kFidelityGap);
    column->addWidget(briefLine());
    QWidget* const terms = termCard();
    QWidget* const chart = chartCard();
    column->addWidget(terms);
    column->addWidget(chart, 1);
    const auto showDetails = [this, terms, chart](bool shown) {
        terms->setVisible(shown);
        chart->setVisible(shown);
        resize(kFidelityWidth, shown ? kFidelityHeight : minimumSizeHint().height());
    };
    connect(details_, &QPushButton::toggled, this, showDetails);
    connectInputs();
    setMeasuring(std::nullopt);
    showTradeOff(std::nullopt);
    theme::follow(this, [this] { key_->setText(keyText()); });
    showDetails(false);
}

QWidget* FidelityPanel::briefLine() {
    brief_->setObjectName(QStringLiteral("fidelityBrief"));
    brief_->setWordWrap(true);
    brief_->setFont(theme::boldFont());
    brief_->setToolTip(
        tr("Whether the program chose the model, what it leaves out, and how much of "
           "its time a tick takes"));
    details_->setObjectName(QStringLiteral("fidelityDetails"));
    details_->setCheckable(true);
    details_->setToolTip(tr("Each term of the model, and the speed and accuracy of all options"));
    auto* line = new QWidget(this);
    auto* row = new QHBoxLayout(line);
    row->setContentsMargins(kFidelityGap, 0, 0, 0);
    row->addWidget(brief_, 1);
    row->addWidget(details_);
    return line;
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

void FidelityPanel::showModel(const RequiredTerms& needs, const ModelChoices& choices,
                              double period) {
    brief_->setText(briefText(needs, choices, period));
    terms_->show(needs, choices);
    const QSignalBlocker blocker(tolerance_);
    tolerance_->setValue(100.0 * needs.tolerance);
    summary_->setText(
        needs.pending ? tr("Determining the terms that this scene requires; until then the "
                           "model has all of them.")
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
