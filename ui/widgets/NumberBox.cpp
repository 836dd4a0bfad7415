#include "ui/widgets/NumberBox.h"

#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"
#include "vtkplugins/pictures/Ticks.h"

#include <QDialogButtonBox>
#include <QEvent>
#include <QFormLayout>
#include <QMenu>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStyleOptionComboBox>
#include <QStylePainter>
#include <QToolTip>
#include <QVBoxLayout>
#include <QWidget>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace asperity {

namespace {

constexpr int kMinDigits = 4;   ///< before a power of ten is shorter
constexpr int kMaxDigits = 12;  ///< the others are of units and rounding
constexpr int kMaxQuoted = 24;  ///< letters of what was typed

constexpr int kGainDecimals = 12;  ///< of the smallest gain

double nextAbove(double value) {
    const double here = niceBelow(value);
    const double digit = std::round(here / std::pow(10.0, std::floor(std::log10(here * 1.01))));
    return here * (digit == 2.0 ? 2.5 : 2.0);
}

double nextBelow(double value) {
    const double below = niceBelow(value);
    // Not on a step yet: the step below comes first.
    return below < value * (1.0 - 1e-6) ? below : niceBelow(value / 1.9);
}

constexpr double kLow = 1e-9;  ///< stands for none
constexpr double kHigh = 1e9;

constexpr int kRounding = 2;  ///< of the height of lines [px]

class WheelGuard : public QObject {
public:
    using QObject::QObject;

    bool eventFilter(QObject* watched, QEvent* event) override {
        const auto* knob = qobject_cast<QWidget*>(watched);
        if (event->type() == QEvent::Wheel && knob != nullptr && !knob->hasFocus()) {
            event->ignore();
            return true;
        }
        return QObject::eventFilter(watched, event);
    }
};

constexpr int kNumberDecimals = 12;  ///< of the smallest number

constexpr int kMaxChoiceLetters = 24;  ///< that a box has room for
constexpr int kMinLetters = 8;         ///< same where it is as narrow as can be
constexpr int kStyleMargin = 2;        ///< beside the letters, within their room [px]
/// Letters are wider than measured where a pixel of the window is 1.5 of the screen [px].
constexpr int kChoiceRoom = 4;

}  // namespace

bool TextBox::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        isForWindowHistory(static_cast<QKeyEvent&>(*event), *this)) {
        event->ignore();
        return false;
    }
    return QLineEdit::event(event);
}

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

/// Words that stand for the smallest number.
bool NumberBox::isSpecial(const QString& text) const {
    return !specialValueText().isEmpty() && text == specialValueText();
}

double NumberBox::valueFromText(const QString& text) const {
    if (isSpecial(text)) {
        return minimum();
    }
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
    const std::optional<double> number =
        isSpecial(text) ? minimum() : numberFromText(withoutUnit(text));
    const bool isTaken = number && *number >= minimum() && *number <= maximum();
    return isTaken ? QValidator::Acceptable : QValidator::Intermediate;
}

void NumberBox::fixup(QString& text) const {
    QString typed = withoutUnit(text);
    if (typed.size() > kMaxQuoted) {
        typed = typed.left(kMaxQuoted) + QStringLiteral("…");
    }
    const QString reason = tr("“%1” is not valid: a number from %2 to %3, such as 0.5 or 2e-3")
                               .arg(typed, textFromValue(minimum()), textFromValue(maximum()));
    QToolTip::showText(mapToGlobal(rect().bottomLeft()), reason,
                       const_cast<NumberBox*>(this));  // NOLINT: only its address is used
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

GainSpinBox::GainSpinBox(double low, double high, QWidget* parent) : NumberBox(parent) {
    setDecimals(kGainDecimals);
    setRange(low, high);
}

void GainSpinBox::stepBy(int steps) {
    double next = value();
    for (int i = 0; i < std::abs(steps); ++i) {
        next = steps > 0 ? nextAbove(next) : nextBelow(next);
    }
    setValue(next);
}

UsualBox::UsualBox(double low, double high, QWidget* parent)
    : GainSpinBox(low, high, parent), usual_(low) {
    setMuted(true);
    connect(lineEdit(), &QLineEdit::textEdited, this,
            [this](const QString& text) { isEmptied_ = text.trimmed().isEmpty(); });
    connect(this, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double number) {
        typed_ = isEmptied_ ? std::nullopt : std::optional(number);
        setMuted(!typed_);
    });
    connect(this, &QAbstractSpinBox::editingFinished, this, [this] {
        if (std::exchange(isEmptied_, false)) {
            typed_.reset();
            showNumber();
        }
    });
}

void UsualBox::setUsual(double usual, double least) {
    usual_ = usual;
    const QSignalBlocker blocker(this);  // a number below the limit is still the one that was typed
    setMinimum(least);
    showNumber();
}

void UsualBox::showNumber() {
    const QSignalBlocker blocker(this);
    setValue(typed_.value_or(usual_));
    setMuted(!typed_);
}

QValidator::State UsualBox::validate(QString& text, int& position) const {
    return text.trimmed().isEmpty() ? QValidator::Acceptable
                                    : GainSpinBox::validate(text, position);
}

double UsualBox::valueFromText(const QString& text) const {
    return text.trimmed().isEmpty() ? usual_ : GainSpinBox::valueFromText(text);
}

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

RefusalLine::RefusalLine(QWidget* boxes) : QLabel(boxes) {
    setObjectName(QStringLiteral("refusal"));
    setTextFormat(Qt::PlainText);
    setWordWrap(true);
    setFont(theme::textFont(theme::kSmallSize));
    setMinimumHeight(2 * fontMetrics().lineSpacing() + kRounding);  // so that nothing moves
    theme::colorText(*this, &ThemeColors::fault);
    for (const NumberBox* box : boxes->findChildren<NumberBox*>()) {
        connect(box, &NumberBox::refused, this, &QLabel::setText);
        connect(box->findChild<QLineEdit*>(), &QLineEdit::textEdited, this, &QLabel::clear);
        connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this, &QLabel::clear);
    }
}

void guardFromWheel(QWidget& knob) {
    knob.setFocusPolicy(Qt::StrongFocus);
    knob.installEventFilter(new WheelGuard(&knob));
}

NumbersDialog::NumbersDialog(const QString& title, const std::vector<Number>& numbers, Check check,
                             QWidget* parent)
    : QDialog(parent), refusal_(nullptr), check_(std::move(check)) {
    setWindowTitle(title);
    setAttribute(Qt::WA_DeleteOnClose);
    auto* rows = new QVBoxLayout(this);
    auto* form = new QFormLayout;
    for (const Number& number : numbers) {
        auto* box = new NumberBox(this);
        box->setDecimals(kNumberDecimals);
        box->setRange(number.low, number.high);
        box->setSuffix(number.unit.isEmpty() ? QString() : QLatin1Char(' ') + number.unit);
        box->setValue(number.value);
        box->setToolTip(number.toolTip);
        form->addRow(number.label, box);
        boxes_.push_back(box);
    }
    rows->addLayout(form);
    refusal_ = new RefusalLine(this);
    refusal_->setToolTip(tr("Why a number is not valid"));
    rows->addWidget(refusal_);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    buttons->button(QDialogButtonBox::Ok)->setToolTip(tr("Apply the numbers"));
    buttons->button(QDialogButtonBox::Cancel)->setToolTip(tr("Leave all as it is"));
    rows->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &NumbersDialog::finish);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    if (!boxes_.empty()) {
        boxes_.front()->selectAll();
        boxes_.front()->setFocus();
    }
}

QWidget* windowOf(const QMenu& menu) {
    QWidget* holder = menu.parentWidget();
    while (qobject_cast<QMenu*>(holder) != nullptr) {
        holder = holder->parentWidget();
    }
    return holder != nullptr ? holder->window() : nullptr;
}

void NumbersDialog::finish() {
    std::vector<double> values;
    for (NumberBox* box : boxes_) {
        box->interpretText();
        values.push_back(box->value());
    }
    const QString reason = check_(values);
    refusal_->setText(reason);
    if (reason.isEmpty()) {
        Q_EMIT given(values);
        accept();
    }
}

ChoiceBox::ChoiceBox(QWidget* parent) : QComboBox(parent) {
    setMinimumContentsLength(kMinLetters);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    connect(this, &QComboBox::currentTextChanged, this, [this] { updateGeometry(); });
}

void ChoiceBox::setNames(const QStringList& names) {
    const QSignalBlocker blocker(this);
    clear();
    addItems(names);
    for (int i = 0; i < names.size(); ++i) {
        setItemData(i, names.at(i), Qt::ToolTipRole);  // the box may be too narrow for it
    }
    updateGeometry();
}

int ChoiceBox::textRoom(int width) const {
    QStyleOptionComboBox option;
    initStyleOption(&option);
    option.rect = QRect(0, 0, width, height());
    const QRect field =
        style()->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, this);
    return field.width() - kStyleMargin;
}

QString ChoiceBox::shownText() const {
    return fontMetrics().elidedText(currentText(), Qt::ElideRight, textRoom(width()));
}

QSize ChoiceBox::sizeHint() const {
    constexpr int kAnyWidth = 400;  // [px]
    const QSize narrow = QComboBox::sizeHint();
    const QString text = currentText().size() > kMaxChoiceLetters
                             ? currentText().left(kMaxChoiceLetters - 1) + QStringLiteral("…")
                             : currentText();
    const int around = kAnyWidth - textRoom(kAnyWidth) + kChoiceRoom;
    return {std::max(narrow.width(), fontMetrics().horizontalAdvance(text) + around),
            narrow.height()};
}

void ChoiceBox::paintEvent(QPaintEvent* /*event*/) {
    QStylePainter painter(this);
    painter.setPen(palette().color(QPalette::Text));
    QStyleOptionComboBox option;
    initStyleOption(&option);
    painter.drawComplexControl(QStyle::CC_ComboBox, option);
    option.currentText = shownText();
    painter.drawControl(QStyle::CE_ComboBoxLabel, option);
}

}  // namespace asperity
