#pragma once

#include "ui/panels/GainSpinBox.h"

namespace asperity {

/// A number box for a number above 0 that is not known yet: empty until one is typed or set. Each
/// number counts as soon as it is typed; one that is refused leaves the box empty.
class LengthBox : public GainSpinBox {
public:
    explicit LengthBox(QWidget* parent = nullptr);

    [[nodiscard]] bool isBlank() const { return value() == minimum(); }
    /// Whether it shows a number that is taken.
    [[nodiscard]] bool isGiven() const { return !isBlank() && hasAcceptableInput(); }

    QValidator::State validate(QString& text, int& position) const override;
    [[nodiscard]] double valueFromText(const QString& text) const override;
    void stepBy(int steps) override;
};

}  // namespace asperity
