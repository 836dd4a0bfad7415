#pragma once

#include <QDialog>
#include <QString>

#include <functional>
#include <vector>

class QLabel;
class QMenu;

namespace asperity {

class NumberBox;

/// Asks for a few numbers; the window goes on meanwhile. Closes itself when they are given.
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
    /// Why the numbers cannot be taken; empty: they can.
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

}  // namespace asperity
