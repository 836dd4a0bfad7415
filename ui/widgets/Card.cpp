#include "ui/widgets/Card.h"

#include "ui/widgets/Theme.h"

#include <QApplication>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QMouseEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kCardMargin = 8;       ///< [px]
constexpr int kFrame = 1;            ///< [px]
constexpr double kCardRadius = 6.0;  ///< of the frame's corners [px]

constexpr int kSectionGap = 4;              ///< [px]
constexpr int kIndent = 6;                  ///< of the rows [px]
constexpr int kCaptionWidth = 148;          ///< so that the controls of all sections line up [px]
constexpr const char* kWorkingTip = "tip";  ///< property: what a control says while it works

}  // namespace

CardHeading::CardHeading(const QString& title, QWidget* parent) : QToolButton(parent) {
    setProperty("heading", true);
    setText(title);
    setFont(theme::boldFont());
    setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    setFocusPolicy(Qt::NoFocus);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    secondClick_.setSingleShot(true);
    connect(&secondClick_, &QTimer::timeout, this, &CardHeading::foldRequested);
    connect(this, &QToolButton::clicked, this, &CardHeading::take);
}

void CardHeading::setActive() { setAttribute(Qt::WA_TransparentForMouseEvents, false); }

void CardHeading::setState(bool folded, bool enlarged) {
    setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    setToolTip(enlarged ? tr("Double click: restore its size and position")
               : folded ? tr("Click: unfold this panel. Double click: enlarge it")
                        : tr("Click: fold this panel. Double click: enlarge it"));
}

bool CardHeading::isOnArrow(const QPoint& point) const { return point.x() <= iconSize().width(); }

void CardHeading::mousePressEvent(QMouseEvent* event) {
    pressedArrow_ = isOnArrow(event->pos());
    QToolButton::mousePressEvent(event);
}

void CardHeading::take() {
    if (pressedArrow_) {
        Q_EMIT foldRequested();
    } else {
        secondClick_.start(QApplication::doubleClickInterval());
    }
}

void CardHeading::mouseDoubleClickEvent(QMouseEvent* event) {
    if (event->button() != Qt::LeftButton || isOnArrow(event->pos())) {
        QToolButton::mouseDoubleClickEvent(event);  // two clicks on the arrow are two clicks
        return;
    }
    secondClick_.stop();
    Q_EMIT enlargeRequested();
}

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

Section::Section(const QString& title, const QString& about, QWidget* parent)
    : QWidget(parent)
    , about_(about)
    , heading_(new QToolButton(this))
    , content_(new QWidget(this))
    , rows_(new QGridLayout(content_)) {
    heading_->setProperty("heading", true);
    heading_->setObjectName(QStringLiteral("sectionHeading"));
    heading_->setText(title);
    heading_->setFont(theme::boldFont());
    heading_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    heading_->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    rows_->setContentsMargins(kIndent, 0, 0, kSectionGap);
    rows_->setHorizontalSpacing(kSectionGap);
    rows_->setVerticalSpacing(kSectionGap);
    rows_->setColumnStretch(1, 1);
    rows_->setColumnMinimumWidth(0, theme::scaled(kCaptionWidth));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(kSectionGap);
    column->addWidget(heading_);
    column->addWidget(content_);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(heading_, &QToolButton::clicked, this, [this] { setFolded(!folded_); });
    setFolded(false);
}

void Section::setFolded(bool folded) {
    folded_ = folded;
    content_->setVisible(!folded);
    heading_->setArrowType(folded ? Qt::RightArrow : Qt::DownArrow);
    heading_->setToolTip(folded ? tr("%1; click to unfold").arg(about_)
                                : tr("%1; click to fold").arg(about_));
}

void Section::addWide(QWidget* widget) { rows_->addWidget(widget, rows_->rowCount(), 0, 1, 3); }

void Section::refuse(const QString& reason) {
    if (reason == refusal_) {
        return;
    }
    refusal_ = reason;
    content_->setEnabled(reason.isEmpty());
    for (QWidget* part : content_->findChildren<QWidget*>(QString(), Qt::FindDirectChildrenOnly)) {
        if (!part->property(kWorkingTip).isValid()) {
            part->setProperty(kWorkingTip, part->toolTip());
        }
        part->setToolTip(reason.isEmpty() ? part->property(kWorkingTip).toString() : reason);
    }
}

}  // namespace asperity
