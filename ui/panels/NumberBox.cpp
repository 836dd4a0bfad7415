#include "ui/panels/NumberBox.h"

#include "ui/NumberText.h"
#include "ui/Theme.h"

#include <QLineEdit>
#include <QToolTip>

namespace asperity {

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setKeyboardTracking(false);
    const auto color = [this] {
        QPalette colors = lineEdit()->palette();
        colors.setColor(QPalette::Text,
                        lineEdit()->hasAcceptableInput() ? theme::kInk : theme::kFault);
        lineEdit()->setPalette(colors);
    };
    connect(lineEdit(), &QLineEdit::textChanged, this, color);
    connect(this, &QAbstractSpinBox::editingFinished, this, color);  // by Qt's own text
}

QString NumberBox::withoutUnit(const QString& text) const {
    const QString unit = suffix().trimmed();
    QString number = text.trimmed();
    while (!unit.isEmpty() && number.endsWith(unit)) {  // typed beside the one that is shown
        number = number.chopped(unit.size()).trimmed();
    }
    return number;
}

double NumberBox::valueFromText(const QString& text) const {
    return numberFromText(withoutUnit(text)).value_or(value());
}

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const {
    const std::optional<double> number = numberFromText(withoutUnit(text));
    const bool isTaken = number && *number >= minimum() && *number <= maximum();
    return isTaken ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberBox::fixup(QString& text) const {
    QToolTip::showText(mapToGlobal(rect().bottomLeft()),
                       tr("“%1” is not taken: a number from %2 to %3, such as 0.5 or 2e-3")
                           .arg(withoutUnit(text))
                           .arg(minimum())
                           .arg(maximum()),
                       const_cast<NumberBox*>(this));  // NOLINT: only its place is used
}

}  // namespace asperity
