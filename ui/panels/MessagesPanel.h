#pragma once

#include "ui/panels/MessageLog.h"

#include <QWidget>

class QComboBox;
class QPlainTextEdit;

namespace asperity {

/// What the window said, with time and kind: one below the other, the newest last, as plain text
/// that can be selected and copied. Errors count as read while the panel is in sight.
class MessagesPanel : public QWidget {
    Q_OBJECT

public:
    /// @param log outlives this
    explicit MessagesPanel(MessageLog& log, QWidget* parent = nullptr);

    /// What is shown.
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

}  // namespace asperity
