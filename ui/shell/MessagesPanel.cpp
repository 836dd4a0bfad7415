#include "ui/shell/MessagesPanel.h"

#include "ui/widgets/Theme.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollBar>
#include <QTextCharFormat>
#include <QTextCursor>
#include <QVBoxLayout>

#include <array>

namespace asperity {

namespace {

constexpr int kMaxLines = 4000;  // a message may have several

struct KindTraits {
    const char* name;
    const char* filter;  ///< that shows this kind and more severe ones
};

/// In the order of MessageKind.
constexpr std::array<KindTraits, 3> kKinds{{
    {QT_TRANSLATE_NOOP("MessagesPanel", "note"),
     QT_TRANSLATE_NOOP("MessagesPanel", "All messages")},
    {QT_TRANSLATE_NOOP("MessagesPanel", "warning"),
     QT_TRANSLATE_NOOP("MessagesPanel", "Warnings and errors")},
    {QT_TRANSLATE_NOOP("MessagesPanel", "error"), QT_TRANSLATE_NOOP("MessagesPanel", "Errors")},
}};

const KindTraits& traitsOf(MessageKind kind) { return kKinds.at(static_cast<std::size_t>(kind)); }

/// Lines after the first are below it, so that each message is seen to be one.
QString lineOf(const Message& message) {
    const QString indent = QStringLiteral("\n    ");
    QString line = QStringLiteral("%1  %2  %3")
                       .arg(message.time.toString(QStringLiteral("HH:mm:ss")),
                            QObject::tr(traitsOf(message.kind).name), message.text.trimmed());
    if (message.count > 1) {
        line += QObject::tr("  (%1 times)").arg(message.count);
    }
    return line.replace(QLatin1Char('\n'), indent);
}

QColor colorOf(MessageKind kind) {
    switch (kind) {
    case MessageKind::Error:
        return theme::colors().fault;
    case MessageKind::Warning:
        return theme::colors().caution;
    case MessageKind::Note:
        break;
    }
    return theme::colors().ink;
}

}  // namespace

void MessageLog::add(MessageKind kind, const QString& text) {
    const QString kept =
        text.size() > kMaxLength ? text.left(kMaxLength) + QStringLiteral("…") : text;
    const QDateTime now = QDateTime::currentDateTime();
    const bool again =
        !messages_.empty() && messages_.back().kind == kind && messages_.back().text == kept;
    if (again) {
        messages_.back().time = now;
        ++messages_.back().count;
    } else {
        messages_.push_back({now, kind, kept});
    }
    if (messages_.size() > kMaxMessages) {
        messages_.pop_front();
    }
    again ? Q_EMIT changed() : Q_EMIT added();
    if (kind == MessageKind::Error) {
        setUnreadErrors(unreadErrors_ + 1);
    }
}

void MessageLog::clear() {
    messages_.clear();
    Q_EMIT changed();
    setUnreadErrors(0);
}

void MessageLog::markRead() { setUnreadErrors(0); }

void MessageLog::setUnreadErrors(int count) {
    if (count != unreadErrors_) {
        unreadErrors_ = count;
        Q_EMIT unreadErrorsChanged(count);
    }
}

MessagesPanel::MessagesPanel(MessageLog& log, QWidget* parent)
    : QWidget(parent), log_(log), kinds_(new QComboBox(this)), list_(new QPlainTextEdit(this)) {
    setObjectName(QStringLiteral("messages"));
    list_->setObjectName(QStringLiteral("messageList"));
    list_->setReadOnly(true);
    list_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
    list_->setToolTip(tr("What the window said: time, kind and text, the newest last"));
    list_->setMaximumBlockCount(kMaxLines);
    list_->setMinimumHeight(3 * fontMetrics().lineSpacing());
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(4);
    buildHeading();
    column->addWidget(list_, 1);
    connect(&log_, &MessageLog::added, this, &MessagesPanel::writeNewest);
    connect(&log_, &MessageLog::changed, this, &MessagesPanel::writeAll);
    connect(&log_, &MessageLog::unreadErrorsChanged, this, &MessagesPanel::markRead);
}

void MessagesPanel::buildHeading() {
    kinds_->setObjectName(QStringLiteral("messageKinds"));
    kinds_->setToolTip(tr("Which messages are listed, by severity"));
    for (const KindTraits& kind : kKinds) {
        kinds_->addItem(tr(kind.filter));
    }
    connect(kinds_, qOverload<int>(&QComboBox::currentIndexChanged), this,
            &MessagesPanel::writeAll);
    auto* row = new QHBoxLayout;
    row->addWidget(kinds_);
    row->addStretch(1);
    const auto add = [&](const char* name, const QString& text, const QString& tip, auto what) {
        auto* button = new QPushButton(text, this);
        button->setObjectName(QString::fromUtf8(name));
        button->setToolTip(tip);
        connect(button, &QPushButton::clicked, this, what);
        row->addWidget(button);
    };
    add("copyMessages", tr("Copy"), tr("Copies the selected messages, or all that are listed"),
        [this] { copy(); });
    add("clearMessages", tr("Clear"), tr("Forgets all messages"), [this] { log_.clear(); });
    static_cast<QVBoxLayout*>(layout())->addLayout(row);
}

QString MessagesPanel::text() const { return list_->toPlainText(); }

void MessagesPanel::copy() const {
    const QTextCursor selected = list_->textCursor();
    // Qt parts the paragraphs of a selection with U+2029.
    QApplication::clipboard()->setText(
        selected.hasSelection()
            ? selected.selectedText().replace(QChar::ParagraphSeparator, QLatin1Char('\n'))
            : text());
}

bool MessagesPanel::isListed(const Message& message) const {
    return static_cast<int>(message.kind) >= kinds_->currentIndex();
}

/// Nothing is written while nobody sees it.
void MessagesPanel::writeAll() {
    if (!isVisible()) {
        return;
    }
    list_->clear();
    for (const Message& message : log_.messages()) {
        append(message);
    }
}

void MessagesPanel::writeNewest() {
    if (isVisible()) {
        append(log_.messages().back());
    }
}

/// Errors count as read where they are in sight.
void MessagesPanel::markRead() {
    if (isVisible()) {
        log_.markRead();
    }
}

/// A user who reads further up is not carried away.
void MessagesPanel::append(const Message& message) {
    if (!isListed(message)) {
        return;
    }
    QScrollBar& bar = *list_->verticalScrollBar();
    const bool follows = bar.value() == bar.maximum();
    QTextCharFormat letters;
    letters.setForeground(colorOf(message.kind));
    QTextCursor end(list_->document());
    end.movePosition(QTextCursor::End);
    if (!list_->document()->isEmpty()) {
        end.insertBlock();
    }
    end.insertText(lineOf(message), letters);
    if (follows) {
        bar.setValue(bar.maximum());
    }
}

void MessagesPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    writeAll();
    markRead();
}

void MessagesPanel::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        writeAll();
    }
}

MessageBadge::MessageBadge(const MessageLog& log, QWidget* parent) : QToolButton(parent) {
    setObjectName(QStringLiteral("messageBadge"));
    setToolTip(tr("Errors that nobody has read yet; a click lists all messages"));
    setFocusPolicy(Qt::TabFocus);  // a click leaves the keys to the view
    // The panel in sight may have read them since this signal was sent.
    connect(&log, &MessageLog::unreadErrorsChanged, this,
            [this, &log] { showCount(log.unreadErrors()); });
    showCount(log.unreadErrors());
    theme::follow(this, [this] {
        QPalette colors = palette();
        colors.setColor(QPalette::ButtonText, theme::colors().fault);
        setPalette(colors);
    });
}

void MessageBadge::showCount(int errors) {
    setText(errors == 1 ? tr("1 error") : tr("%1 errors").arg(errors));
    setVisible(errors > 0);
}

}  // namespace asperity
