#include "ui/panels/NumberBox.h"

#include "ui/NumberText.h"
#include "ui/Theme.h"
#include "ui/panels/LineHistory.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QToolTip>

namespace asperity {

namespace {

constexpr int kMinDigits = 4;   ///< before a power of ten is shorter
constexpr int kMaxDigits = 12;  ///< the others are of units and rounding
constexpr int kMaxQuoted = 24;  ///< letters of what was typed

}  // namespace

NumberBox::NumberBox(QWidget* parent) : QDoubleSpinBox(parent) {
    setLocale(QLocale::c());
    setKeyboardTracking(false);
    const auto color = [this] { colorText(); };
    connect(lineEdit(), &QLineEdit::textChanged, this, color);
    connect(this, &QAbstractSpinBox::editingFinished, this, color);  // by Qt's own text
    const auto unmark = [this] { mark(false); };
    connect(lineEdit(), &QLineEdit::textEdited, this, unmark);
    connect(this, qOverload<double>(&QDoubleSpinBox::valueChanged), this, unmark);
    theme::follow(this, [this] {
        colorText();
        mark(refused_);
    });
}

void NumberBox::colorText() {
    const QColor usual = muted_ ? theme::colors().muted : theme::colors().ink;
    QPalette colors = lineEdit()->palette();
    // What the program sets is right, also while limits and text follow one another.
    const bool isWrong = lineEdit()->isModified() && !lineEdit()->hasAcceptableInput();
    colors.setColor(QPalette::Text, isWrong ? theme::colors().fault : usual);
    colors.setColor(QPalette::Disabled, QPalette::Text, theme::colors().muted);
    lineEdit()->setPalette(colors);
}

void NumberBox::setMuted(bool muted) {
    muted_ = muted;
    colorText();
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

QString NumberBox::textFromValue(double value) const {
    const double shown = QString::number(value, 'g', kMaxDigits).toDouble();
    QString text;
    for (int digits = kMinDigits; digits <= kMaxDigits; ++digits) {
        text = QString::number(shown, 'g', digits);
        if (text.toDouble() == shown) {
            break;
        }
    }
    return text.replace(QStringLiteral("e+0"), QStringLiteral("e"))
        .replace(QStringLiteral("e+"), QStringLiteral("e"))
        .replace(QStringLiteral("e-0"), QStringLiteral("e-"));
}

QValidator::State NumberBox::validate(QString& text, int& /*position*/) const {
    const std::optional<double> number = numberFromText(withoutUnit(text));
    const bool isTaken = number && *number >= minimum() && *number <= maximum();
    return isTaken ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberBox::fixup(QString& text) const {
    QString typed = withoutUnit(text);
    if (typed.size() > kMaxQuoted) {
        typed = typed.left(kMaxQuoted) + QStringLiteral("…");
    }
    const QString reason = tr("“%1” is not taken: a number from %2 to %3, such as 0.5 or 2e-3")
                               .arg(typed, textFromValue(minimum()), textFromValue(maximum()));
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), reason,
                       const_cast<NumberBox*>(this));  // NOLINT: only its place is used
    mark(true);
    Q_EMIT refused(reason);
}

void NumberBox::discardTyped() {
    setValue(value());
    mark(false);
}

bool NumberBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        auto& key = static_cast<QKeyEvent&>(*event);
        if (isForWindowHistory(key, *lineEdit())) {
            key.ignore();
            return false;
        }
    }
    return QDoubleSpinBox::event(event);
}

void NumberBox::mark(bool refused) const {
    QPalette colors = lineEdit()->palette();
    colors.setColor(QPalette::Base, refused ? theme::colors().refused : theme::colors().paper);
    colors.setColor(QPalette::Disabled, QPalette::Base, theme::colors().window);
    lineEdit()->setPalette(colors);
    refused_ = refused;
}

}  // namespace asperity
