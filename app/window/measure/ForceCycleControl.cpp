#include "app/window/measure/ForceCycleControl.h"

#include "app/reports/ForceCycleTable.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/measure/TableExport.h"
#include "core/Error.h"
#include "core/words/BudgetWords.h"
#include "core/words/SceneWords.h"
#include "ui/shell/Menus.h"
#include "ui/view/MapTool.h"
#include "ui/view/OverviewMap.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/PageParts.h"
#include "ui/widgets/Steady.h"
#include "ui/widgets/Theme.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QFileInfo>
#include <QFontMetricsF>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QPainter>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <optional>
#include <utility>

namespace asperity {

namespace {

constexpr double kDot = 3.0;          ///< radius [px]
constexpr double kSelectedDot = 5.0;  ///< [px]
/// More numbers than this would hide one another; the dots stay.
constexpr int kMaxNumbers = 150;

/// How a column is named, shown and explained.
struct ColumnTexts {
    const char* name;
    const char* meaning;
    double factor = 0.0;  ///< shown value = factor * SI value; 0: a text or a count
    const char* unit = "";
    int decimals = 0;  ///< 0: three significant digits
};

const std::array<ColumnTexts, ForceCycleModel::ColumnCount> kTexts{{
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "no."),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "Number of the force cycle")},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "time"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "First contact, since the run began"), 1.0, "s",
     3},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "x"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel",
                       "Tip at first contact, from the left edge of the scan"),
     1e6, "µm", 4},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "y"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel",
                       "Tip at first contact, from the lower edge of the scan"),
     1e6, "µm", 4},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "snap-in"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel",
                       "Strongest pull of the approach; none: no pull beyond the noise"),
     1e9, "nN"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "snap-in at"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "Gap of the undeflected tip at that pull"), 1e9,
     "nm"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "pull-off"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel",
                       "Strongest pull of the last retract, once the tip is off; none: no pull "
                       "beyond the noise"),
     1e9, "nN"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "work"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel",
                       "Work of adhesion: area between retract curve and zero force"),
     1e18, "aJ"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "stiffness"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "Of the contact, where unloading begins"), 1.0,
     "N/m"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "max. force"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "Largest repulsive force"), 1e9, "nN"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "max. indentation"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel",
                       "Largest indentation of the undeformed surface"),
     1e9, "nm"},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "material"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "Sample material that the model assumes")},
    {QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "scan"),
     QT_TRANSLATE_NOOP("asperity::ForceCycleModel", "File or shape that was touched")},
}};

const ColumnTexts& textsOf(int column) { return kTexts.at(static_cast<std::size_t>(column)); }

/// What of the cycle a column shows; null: it is no reading.
const CycleReading* readingIn(int column) {
    switch (column) {
    case ForceCycleModel::SnapIn:
        return &cycleReading("snap_in_force_n");
    case ForceCycleModel::SnapInDistance:
        return &cycleReading("snap_in_distance_m");
    case ForceCycleModel::PullOff:
        return &cycleReading("pull_off_force_n");
    case ForceCycleModel::Work:
        return &cycleReading("adhesion_work_j");
    case ForceCycleModel::Stiffness:
        return &cycleReading("contact_stiffness_n_m");
    case ForceCycleModel::MaxForce:
        return &cycleReading("max_force_n");
    case ForceCycleModel::MaxIndentation:
        return &cycleReading("max_indentation_m");
    default:
        return nullptr;
    }
}

/// In its SI unit; none: the cycle has no such value, or the column is a text.
std::optional<double> valueOf(const ContactCycle& cycle, int column) {
    switch (column) {
    case ForceCycleModel::Time:
        return cycle.touchTime;
    case ForceCycleModel::X:
        return cycle.position.x();
    case ForceCycleModel::Y:
        return cycle.position.y();
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

QVariant shown(const ForceCycle& entry, int row, int column) {
    if (column == ForceCycleModel::Number) {
        return row + 1;
    }
    if (column >= ForceCycleModel::Material) {
        return column == ForceCycleModel::Material ? entry.material : entry.scan;
    }
    const std::optional<double> value = valueOf(entry.cycle, column);
    return value ? numberText(*value, textsOf(column)) : QStringLiteral("–");
}

QVariant sorted(const ForceCycle& entry, int row, int column) {
    if (column == ForceCycleModel::Number || column >= ForceCycleModel::Material) {
        return shown(entry, row, column);
    }
    const std::optional<double> value = valueOf(entry.cycle, column);
    return value ? QVariant(*value) : QVariant();
}

/// With what is open in the value, and that it is not known where that is so.
QString toolTip(const ForceCycle& entry, int column) {
    QString text = ForceCycleModel::tr(textsOf(column).meaning);
    const CycleReading* const shown = readingIn(column);
    const std::optional<Reading> reading = shown != nullptr ? shown->of(entry.cycle) : std::nullopt;
    if (reading) {
        const Budget budget = budgetNamed(entry.budgets, shown->key)
                                  .value_or(budgetByNoise(reading->value, reading->sigma,
                                                          UnknownShares::NotComputed));
        text += QLatin1Char('\n') + QString::fromStdString(budgetText(budget, shown->unit()));
    }
    return text;
}

constexpr std::size_t kCycleRoom = 64;  ///< cycles between two frames
constexpr int kFramesPerUpdate = 8;     ///< of a cycle under way: five times a second

/// Rows sorted by value; those without one come last, upwards and downwards.
class RowsByValue : public QSortFilterProxyModel {
public:
    using QSortFilterProxyModel::QSortFilterProxyModel;

protected:
    bool lessThan(const QModelIndex& left, const QModelIndex& right) const override {
        const bool has = left.data(sortRole()).isValid();
        if (has != right.data(sortRole()).isValid()) {
            return has == (sortOrder() == Qt::AscendingOrder);
        }
        return QSortFilterProxyModel::lessThan(left, right);
    }
};

}  // namespace

void ForceCycleMarks::setForceCycles(const QVector<MarkedForceCycle>& cycles) {
    cycles_ = cycles;
    Q_EMIT marksChanged();
}

void ForceCycleMarks::setSelected(const QSet<int>& numbers) {
    selected_ = numbers;
    Q_EMIT marksChanged();
}

void ForceCycleMarks::setShown(bool shown) {
    shown_ = shown;
    Q_EMIT marksChanged();
}

void ForceCycleMarks::paint(QPainter& painter, const OverviewMap& map) const {
    if (!shown_) {
        return;
    }
    for (const MarkedForceCycle& cycle : cycles_) {
        if (!selected_.contains(cycle.number)) {
            paintOne(painter, map, cycle);
        }
    }
    for (const MarkedForceCycle& cycle : cycles_) {
        if (selected_.contains(cycle.number)) {
            paintOne(painter, map, cycle);
        }
    }
}

void ForceCycleMarks::paintOne(QPainter& painter, const OverviewMap& map,
                               const MarkedForceCycle& cycle) const {
    const bool selected = selected_.contains(cycle.number);
    const QPointF center = map.toPixel(cycle.position);
    const double radius = selected ? kSelectedDot : kDot;
    const Color& color = selected ? kLightPalette.force : kLightPalette.ink;
    painter.setPen(QPen(toQColor(kLightPalette.paper), 1.0));
    painter.setBrush(toQColor(color));
    painter.drawEllipse(center, radius, radius);
    if (selected || cycles_.size() <= kMaxNumbers) {
        // Between two arms of the tip's mark, which stays where the tip touched.
        const double below = QFontMetricsF(theme::textFont(theme::kSmallSize)).ascent();
        labelMark(painter, color, center + QPointF(radius + 3.0, radius + 1.0 + below),
                  QString::number(cycle.number));
    }
}

void ForceCycleModel::append(const ForceCycle& entry) {
    const int row = rowCount();
    beginInsertRows({}, row, row);
    cycles_.push_back(entry);
    endInsertRows();
}

void ForceCycleModel::updateLast(const ForceCycle& entry) {
    cycles_.back() = entry;
    const int row = rowCount() - 1;
    Q_EMIT dataChanged(index(row, 0), index(row, ColumnCount - 1));
}

void ForceCycleModel::clear() {
    beginResetModel();
    cycles_.clear();
    endResetModel();
}

int ForceCycleModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(cycles_.size());
}

int ForceCycleModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ForceCycleModel::data(const QModelIndex& index, int role) const {
    const ForceCycle& entry = cycles_.at(static_cast<std::size_t>(index.row()));
    switch (role) {
    case Qt::DisplayRole:
        return shown(entry, index.row(), index.column());
    case Qt::UserRole:
        return sorted(entry, index.row(), index.column());
    case Qt::ToolTipRole:
        return toolTip(entry, index.column());
    case Qt::TextAlignmentRole:
        return QVariant(Qt::AlignVCenter |
                        (index.column() >= Material ? Qt::AlignLeft : Qt::AlignRight));
    default:
        return {};
    }
}

QVariant ForceCycleModel::headerData(int section, Qt::Orientation orientation, int role) const {
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

ForceCycleControl::ForceCycleControl(Stage& stage)
    : Feature(stage), page_(new ForceCyclePage(&host_.widget())) {
    fresh_.reserve(kCycleRoom);
    addScanTool(page_, tr("Force cycles"), 50, "touches",
                {.text = tr("Force c&ycles"),
                 .tip = tr("Table of all force cycles since the program started, for export"),
                 .shortcuts = {tr("Ctrl+T")}});
    stage.onTick([this](const TickSample& sample) { take(sample); });
    stage.onFrame(FrameStep::Show, [this](double /*elapsed*/) { show(); });
    live_.overview().map().addTool(marks_);
    connect(page_, &ForceCyclePage::markingChosen, &marks_, &ForceCycleMarks::setShown);
    connect(page_, &ForceCyclePage::selectionChanged, &marks_,
            [this] { marks_.setSelected(page_->selected()); });
    connect(page_, &ForceCyclePage::exportChosen, this, &ForceCycleControl::askForFile);
    connect(page_, &ForceCyclePage::clearChosen, this, &ForceCycleControl::clear);
    connect(&runs_, &RunControl::ending, this, &ForceCycleControl::end);
    for (const auto shown :
         {&RunControl::begun, &RunControl::recordingShown, &RunControl::liveShown}) {
        connect(&runs_, shown, this, &ForceCycleControl::begin);
    }
}

void ForceCycleControl::begin() {
    const SampleDescription& sample = runs_.scene().description.sample;
    material_ = QString::fromStdString(sample.material.name).replace('_', ' ');
    scan_ = QString::fromStdString(sampleName(sample));
    markAll();
}

void ForceCycleControl::end() {
    update(true);
    detector_ = {};
    number_ = -1;
}

void ForceCycleControl::take(const TickSample& sample) {
    detector_.take(sample.time, sample.input, sample.output);
    if (!detector_.cycle().touched()) {
        return;
    }
    if (detector_.number() != number_) {
        number_ = detector_.number();
        fresh_.push_back({detector_.cycle(), material_, scan_});
    } else if (fresh_.empty()) {
        continues_ = true;
        fresh_.push_back({detector_.cycle(), material_, scan_});
    } else {
        fresh_.back().cycle = detector_.cycle();
    }
}

void ForceCycleControl::show() {
    const bool more = fresh_.size() > (continues_ ? 1U : 0U);
    if (!more && ++framesSince_ < kFramesPerUpdate) {
        return;
    }
    update(more);
}

void ForceCycleControl::update(bool more) {
    framesSince_ = 0;
    ForceCycleModel& model = page_->model();
    for (ForceCycle& entry : fresh_) {
        if (entry.cycle.complete() && runs_.run() != nullptr) {
            entry.budgets = cycleBudgets(runs_.run()->scene(), entry.cycle);
        }
        if (std::exchange(continues_, false)) {
            if (model.rowCount() > 0) {  // it may have been cleared
                model.updateLast(entry);
            }
        } else {
            model.append(entry);
        }
    }
    fresh_.clear();
    if (more) {
        markAll();
    }
}

void ForceCycleControl::clear() {
    page_->model().clear();
    fresh_.clear();
    continues_ = false;
    markAll();
}

/// Those of the scan that is shown.
void ForceCycleControl::markAll() {
    QVector<MarkedForceCycle> marked;
    const std::vector<ForceCycle>& cycles = page_->model().forceCycles();
    for (std::size_t i = 0; i < cycles.size(); ++i) {
        if (cycles[i].scan == scan_) {
            const Vector2& position = cycles[i].cycle.position;
            marked.append({static_cast<int>(i) + 1, {position.x(), position.y()}});
        }
    }
    marks_.setForceCycles(marked);
}

void ForceCycleControl::askForFile() {
    askForTable(host_, tr("Export the force cycles"), QStringLiteral("touches.csv"),
                [this](const std::filesystem::path& file) { write(file); });
}

void ForceCycleControl::writeTo(const std::filesystem::path& file) {
    writeTableTo(host_, file, [this](const std::filesystem::path& path) { write(path); });
}

void ForceCycleControl::write(const std::filesystem::path& file) {
    update(true);
    writeForceCycles(file, page_->model().forceCycles());
}

ForceCyclePage::ForceCyclePage(QWidget* parent)
    : QWidget(parent)
    , model_(new ForceCycleModel(this))
    , sorted_(new RowsByValue(this))
    , table_(new QTableView(this))
    , count_(captionLabel(QString(), this))
    , export_(pageButton(tr("Export CSV…"), "exportTouches",
                         tr("Writes all force cycles to a table, in SI units"), this))
    , copy_(pageButton(tr("Copy rows"), "copyTouches",
                       tr("Copies the selected rows, or all, for a spreadsheet"), this))
    , clear_(pageButton(tr("Clear"), "clearTouches", tr("Forgets all force cycles"), this)) {
    auto* marked = new QCheckBox(tr("On the whole scan"), this);
    marked->setObjectName(QStringLiteral("markTouches"));
    marked->setToolTip(tr("Numbered dots on the whole scan where the tip touched"));
    marked->setChecked(true);
    marked->setFocusPolicy(Qt::TabFocus);
    setToolTip(tr("All force cycles since the program started, for export"));
    buildTable();
    auto* bar = new QHBoxLayout;
    bar->setSpacing(4);
    for (QWidget* const control : {static_cast<QWidget*>(export_), static_cast<QWidget*>(copy_),
                                   static_cast<QWidget*>(clear_), static_cast<QWidget*>(marked)}) {
        bar->addWidget(control);
    }
    bar->addStretch(1);
    bar->addWidget(count_);
    count_->setToolTip(tr("Force cycles since the program started, of all scans"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    column->addLayout(bar);
    column->addWidget(table_, 1);
    connect(marked, &QCheckBox::toggled, this, &ForceCyclePage::markingChosen);
    connect(export_, &QToolButton::clicked, this, &ForceCyclePage::exportChosen);
    connect(copy_, &QToolButton::clicked, this, &ForceCyclePage::copy);
    connect(clear_, &QToolButton::clicked, this, &ForceCyclePage::clearChosen);
    showCount();
}

void ForceCyclePage::buildTable() {
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(Qt::UserRole);
    sorted_->setDynamicSortFilter(true);
    table_->setModel(sorted_);
    stylePageTable(*table_, "touches",
                   tr("All force cycles: a click on a title sorts, one on a row marks it on the "
                      "whole scan"));
    table_->setSortingEnabled(true);
    table_->sortByColumn(ForceCycleModel::Number, Qt::AscendingOrder);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &ForceCyclePage::selectionChanged);
    connect(model_, &QAbstractItemModel::rowsInserted, this, &ForceCyclePage::showCount);
    connect(model_, &QAbstractItemModel::modelReset, this, &ForceCyclePage::showCount);
}

void ForceCyclePage::showCount() {
    const int count = model_->rowCount();
    count_->setText(count == 1 ? tr("1 force cycle") : tr("%1 force cycles").arg(count));
    for (QToolButton* const button : {export_, copy_, clear_}) {
        button->setEnabled(count > 0);
    }
}

QSet<int> ForceCyclePage::selected() const {
    QSet<int> numbers;
    for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
        numbers.insert(sorted_->mapToSource(row).row() + 1);
    }
    return numbers;
}

QString ForceCyclePage::rowsAsText() const {
    const QChar tab = QLatin1Char('\t');
    const auto line = [&](const auto& cell) {
        QStringList cells;
        for (int column = 0; column < ForceCycleModel::ColumnCount; ++column) {
            cells << cell(column);
        }
        return cells.join(tab) + QLatin1Char('\n');
    };
    QString text = line([&](int column) {
        return model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    });
    const QSet<int> chosen = selected();
    for (int row = 0; row < sorted_->rowCount(); ++row) {
        const int number = sorted_->mapToSource(sorted_->index(row, 0)).row() + 1;
        if (chosen.isEmpty() || chosen.contains(number)) {
            text += line([&](int column) {
                return sorted_->index(row, column).data(Qt::DisplayRole).toString();
            });
        }
    }
    return text;
}

void ForceCyclePage::copy() { QApplication::clipboard()->setText(rowsAsText()); }

}  // namespace asperity
