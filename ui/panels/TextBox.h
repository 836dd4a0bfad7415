#pragma once

#include <QLineEdit>

namespace asperity {

/// A line of text. Undo and redo are the window's while nothing typed is to be undone.
class TextBox : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

    bool event(QEvent* event) override;
};

}  // namespace asperity
