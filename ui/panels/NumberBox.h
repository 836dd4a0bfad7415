#pragma once

#include <QDoubleSpinBox>

namespace asperity {

/// A box for a number: takes what numberFromText() does and shows it as in files, in the shortest
/// form that keeps it. What it does not take is red while it is typed; when it is to count, the box
/// is marked until the next letter and says why.
class NumberBox : public QDoubleSpinBox {
    Q_OBJECT

public:
    explicit NumberBox(QWidget* parent = nullptr);

    [[nodiscard]] double valueFromText(const QString& text) const override;
    [[nodiscard]] QString textFromValue(double value) const override;
    QValidator::State validate(QString& text, int& position) const override;
    /// Called with a text that is not taken; the value stays.
    void fixup(QString& text) const override;
    /// What was typed and does not count yet is gone.
    void discardTyped();
    /// Shows its number muted: it is what it is by default.
    void setMuted(bool muted);
    /// Undo and redo are the window's while nothing typed is to be undone.
    bool event(QEvent* event) override;

Q_SIGNALS:
    /// A text is not taken. A tool tip says it, too, but goes with the focus: show it where it
    /// stays.
    void refused(const QString& reason) const;

private:
    [[nodiscard]] QString withoutUnit(const QString& text) const;
    void mark(bool refused) const;
    void colorText();

    mutable bool refused_ = false;  ///< and marked
    bool muted_ = false;
};

}  // namespace asperity
