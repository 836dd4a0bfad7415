#pragma once

#include <QComboBox>
#include <QDialog>
#include <QDoubleSpinBox>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QString>

#include <functional>
#include <optional>
#include <vector>

class QWidget;
class QLabel;
class QMenu;

namespace asperity {

/// A line of text. Undo and redo are the window's while nothing typed is to be undone.
class TextBox : public QLineEdit {
public:
    using QLineEdit::QLineEdit;

    bool event(QEvent* event) override;
};

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
    /// Called with a text that is not valid; the value stays.
    void fixup(QString& text) const override;
    /// Discards what was typed and does not count yet.
    void discardTyped();
    /// Shows its number muted: it is what it is by default.
    void setMuted(bool muted);
    [[nodiscard]] bool isMuted() const { return muted_; }
    /// Undo and redo are the window's while nothing typed is to be undone.
    bool event(QEvent* event) override;

Q_SIGNALS:
    /// A text is not valid. A tool tip says it, too, but goes with the focus: show it where it
    /// stays.
    void refused(const QString& reason) const;

private:
    [[nodiscard]] QString withoutUnit(const QString& text) const;
    [[nodiscard]] bool isSpecial(const QString& text) const;
    void mark(bool refused) const;
    void colorText();

    mutable bool refused_ = false;  ///< and marked
    bool muted_ = false;
};

/// Returns whether a key is for the window's history: it undoes or redoes, and nothing typed in
/// this line can be. Qt's own lines keep both keys even then.
inline bool isForWindowHistory(const QKeyEvent& key, const QLineEdit& line) {
    return (key.matches(QKeySequence::Undo) && !line.isUndoAvailable()) ||
           (key.matches(QKeySequence::Redo) && !line.isRedoAvailable());
}

/// A number box for gains, which run over many powers of ten: steps go 1, 2, 5, 10, ...
class GainSpinBox : public NumberBox {
public:
    /// @param low, high limits, both > 0
    GainSpinBox(double low, double high, QWidget* parent = nullptr);

    void stepBy(int steps) override;
};

/// A gain box that shows what is usual, muted, until another number is typed, and again once it is
/// emptied.
class UsualBox : public GainSpinBox {
public:
    UsualBox(double low, double high, QWidget* parent = nullptr);

    /// Sets what is usual, and the least that can be typed. A number that was typed stays, and is
    /// shown as soon as it is at least that.
    void setUsual(double usual, double least);

    QValidator::State validate(QString& text, int& position) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;

private:
    void showNumber();

    double usual_;
    std::optional<double> typed_;
    bool isEmptied_ = false;
};

/// A number box for a number above 0 that is not known yet: empty until one is typed or set. Each
/// number counts as soon as it is typed; one that is refused leaves the box empty.
class LengthBox : public GainSpinBox {
public:
    explicit LengthBox(QWidget* parent = nullptr);

    [[nodiscard]] bool isBlank() const { return value() == minimum(); }
    /// Returns whether it shows an accepted number.
    [[nodiscard]] bool isGiven() const { return !isBlank() && hasAcceptableInput(); }

    QValidator::State validate(QString& text, int& position) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    void stepBy(int steps) override;
};

/// Says below number boxes why the last number was refused, until another is typed.
class RefusalLine : public QLabel {
public:
    /// @param boxes holds the number boxes, all there already
    explicit RefusalLine(QWidget* boxes);

protected:
    void hideEvent(QHideEvent* /*event*/) override { clear(); }
};

/// Has a knob use the wheel only while it has the focus, and not take the focus by the wheel: a
/// device that turns the wheel on its way elsewhere changes nothing.
void guardFromWheel(QWidget& knob);

class NumberBox;

/// Asks for a few numbers; the window stays usable. Closes itself when they are given.
class NumbersDialog : public QDialog {
    Q_OBJECT

public:
    struct Number {
        QString label;
        QString unit;     ///< shown behind the number
        double value;     ///< at first
        double low;       ///< least
        double high;      ///< largest
        QString toolTip;  ///< meaning and unit
    };
    /// Returns why the numbers cannot be taken; empty: they can.
    using Check = std::function<QString(const std::vector<double>& values)>;

    NumbersDialog(const QString& title, const std::vector<Number>& numbers, Check check,
                  QWidget* parent);

    /// Takes the numbers as they are typed, or says why not.
    void finish();

Q_SIGNALS:
    void given(std::vector<double> values);

private:
    std::vector<NumberBox*> boxes_;
    QLabel* refusal_;
    Check check_;
};

/// The window that a menu belongs to, whatever menus it is in; null: none.
[[nodiscard]] QWidget* windowOf(const QMenu& menu);

/// A list of choices that asks for as much width as its present text takes, up to 24 letters; a
/// longer text ends in "…". It may be narrower where nobody heeds what it asks for.
class ChoiceBox : public QComboBox {
public:
    explicit ChoiceBox(QWidget* parent = nullptr);

    void setNames(const QStringList& names);
    /// Returns the part of the present text that is drawn.
    [[nodiscard]] QString shownText() const;
    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return QComboBox::sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    /// Returns the width for letters, in a box of this width [px].
    [[nodiscard]] int textRoom(int width) const;
};

}  // namespace asperity
