#include "ui/panels/RefusalLine.h"

#include "ui/Theme.h"
#include "ui/panels/NumberBox.h"

#include <QLineEdit>

namespace asperity {

namespace {

constexpr int kRounding = 2;  ///< of the height of lines [px]

}  // namespace

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

}  // namespace asperity
