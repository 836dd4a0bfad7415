#include "ui/panels/TermTable.h"

#include "core/words/ModelWords.h"
#include "ui/CoreWords.h"
#include "ui/Theme.h"
#include "ui/panels/PercentText.h"
#include "ui/panels/WheelGuard.h"

#include <QComboBox>
#include <QHeaderView>
#include <QStandardItemModel>

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

void TermTable::show(const SceneNeeds& needs, const ModelChoices& choices) {
    for (int row = 0; row < rowCount(); ++row) {
        const auto need = std::ranges::find(
            needs.terms, kModelTerms.at(static_cast<std::size_t>(row)), &TermNeed::term);
        const bool isKnown = need != needs.terms.end();
        const std::string why = isKnown ? whyOf(*need, needs) : "";
        showNeed(row, isKnown ? *need : TermNeed{}, why);
        showChoice(row, choices);
        setPossible(row, !isKnown || need->possible);
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

}  // namespace asperity
