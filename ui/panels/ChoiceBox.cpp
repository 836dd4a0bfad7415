#include "ui/panels/ChoiceBox.h"

#include <QSignalBlocker>
#include <QStyleOptionComboBox>
#include <QStylePainter>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kMaxChoiceLetters = 24;  ///< that a box has room for
constexpr int kMinLetters = 8;         ///< likewise where it is as narrow as can be
constexpr int kStyleMargin = 2;        ///< beside the letters, within their room [px]
/// Letters are wider than measured where a pixel of the window is 1.5 of the screen [px].
constexpr int kChoiceRoom = 4;

}  // namespace

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
