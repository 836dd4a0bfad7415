#include "ui/measure/PageParts.h"

#include "ui/Theme.h"

#include <QHeaderView>
#include <QPushButton>
#include <QTableView>
#include <QToolButton>

namespace asperity {

namespace {

constexpr int kMeasuredRows = 50;  ///< that columns are as wide as

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

}  // namespace asperity
