#include "ui/widgets/PageParts.h"

#include "ui/widgets/Card.h"
#include "ui/widgets/Theme.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QTableView>
#include <QToolButton>

namespace asperity {

namespace {

constexpr int kMeasuredRows = 50;  ///< that columns are as wide as

constexpr int kValueWidth = 80;  ///< least [px]

constexpr int kFormGap = 8;  // [px]

}  // namespace

QToolButton* pageButton(const QString& text, const char* objectName, const QString& toolTip,
                        QWidget* parent) {
    auto* button = new QToolButton(parent);
    button->setObjectName(QString::fromLatin1(objectName));
    button->setText(text);
    button->setToolTip(toolTip);
    button->setFocusPolicy(Qt::TabFocus);
    return button;
}

QPushButton* pushButton(const QString& text, const char* objectName, const QString& toolTip,
                        Qt::FocusPolicy focus) {
    auto* button = new QPushButton(text);
    button->setObjectName(QString::fromLatin1(objectName));
    button->setToolTip(toolTip);
    button->setAutoDefault(false);
    button->setFocusPolicy(focus);
    return button;
}

void stylePageTable(QTableView& table, const char* objectName, const QString& toolTip) {
    table.setToolTip(toolTip);
    table.setObjectName(QString::fromLatin1(objectName));
    table.setFont(theme::textFont(theme::kSmallSize));
    table.horizontalHeader()->setFont(theme::textFont(theme::kSmallSize));
    table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table.horizontalHeader()->setResizeContentsPrecision(kMeasuredRows);
    table.horizontalHeader()->setHighlightSections(false);
    table.verticalHeader()->hide();
    table.verticalHeader()->setDefaultSectionSize(table.fontMetrics().height() + 5);
    table.setSelectionBehavior(QAbstractItemView::SelectRows);
    table.setAlternatingRowColors(true);
    table.setShowGrid(false);
    table.setWordWrap(false);
}

ReadingGrid::ReadingGrid(QWidget* parent, int rows)
    : QWidget(parent), grid_(new QGridLayout(this)), rows_(rows) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(10);
    grid_->setVerticalSpacing(2);
    grid_->setRowStretch(kRows, 1);
}

void ReadingGrid::add(const char* objectName, const QString& name, const QString& meaning) {
    const int row = values_.size() % rows_;
    const int column = 2 * (values_.size() / rows_);
    auto* caption = captionLabel(name, this);
    auto* value = new QLabel(this);
    value->setObjectName(QString::fromLatin1(objectName));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QLabel* const label : {caption, value}) {
        label->setToolTip(meaning);
    }
    grid_->addWidget(caption, row, column);
    grid_->addWidget(value, row, column + 1);
    grid_->setColumnMinimumWidth(column + 1, kValueWidth);
    values_.insert(value->objectName(), value);
    set(objectName, {});
}

void ReadingGrid::set(const char* objectName, const QString& text) {
    values_.value(QString::fromLatin1(objectName))
        ->setText(text.isEmpty() ? QStringLiteral("–") : text);
}

QString ReadingGrid::text(const char* objectName) const {
    return values_.value(QString::fromLatin1(objectName))->text();
}

QSpinBox* newNumber(const char* name, const QString& unit, int low, int high, const QString& tip) {
    auto* box = named(new QSpinBox, name, tip);
    box->setRange(low, high);
    box->setSuffix(unit);
    box->setKeyboardTracking(false);  // a half-typed number is no size
    guardFromWheel(*box);
    return box;
}

QComboBox* newList(const char* name, const QString& tip) {
    auto* list = named(new QComboBox, name, tip);
    guardFromWheel(*list);
    return list;
}

QPushButton* newButton(const QString& text, const char* name, const QString& tip) {
    auto* button = named(new QPushButton(text), name, tip);
    button->setAutoDefault(false);  // that is for what the dialog is for
    return button;
}

QWidget* newRow(std::initializer_list<QWidget*> parts) {
    auto* row = new QWidget;
    auto* line = new QHBoxLayout(row);
    line->setContentsMargins(0, 0, 0, 0);
    line->setSpacing(kFormGap);
    for (QWidget* const part : parts) {
        line->addWidget(part, qobject_cast<QPushButton*>(part) == nullptr ? 1 : 0);
    }
    return row;
}

}  // namespace asperity
