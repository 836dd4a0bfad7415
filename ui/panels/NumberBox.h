#pragma once

#include <QDoubleSpinBox>

namespace asperity {

/// A box for a number: takes what numberFromText() does, shows it as in files, and says visibly
/// what it does not take: in red while it is typed, in words when it is to count.
class NumberBox : public QDoubleSpinBox {
public:
    explicit NumberBox(QWidget* parent = nullptr);

    [[nodiscard]] double valueFromText(const QString& text) const override;
    QValidator::State validate(QString& text, int& position) const override;
    /// Called with a text that is not taken; the value stays.
    void fixup(QString& text) const override;

private:
    [[nodiscard]] QString withoutUnit(const QString& text) const;
};

}  // namespace asperity
