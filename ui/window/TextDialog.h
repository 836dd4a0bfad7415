#pragma once

#include <QDialog>

class QPlainTextEdit;

namespace asperity {

/// A text beside the window, to be read, selected and copied.
class TextDialog : public QDialog {
    Q_OBJECT

public:
    TextDialog(const QString& title, const QString& tip, QWidget* window);

    void setText(const QString& text);
    [[nodiscard]] QString text() const;

private:
    QPlainTextEdit* text_;
};

}  // namespace asperity
