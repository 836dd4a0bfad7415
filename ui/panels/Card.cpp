#include "ui/panels/Card.h"

#include "ui/Theme.h"

#include <QHBoxLayout>
#include <QToolButton>
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
    , heading_(new QToolButton(this))
    , top_(new QHBoxLayout)
    , note_(captionLabel(QString(), this))
    , content_(new QWidget(this))
    , body_(new QVBoxLayout(content_)) {
    setProperty("card", true);
    heading_->setProperty("heading", true);
    heading_->setText(title);
    heading_->setFont(theme::boldFont());
    heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    heading_->setFocusPolicy(Qt::NoFocus);
    heading_->setAttribute(Qt::WA_TransparentForMouseEvents);
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    top_->addWidget(heading_);
    top_->addWidget(note_, 1);
    body_->setContentsMargins(0, 0, 0, 0);
    body_->setSpacing(kMargin / 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kMargin, kMargin / 2, kMargin, kMargin - 2);
    column->setSpacing(kMargin / 2);
    column->addLayout(top_);
    column->addWidget(content_, 1);
}

QString Card::title() const { return heading_->text(); }

void Card::setFoldable() {
    heading_->setAttribute(Qt::WA_TransparentForMouseEvents, false);
    connect(heading_, &QToolButton::clicked, this, [this] { setFolded(!folded_); });
    setFolded(folded_);
}

void Card::setFolded(bool folded) {
    folded_ = folded;
    content_->setVisible(!folded);
    heading_->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    heading_->setToolTip(folded ? tr("Unfold this panel") : tr("Fold this panel"));
    // Folded it leaves its room to the other panels.
    setSizePolicy(QSizePolicy::Preferred, folded ? QSizePolicy::Maximum : QSizePolicy::Preferred);
}

void Card::addToHeading(QWidget* control) { top_->addWidget(control); }

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
