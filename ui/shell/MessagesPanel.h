#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QToolButton>
#include <QWidget>

#include <deque>

class QComboBox;
class QPlainTextEdit;

namespace asperity {

enum class MessageKind {
    Note,     ///< what happened
    Warning,  ///< something asked for was refused, or holds with a reservation
    Error,    ///< something failed, or forces are off because of it
};

struct Message {
    QDateTime time;  ///< of the last one
    MessageKind kind = MessageKind::Note;
    QString text;
    int count = 1;  ///< how often it came in a row
};

/// All that the window said since it opened, the newest last: at most kMaxMessages, of at most
/// kMaxLength letters each.
class MessageLog : public QObject {
    Q_OBJECT

public:
    static constexpr std::size_t kMaxMessages = 500;
    static constexpr int kMaxLength = 2000;

    using QObject::QObject;

    /// The same once more is counted.
    void add(MessageKind kind, const QString& text);
    void clear();
    [[nodiscard]] const std::deque<Message>& messages() const { return messages_; }

    /// Errors since the user looked.
    [[nodiscard]] int unreadErrors() const { return unreadErrors_; }
    void markRead();

Q_SIGNALS:
    /// A message is new at the end.
    void added();
    /// Whatever else is different: how often the last one came, or all are gone.
    void changed();
    void unreadErrorsChanged(int count);

private:
    void setUnreadErrors(int count);

    std::deque<Message> messages_;
    int unreadErrors_ = 0;
};

/// List of the messages of the window, with time and kind, the newest last, as plain text that can
/// be selected and copied. Errors count as read while the panel is in sight.
class MessagesPanel : public QWidget {
    Q_OBJECT

public:
    /// @param log outlives this
    explicit MessagesPanel(MessageLog& log, QWidget* parent = nullptr);

    [[nodiscard]] QString text() const;
    /// Puts what is selected, or else all that is shown, on the clipboard.
    void copy() const;

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void buildHeading();
    void writeAll();
    void writeNewest();
    void markRead();
    void append(const Message& message);
    [[nodiscard]] bool isListed(const Message& message) const;

    MessageLog& log_;
    QComboBox* kinds_;
    QPlainTextEdit* list_;
};

/// Count of unread errors; hidden where there are none. A click opens the messages.
class MessageBadge : public QToolButton {
    Q_OBJECT

public:
    /// @param log outlives this
    explicit MessageBadge(const MessageLog& log, QWidget* parent = nullptr);

private:
    void showCount(int errors);
};

}  // namespace asperity
