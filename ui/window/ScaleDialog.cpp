#include "ui/window/ScaleDialog.h"

#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/ScaleForm.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace asperity {

namespace {

constexpr int kScaleGap = 8;     // [px]
constexpr int kTextWidth = 400;  // [px]
constexpr int kNameWidth = 260;  // [px]

/// A name of a file or channel, which may be long and look like markup.
QString shortened(const QString& name, const QWidget& label) {
    return label.fontMetrics().elidedText(name, Qt::ElideMiddle, kNameWidth);
}

QLabel* nameLabel(const QString& file, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::boldFont());
    label->setText(shortened(file, *label));
    label->setToolTip(file.toHtmlEscaped());
    return label;
}

QLabel* channelLabel(const ScaleGap& gap, QWidget* parent) {
    QLabel* label = captionLabel({}, parent);
    label->setText(ScaleDialog::tr("Channel “%1”, %2 × %3 pixels")
                       .arg(shortened(QString::fromStdString(gap.channel), *label))
                       .arg(gap.columns)
                       .arg(gap.rows));
    return label;
}

}  // namespace

ScaleDialog::ScaleDialog(const QString& file, const ScaleGap& gap, QWidget* window)
    : QDialog(window), form_(new ScaleForm(Qt::Vertical, this)) {
    setWindowTitle(tr("Scale of the scan"));
    setObjectName(QStringLiteral("scaleDialog"));
    form_->setMinimumWidth(theme::scaled(kTextWidth));
    form_->setGap(gap);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(2 * kScaleGap, 2 * kScaleGap, 2 * kScaleGap, 2 * kScaleGap);
    column->setSpacing(kScaleGap);
    column->addWidget(nameLabel(file, this));
    column->addWidget(channelLabel(gap, this));
    column->addWidget(form_);
    column->addWidget(newButtons());
}

QDialogButtonBox* ScaleDialog::newButtons() {
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    for (QAbstractButton* const button : buttons->buttons()) {
        button->setIcon({});  // no other button has one
    }
    QPushButton* ok = buttons->button(QDialogButtonBox::Ok);
    ok->setToolTip(tr("Open the scan with this scale"));
    ok->setEnabled(form_->isComplete());
    connect(form_, &ScaleForm::changed, ok, [this, ok] { ok->setEnabled(form_->isComplete()); });
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Open nothing"));
    connect(buttons, &QDialogButtonBox::accepted, this, [this] {
        accept();
        Q_EMIT given(scale());
    });
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    return buttons;
}

void ScaleDialog::suggest(const GivenScale& scale) { form_->suggest(scale); }

GivenScale ScaleDialog::scale() const { return form_->scale(); }

}  // namespace asperity
