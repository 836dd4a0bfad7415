#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>

#include <deque>

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

}  // namespace asperity
