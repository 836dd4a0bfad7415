#include "ui/panels/Card.h"

#include "ui/Theme.h"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <QVariant>

namespace asperity {

namespace {

constexpr int kMargin = 8;  ///< [px]

void colorText(QLabel& label, QRgb color) {
    QPalette palette = label.palette();
    palette.setColor(QPalette::WindowText, color);
    label.setPalette(palette);
}

}  // namespace

Card::Card(const QString& title, QWidget* parent)
    : QFrame(parent)
    , body_(new QVBoxLayout(this))
    , heading_(new QHBoxLayout)
    , note_(captionLabel(QString(), this)) {
    setProperty("card", true);
    auto* name = new QLabel(title, this);
    name->setFont(theme::boldFont());
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    heading_->addWidget(name);
    heading_->addWidget(note_, 1);
    body_->setContentsMargins(kMargin, kMargin / 2, kMargin, kMargin - 2);
    body_->setSpacing(kMargin / 2);
    body_->addLayout(heading_);
}

void Card::addToHeading(QWidget* control) { heading_->addWidget(control); }

QLabel* captionLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::textFont(theme::kSmallSize));
    colorText(*label, theme::kMuted);
    return label;
}

QLabel* valueLabel(const QString& objectName, const QString& widest, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setObjectName(objectName);
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::textFont());
    label->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    const QFontMetrics metrics(label->font());
    label->setFixedSize(metrics.horizontalAdvance(widest) + 2, metrics.height());
    return label;
}

}  // namespace asperity
