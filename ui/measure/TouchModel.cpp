#include "ui/measure/TouchModel.h"

#include "core/words/BudgetWords.h"
#include "ui/Steady.h"

#include <optional>

namespace asperity {

namespace {

/// How a column is named, shown and explained.
struct ColumnTexts {
    const char* name;
    const char* meaning;
    double factor = 0.0;  ///< shown value = factor * SI value; 0: a text or a count
    const char* unit = "";
    int decimals = 0;  ///< 0: three significant digits
};

const std::array<ColumnTexts, TouchModel::ColumnCount> kTexts{{
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "no."),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "Number of the touch")},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "time"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "First contact, since the run began"), 1.0, "s", 3},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "x"),
     QT_TRANSLATE_NOOP("asperity::TouchModel",
                       "Tip at first contact, from the left edge of the scan"),
     1e6, "µm", 4},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "y"),
     QT_TRANSLATE_NOOP("asperity::TouchModel",
                       "Tip at first contact, from the lower edge of the scan"),
     1e6, "µm", 4},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "snap-in"),
     QT_TRANSLATE_NOOP("asperity::TouchModel",
                       "Strongest pull of the approach; none: no pull beyond the noise"),
     1e9, "nN"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "snap-in at"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "Gap of the undeflected tip at that pull"), 1e9,
     "nm"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "pull-off"),
     QT_TRANSLATE_NOOP("asperity::TouchModel",
                       "Strongest pull of the last retract, once the tip is off; none: no pull "
                       "beyond the noise"),
     1e9, "nN"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "work"),
     QT_TRANSLATE_NOOP("asperity::TouchModel",
                       "Work of adhesion: area between retract curve and zero force"),
     1e18, "aJ"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "stiffness"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "Of the contact, where unloading begins"), 1.0,
     "N/m"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "max. force"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "Largest repulsive force"), 1e9, "nN"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "max. indentation"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "Largest indentation of the undeformed surface"),
     1e9, "nm"},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "material"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "Sample material that the model assumes")},
    {QT_TRANSLATE_NOOP("asperity::TouchModel", "scan"),
     QT_TRANSLATE_NOOP("asperity::TouchModel", "File or shape that was touched")},
}};

const ColumnTexts& textsOf(int column) { return kTexts.at(static_cast<std::size_t>(column)); }

/// What of the cycle a column shows; null: it is no reading.
const CycleReading* readingIn(int column) {
    switch (column) {
    case TouchModel::SnapIn:
        return &cycleReading("snap_in_force_n");
    case TouchModel::SnapInDistance:
        return &cycleReading("snap_in_distance_m");
    case TouchModel::PullOff:
        return &cycleReading("pull_off_force_n");
    case TouchModel::Work:
        return &cycleReading("adhesion_work_j");
    case TouchModel::Stiffness:
        return &cycleReading("contact_stiffness_n_m");
    case TouchModel::MaxForce:
        return &cycleReading("max_force_n");
    case TouchModel::MaxIndentation:
        return &cycleReading("max_indentation_m");
    default:
        return nullptr;
    }
}

/// In its SI unit; none: the touch has no such value, or the column is a text.
std::optional<double> valueOf(const ContactCycle& cycle, int column) {
    switch (column) {
    case TouchModel::Time:
        return cycle.touchTime;
    case TouchModel::X:
        return cycle.place.x();
    case TouchModel::Y:
        return cycle.place.y();
    default:
        break;
    }
    const CycleReading* const shown = readingIn(column);
    const std::optional<Reading> reading = shown != nullptr ? shown->of(cycle) : std::nullopt;
    return reading ? std::optional(reading->value) : std::nullopt;
}

QString numberText(double value, const ColumnTexts& texts) {
    return texts.decimals > 0
               ? QString::number(texts.factor * value, 'f', texts.decimals)
               : QString::fromStdString(significantText(value, {texts.factor, ""})).trimmed();
}

QVariant shown(const Touch& touch, int row, int column) {
    if (column == TouchModel::Number) {
        return row + 1;
    }
    if (column >= TouchModel::Material) {
        return column == TouchModel::Material ? touch.material : touch.scan;
    }
    const std::optional<double> value = valueOf(touch.cycle, column);
    return value ? numberText(*value, textsOf(column)) : QStringLiteral("–");
}

QVariant sorted(const Touch& touch, int row, int column) {
    if (column == TouchModel::Number || column >= TouchModel::Material) {
        return shown(touch, row, column);
    }
    const std::optional<double> value = valueOf(touch.cycle, column);
    return value ? QVariant(*value) : QVariant();
}

/// With what is open in the value, and that it is not known where that is so.
QString toolTip(const Touch& touch, int column) {
    QString text = TouchModel::tr(textsOf(column).meaning);
    const CycleReading* const shown = readingIn(column);
    const std::optional<Reading> reading = shown != nullptr ? shown->of(touch.cycle) : std::nullopt;
    if (reading) {
        const Budget budget = budgetNamed(touch.budgets, shown->key)
                                  .value_or(budgetByNoise(reading->value, reading->sigma,
                                                          UnknownShares::NotComputed));
        text += QLatin1Char('\n') + QString::fromStdString(budgetText(budget, shown->unit()));
    }
    return text;
}

}  // namespace

void TouchModel::append(const Touch& touch) {
    const int row = rowCount();
    beginInsertRows({}, row, row);
    touches_.push_back(touch);
    endInsertRows();
}

void TouchModel::updateLast(const Touch& touch) {
    touches_.back() = touch;
    const int row = rowCount() - 1;
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
}

void TouchModel::clear() {
    beginResetModel();
    touches_.clear();
    endResetModel();
}

int TouchModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(touches_.size());
}

int TouchModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant TouchModel::data(const QModelIndex& index, int role) const {
    const Touch& touch = touches_.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
        return shown(touch, index.row(), index.column());
    case Qt::UserRole:
        return sorted(touch, index.row(), index.column());
    case Qt::ToolTipRole:
        return toolTip(touch, index.column());
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignVCenter |
                        (index.column() >= Material ? Qt::AlignLeft : Qt::AlignRight));
    default:
        return {};
    }
}

QVariant TouchModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) {
        return {};
    }
    const ColumnTexts& texts = textsOf(section);
    const QString unit = QString::fromUtf8(texts.unit);
    if (role == Qt::DisplayRole) {
        return unit.isEmpty() ? tr(texts.name)
                              : QStringLiteral("%1 [%2]").arg(tr(texts.name), unit);
    }
    return role == Qt::ToolTipRole ? QVariant(tr(texts.meaning)) : QVariant();
}

}  // namespace asperity
