#include "app/window/live/CycleTable.h"

#include "core/words/BudgetWords.h"
#include "ui/plot/ForceDistancePlot.h"
#include "ui/widgets/ReadingBudget.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"

#include <QHelpEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace asperity {

namespace {

constexpr int kMinRows = 2;          ///< that show on the smallest screen: to compare
constexpr int kSwatch = 16;          ///< width of the two lines in a cycle's colors [px]
constexpr int kSwatchDistance = 4;   ///< to what follows [px]
constexpr double kFirstShare = 0.3;  ///< of the width: the material's column
const QString kNothing = QStringLiteral("–");

constexpr double kMinShown = 0.1;  ///< of a column's unit: below, a value has its own

const char* siUnitOf(CycleTable::Column column) {
    return column == CycleTable::PullOff ? "N" : column == CycleTable::Stiffness ? "N/m" : "J";
}

/// Of which no more is known than the noise.
QString withNoise(const std::optional<Reading>& reading, const char* unit) {
    return reading ? QString::fromStdString(budgetText(
                         budgetByNoise(reading->value, reading->sigma, UnknownShares::NotComputed),
                         unit))
                   : kNothing;
}

QString nameOf(int column) {
    switch (column) {
    case CycleTable::PullOff:
        return CycleTable::tr("pull-off");
    case CycleTable::Work:
        return CycleTable::tr("work");
    case CycleTable::Hysteresis:
        return CycleTable::tr("hysteresis");
    case CycleTable::Stiffness:
        return CycleTable::tr("stiffness");
    default:
        return {};
    }
}

/// The deviation of a reading by model and calibration.
std::optional<double> modelSigmaOf(const std::vector<CycleBudget>& budgets, std::string_view key) {
    const std::optional<Budget> budget = budgetNamed(budgets, key);
    return budget && budget->isModelKnown() ? std::optional(budget->modelAboutValue())
                                            : std::nullopt;
}

/// An open loop has no area, and one that could be nothing but noise is none.
std::optional<Reading> hysteresisOf(const ContactCycle& cycle) {
    const std::optional<Reading> area = cycle.closedHysteresis();
    return area && area->value > area->sigma ? area : std::nullopt;
}

QString explanation() {
    return CycleTable::tr("Pull-off: strongest pull of the retract branch, once the tip is off\n"
                          "Work: work of adhesion, area between the retract branch and zero force\n"
                          "Hysteresis: area between approach and retract\n"
                          "Stiffness: of the contact, where unloading begins\n"
                          "Over a row: the same with standard deviations, and what they come from\n"
                          "Click on a row: hide or show its curves");
}

}  // namespace

CycleTable::CycleTable(QWidget* parent) : QWidget(parent) {
    setFont(theme::textFont(theme::kSmallSize));
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);  // the plot has the rest
    setToolTip(explanation());
}

void CycleTable::setRows(const std::vector<CycleRow>& newestFirst) {
    const bool grows = rows_.size() != newestFirst.size();
    rows_ = newestFirst;
    if (grows) {
        updateGeometry();
    }
    update();
}

QString CycleTable::text(int row, Column column) const {
    const CycleRow& shown = rows_.at(static_cast<std::size_t>(row));
    if (column == Material) {
        return shown.material;
    }
    const std::optional<Reading> value = reading(shown.cycle, column);
    if (!value) {
        return kNothing;
    }
    const SiScale common = unitOf(column);
    const bool isSmall = std::abs(value->value) * common.factor < kMinShown;
    const SiScale scale = isSmall ? siScaleFor(value->value, siUnitOf(column)) : common;
    return QString::fromStdString(significantText(value->value, scale));
}

std::optional<Reading> CycleTable::reading(const ContactCycle& cycle, Column column) {
    switch (column) {
    case PullOff:
        return cycle.pullOffForce();
    case Work:
        return cycle.workOfAdhesion();
    case Hysteresis:
        return hysteresisOf(cycle);
    case Stiffness:
        return cycle.stiffness;
    default:
        return std::nullopt;
    }
}

std::vector<CycleBudget> CycleTable::budgets(int row) const {
    const std::optional<LandmarkBudgets> known = budgetsOf_ ? budgetsOf_(row) : std::nullopt;
    return known ? cycleBudgets(*known, rows_.at(static_cast<std::size_t>(row)).cycle)
                 : std::vector<CycleBudget>();
}

QString CycleTable::details(int row) const {
    const CycleRow& shown = rows_.at(static_cast<std::size_t>(row));
    const ContactCycle& cycle = shown.cycle;
    const std::vector<CycleBudget> budgets = this->budgets(row);
    const auto reading = [&](const char* key, const std::optional<Reading>& value,
                             const char* unit) {
        return budgetedReading(budgets, key, withNoise(value, unit));
    };
    const QString pull =
        cycle.complete() || !cycle.pullOff
            ? QString()
            : tr(" (strongest pull so far: %1)").arg(withNoise(cycle.pullOff, "N"));
    return tr("%1\nPull-off force: %2\nWork of adhesion: %3\nHysteresis: %4\nContact stiffness: "
              "%5\nMaximum force: %6\nMaximum indentation: %7")
        .arg(shown.material, reading("pull_off_force_n", cycle.pullOffForce(), "N") + pull,
             reading("adhesion_work_j", cycle.workOfAdhesion(), "J"),
             hysteresisOf(cycle) ? reading("hysteresis_j", hysteresisOf(cycle), "J") : kNothing,
             reading("contact_stiffness_n_m", cycle.stiffness, "N/m"),
             reading("max_force_n", cycle.maxForce, "N"),
             reading("max_indentation_m", cycle.maxIndentation, "m"));
}

ShownNumbers CycleTable::numbers() const {
    ShownNumbers numbers;
    for (int i = 0; i < rows(); ++i) {
        const CycleRow& row = rows_[static_cast<std::size_t>(i)];
        const ContactCycle& cycle = row.cycle;
        const std::vector<CycleBudget> budgets = this->budgets(i);
        const auto add = [&](Column column, const std::optional<Reading>& reading,
                             const QString& unit, const char* key) {
            if (reading) {
                numbers.push_back({QStringLiteral("%1: %2").arg(row.material, nameOf(column)),
                                   reading->value, reading->sigma, unit,
                                   modelSigmaOf(budgets, key)});
            }
        };
        add(PullOff, cycle.pullOffForce(), QStringLiteral("N"), "pull_off_force_n");
        add(Work, cycle.workOfAdhesion(), QStringLiteral("J"), "adhesion_work_j");
        add(Hysteresis, hysteresisOf(cycle), QStringLiteral("J"), "hysteresis_j");
        add(Stiffness, cycle.stiffness, QStringLiteral("N/m"), "contact_stiffness_n_m");
    }
    return numbers;
}

/// One for all rows, so that they compare at sight; both energies have the same.
SiScale CycleTable::unitOf(Column column) const {
    const bool isEnergy = column == Work || column == Hysteresis;
    double largest = 0.0;
    for (const CycleRow& row : rows_) {
        for (const Column other : {PullOff, Work, Hysteresis, Stiffness}) {
            const bool shares = isEnergy ? other == Work || other == Hysteresis : other == column;
            const std::optional<Reading> value = reading(row.cycle, other);
            largest = std::max(largest, shares && value ? std::abs(value->value) : 0.0);
        }
    }
    return siScaleFor(largest, siUnitOf(column));
}

int CycleTable::lineHeight() const { return fontMetrics().height(); }

QSize CycleTable::sizeHint() const { return {1, (1 + std::max(1, rows())) * lineHeight()}; }

QSize CycleTable::minimumSizeHint() const {
    return {1, (1 + std::clamp(rows(), 1, kMinRows)) * lineHeight()};
}

QRect CycleTable::cell(int line, int column) const {
    const int first = static_cast<int>(kFirstShare * width());
    const int other = (width() - first) / (ColumnCount - 1);
    return column == Material
               ? QRect(0, line * lineHeight(), first, lineHeight())
               : QRect(first + (column - 1) * other, line * lineHeight(), other, lineHeight());
}

void CycleTable::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setPen(theme::colors().muted);
    for (int column = Material + 1; column < ColumnCount; ++column) {
        painter.drawText(cell(0, column), Qt::AlignRight | Qt::AlignVCenter, nameOf(column));
    }
    for (int row = 0; row < rows() && (row + 2) * lineHeight() <= height(); ++row) {
        paintRow(painter, row);
    }
}

void CycleTable::paintRow(QPainter& painter, int row) const {
    const BranchColors colors = branchColors(row);
    QRect first = cell(row + 1, Material);
    const int middle = first.center().y();
    const bool hidden = rows_[static_cast<std::size_t>(row)].hidden;
    if (!hidden) {
        painter.fillRect(QRect(0, middle - 2, kSwatch, 2), colors.approach);
        painter.fillRect(QRect(0, middle + 1, kSwatch, 2), colors.retract);
    }
    first.setLeft(kSwatch + kSwatchDistance);
    painter.setPen(row == 0 && !hidden ? theme::colors().ink : theme::colors().muted);
    painter.drawText(first, Qt::AlignLeft | Qt::AlignVCenter,
                     fontMetrics().elidedText(text(row, Material), Qt::ElideRight, first.width()));
    for (int column = Material + 1; column < ColumnCount; ++column) {
        painter.drawText(cell(row + 1, column), Qt::AlignRight | Qt::AlignVCenter,
                         text(row, static_cast<Column>(column)));
    }
}

bool CycleTable::event(QEvent* event) {
    if (event->type() != QEvent::ToolTip) {
        return QWidget::event(event);
    }
    const auto* const help = static_cast<QHelpEvent*>(event);
    const int row = rowAt(help->pos().y());
    QToolTip::showText(help->globalPos(), row >= 0 ? details(row) : toolTip(), this);
    return true;
}

int CycleTable::rowAt(int y) const {
    const int row = y / lineHeight() - 1;
    return row < rows() ? row : -1;
}

void CycleTable::mouseReleaseEvent(QMouseEvent* event) {
    const int row = rowAt(event->pos().y());
    if (event->button() == Qt::LeftButton && row >= 0) {
        Q_EMIT rowClicked(row);
    }
}

}  // namespace asperity
