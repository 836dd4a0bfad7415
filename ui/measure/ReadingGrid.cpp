#include "ui/measure/ReadingGrid.h"

#include "ui/panels/Card.h"

#include <QGridLayout>

namespace asperity {

namespace {

constexpr int kValueWidth = 80;  ///< least [px]

}  // namespace

ReadingGrid::ReadingGrid(QWidget* parent) : QWidget(parent), grid_(new QGridLayout(this)) {
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(10);
    grid_->setVerticalSpacing(2);
    grid_->setColumnMinimumWidth(1, kValueWidth);
    grid_->setRowStretch(100, 1);
}

void ReadingGrid::add(const char* objectName, const QString& name, const QString& meaning) {
    const int row = values_.size();
    auto* caption = captionLabel(name, this);
    auto* value = new QLabel(this);
    value->setObjectName(QString::fromLatin1(objectName));
    value->setTextInteractionFlags(Qt::TextSelectableByMouse);
    value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    for (QLabel* const label : {caption, value}) {
        label->setToolTip(meaning);
    }
    grid_->addWidget(caption, row, 0);
    grid_->addWidget(value, row, 1);
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

}  // namespace asperity
