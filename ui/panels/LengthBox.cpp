#include "ui/panels/LengthBox.h"

#include <QSignalBlocker>

namespace asperity {

namespace {

constexpr double kLow = 1e-9;  ///< stands for none
constexpr double kHigh = 1e9;

}  // namespace

LengthBox::LengthBox(QWidget* parent) : GainSpinBox(kLow, kHigh, parent) {
    setSpecialValueText(QStringLiteral(" "));  // Qt takes an empty one for none
    setValue(kLow);
    setKeyboardTracking(true);
    connect(this, &NumberBox::refused, this, [this] {
        const QSignalBlocker blocker(this);  // the reason stays
        setValue(minimum());                 // not what was taken of "5x" on the way
    });
}

QValidator::State LengthBox::validate(QString& text, int& position) const {
    return text.trimmed().isEmpty() && isBlank() ? QValidator::Acceptable
                                                 : GainSpinBox::validate(text, position);
}

double LengthBox::valueFromText(const QString& text) const {
    return text.trimmed().isEmpty() ? value() : GainSpinBox::valueFromText(text);
}

void LengthBox::stepBy(int steps) {
    if (isBlank()) {
        setValue(1.0);
    } else {
        GainSpinBox::stepBy(steps);
    }
}

}  // namespace asperity
