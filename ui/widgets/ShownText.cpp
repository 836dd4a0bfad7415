#include "ui/widgets/ShownText.h"

#include "core/PrintableText.h"
#include "ui/widgets/Steady.h"

#include <QCoreApplication>
#include <QFile>

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
    constexpr double kSmallLength = 0.9995e-9;  // [m]
    constexpr double kPicometer = 1e-12;        // [m]
    const bool isSmallLength =
        std::string_view(unit) == "m" && value != 0.0 && std::abs(value) < kSmallLength;
    return isSmallLength ? QStringLiteral("%1 pm").arg(std::lround(value / kPicometer))
                         : QString::fromStdString(formatSi(value, unit));
}

QString threeDigits(double value, const SiScale& scale) {
    return QString::fromStdString(threeDigitText(value, scale));
}

void keepDecimalPoint() {
    (void)std::setlocale(LC_NUMERIC, "C");  // NOLINT(concurrency-mt-unsafe): no threads yet
}

QString coreWords(const char* text) { return QCoreApplication::translate("asperity::core", text); }

QString coreWords(const std::string& text) { return coreWords(text.c_str()); }

QString shownPath(const std::filesystem::path& path) {
    return QString::fromStdString(printable(path.string()));
}

std::filesystem::path pathOf(const QString& file) { return QFile::encodeName(file).toStdString(); }

}  // namespace asperity
