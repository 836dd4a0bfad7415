#include "ui/measure/TouchesPage.h"

#include "ui/measure/PageParts.h"
#include "ui/panels/Card.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

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

TouchesPage::TouchesPage(QWidget* parent)
    : QWidget(parent)
    , model_(new TouchModel(this))
    , sorted_(new RowsByValue(this))
    , table_(new QTableView(this))
    , count_(captionLabel(QString(), this))
    , export_(pageButton(tr("Export CSV…"), "exportTouches",
                         tr("Writes all touches to a table, in SI units"), this))
    , copy_(pageButton(tr("Copy rows"), "copyTouches",
                       tr("Copies the selected rows, or all, for a spreadsheet"), this))
    , clear_(pageButton(tr("Clear"), "clearTouches", tr("Forgets all touches"), this)) {
    auto* marked = new QCheckBox(tr("On the whole scan"), this);
    marked->setObjectName(QStringLiteral("markTouches"));
    marked->setToolTip(tr("Numbered dots on the whole scan where the tip touched"));
    marked->setChecked(true);
    marked->setFocusPolicy(Qt::TabFocus);
    setToolTip(tr("All touches of this session, for export"));
    buildTable();
    auto* bar = new QHBoxLayout;
    bar->setSpacing(4);
    for (QWidget* const control : {static_cast<QWidget*>(export_), static_cast<QWidget*>(copy_),
                                   static_cast<QWidget*>(clear_), static_cast<QWidget*>(marked)}) {
        bar->addWidget(control);
    }
    bar->addStretch(1);
    bar->addWidget(count_);
    count_->setToolTip(tr("Touches of this session, of all scans"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(6, 4, 6, 4);
    column->setSpacing(4);
    column->addLayout(bar);
    column->addWidget(table_, 1);
    connect(marked, &QCheckBox::toggled, this, &TouchesPage::markingChosen);
    connect(export_, &QToolButton::clicked, this, &TouchesPage::exportChosen);
    connect(copy_, &QToolButton::clicked, this, &TouchesPage::copy);
    connect(clear_, &QToolButton::clicked, this, &TouchesPage::clearChosen);
    showCount();
}

void TouchesPage::buildTable() {
    sorted_->setSourceModel(model_);
    sorted_->setSortRole(Qt::UserRole);
    sorted_->setDynamicSortFilter(true);
    table_->setModel(sorted_);
    stylePageTable(*table_, "touches",
                   tr("Touches of this session: a click on a title sorts, one on a row marks it on "
                      "the whole scan"));
    table_->setSortingEnabled(true);
    table_->sortByColumn(TouchModel::Number, Qt::AscendingOrder);
    table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &TouchesPage::selectionChanged);
    connect(model_, &QAbstractItemModel::rowsInserted, this, &TouchesPage::showCount);
    connect(model_, &QAbstractItemModel::modelReset, this, &TouchesPage::showCount);
}

void TouchesPage::showCount() {
    const int count = model_->rowCount();
    count_->setText(count == 1 ? tr("1 touch") : tr("%1 touches").arg(count));
    for (QToolButton* const button : {export_, copy_, clear_}) {
        button->setEnabled(count > 0);
    }
}

QSet<int> TouchesPage::selected() const {
    QSet<int> numbers;
    for (const QModelIndex& row : table_->selectionModel()->selectedRows()) {
        numbers.insert(sorted_->mapToSource(row).row() + 1);
    }
    return numbers;
}

QString TouchesPage::rowsAsText() const {
    const QChar tab = QLatin1Char('\t');
    const auto line = [&](const auto& cell) {
        QStringList cells;
        for (int column = 0; column < TouchModel::ColumnCount; ++column) {
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

void TouchesPage::copy() { QApplication::clipboard()->setText(rowsAsText()); }

}  // namespace asperity
