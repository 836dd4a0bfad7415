#include "ui/NumberText.h"

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

void keepDecimalPoint() {
    (void)std::setlocale(LC_NUMERIC, "C");  // NOLINT(concurrency-mt-unsafe): no threads yet
}

}  // namespace asperity
