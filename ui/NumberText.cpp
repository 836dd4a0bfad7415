#include "ui/NumberText.h"

#include "ui/Steady.h"

#include <clocale>
#include <cmath>

namespace asperity {

std::optional<double> numberFromText(const QString& text, const QLocale& locale) {
    for (QLocale form : {QLocale::c(), locale}) {
        form.setNumberOptions(QLocale::RejectGroupSeparator);
        bool isNumber = false;
        const double value = form.toDouble(text.trimmed(), &isNumber);
        if (isNumber && std::isfinite(value)) {
            return value;
        }
    }
    return std::nullopt;
}

QString siText(double value, const char* unit) {
    return QString::fromStdString(formatSi(value, unit));
}

QString threeDigits(double value, const SiScale& scale) {
    return QString::fromStdString(threeDigitText(value, scale));
}

void keepDecimalPoint() {
    (void)std::setlocale(LC_NUMERIC, "C");  // NOLINT(concurrency-mt-unsafe): no threads yet
}

}  // namespace asperity
