#pragma once

#include <QToolButton>

namespace asperity {

class MessageLog;

/// How many errors nobody has read yet; hidden where there are none. A click opens the messages.
class MessageBadge : public QToolButton {
    Q_OBJECT

public:
    /// @param log outlives this
    explicit MessageBadge(const MessageLog& log, QWidget* parent = nullptr);

private:
    void showCount(int errors);
};

}  // namespace asperity
