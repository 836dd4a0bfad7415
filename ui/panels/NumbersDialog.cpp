#include "ui/panels/NumbersDialog.h"

#include "ui/panels/NumberBox.h"
#include "ui/panels/RefusalLine.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QVBoxLayout>

#include <utility>

namespace asperity {

namespace {

constexpr int kNumberDecimals = 12;  ///< of the smallest number

}  // namespace

NumbersDialog::NumbersDialog(const QString& title, const std::vector<Number>& numbers, Check check,
                             QWidget* parent)
    : QDialog(parent), refusal_(nullptr), check_(std::move(check)) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* rows = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    for (const Number& number : numbers) {
        auto* box = new NumberBox(this);
        box->setDecimals(kNumberDecimals);
        box->setRange(number.low, number.high);
        box->setSuffix(number.unit.isEmpty() ? QString() : QLatin1Char(' ') + number.unit);
        box->setValue(number.value);
        box->setToolTip(number.toolTip);
        form->addRow(number.label, box);
        boxes_.push_back(box);
    }
    rows->addLayout(form);
    refusal_ = new RefusalLine(this);
    refusal_->setToolTip(tr("Why a number is not taken"));
    rows->addWidget(refusal_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Take the numbers"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Leave all as it is"));
    rows->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &NumbersDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    if (!boxes_.empty()) {
        boxes_.front()->selectAll();
        boxes_.front()->setFocus();
    }
}

QWidget* windowOf(const QMenu& menu) {
    QWidget* holder = menu.parentWidget();
    while (qobject_cast<QMenu*>(holder) != nullptr) {
        holder = holder->parentWidget();
    }
    return holder != nullptr ? holder->window() : nullptr;
}

void NumbersDialog::finish() {
    std::vector<double> values;
    for (NumberBox* box : boxes_) {
        box->interpretText();
        values.push_back(box->value());
    }
    const QString reason = check_(values);
    refusal_->setText(reason);
    if (reason.isEmpty()) {
        Q_EMIT given(values);
        accept();
    }
}

}  // namespace asperity
