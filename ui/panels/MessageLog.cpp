#include "ui/panels/MessageLog.h"

namespace asperity {

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

}  // namespace asperity
