#include "ui/panels/Card.h"

#include "ui/Theme.h"
#include "ui/panels/CardHeading.h"

#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kCardMargin = 8;       ///< [px]
constexpr int kFrame = 1;            ///< [px]
constexpr double kCardRadius = 6.0;  ///< of the frame's corners [px]

}  // namespace

Card::Card(const QString& title, QWidget* parent)
    : QFrame(parent)
    , heading_(new CardHeading(title, this))
    , top_(new QHBoxLayout)
    , note_(captionLabel(QString(), this))
    , content_(new QWidget(this))
    , body_(new QVBoxLayout(content_)) {
    setContentsMargins(kFrame, kFrame, kFrame, kFrame);
    theme::follow(this, [this] { update(); });
    note_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    note_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    top_->addWidget(heading_);
    top_->addWidget(note_, 1);
    body_->setContentsMargins(0, 0, 0, 0);
    body_->setSpacing(kCardMargin / 2);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(kCardMargin, kCardMargin / 2, kCardMargin, kCardMargin - 2);
    column->setSpacing(kCardMargin / 2);
    column->addLayout(top_);
    column->addWidget(content_, 1);
}

QString Card::title() const { return heading_->text(); }

void Card::setFoldable() {
    foldable_ = true;
    heading_->setActive();
    connect(heading_, &CardHeading::foldRequested, this, [this] { setFolded(!folded_); });
    connect(heading_, &CardHeading::enlargeRequested, this, &Card::enlargeRequested);
    setFolded(folded_);
}

void Card::setFolded(bool folded) {
    if (enlarged_) {
        return;
    }
    const bool changes = folded != folded_;
    folded_ = folded;
    content_->setVisible(!folded);
    heading_->setState(folded_, enlarged_);
    // Folded it leaves its room to the other panels.
    setMaximumHeight(folded ? QFrame::sizeHint().height() : QWIDGETSIZE_MAX);
    if (changes) {
        Q_EMIT foldedChanged(folded);
    }
}

void Card::setEnlarged(bool enlarged) {
    enlarged_ = enlarged;
    heading_->setState(folded_, enlarged_);
}

/// A splitter asks for no height at a width: texts that wrap must have theirs.
QSize Card::minimumSizeHint() const {
    QSize least = QFrame::minimumSizeHint();
    if (layout()->hasHeightForWidth() && width() >= least.width()) {
        least.setHeight(std::max(least.height(), layout()->minimumHeightForWidth(width())));
    }
    return least;
}

void Card::resizeEvent(QResizeEvent* event) {
    QFrame::resizeEvent(event);
    if (layout()->hasHeightForWidth() && event->size().width() != event->oldSize().width()) {
        updateGeometry();
    }
}

void Card::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(theme::colors().faint, kFrame));
    painter.setBrush(theme::colors().paper);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), kCardRadius,
                            kCardRadius);
}

void Card::addToHeading(QWidget* control) { top_->addWidget(control); }

/// The whole line of the title counts, also where it has no words.
void Card::mouseDoubleClickEvent(QMouseEvent* event) {
    if (foldable_ && event->button() == Qt::LeftButton &&
        event->pos().y() <= top_->geometry().bottom()) {
        Q_EMIT enlargeRequested();
        return;
    }
    QFrame::mouseDoubleClickEvent(event);
}

QLabel* captionLabel(const QString& text, QWidget* parent) {
    auto* label = new QLabel(text, parent);
    label->setTextFormat(Qt::PlainText);
    label->setFont(theme::textFont(theme::kSmallSize));
    theme::colorText(*label, &ThemeColors::muted);
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
