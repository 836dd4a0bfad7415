#include "app/reports/run/MeasuredText.h"

#include "core/FormattedText.h"

#include <algorithm>
#include <cmath>

namespace asperity {

std::string numberText(double value, const SiScale& scale) {
    if (value == 0.0) {
        return "0";  // never "-0"
    }
    std::string text = formatted("%#.4g", value * scale.factor);  // with zeros at the end
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return text;
}

std::string measuredText(const Reading& reading, const SiScale& scale) {
    const double sigma = reading.sigma * scale.factor;
    if (!(sigma > 0.0) || !std::isfinite(sigma)) {
        return numberText(reading.value, scale);
    }
    constexpr int kMostDecimals = 6;
    const int decimals =
        std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, kMostDecimals);
    // No-break spaces: a table must not part them.
    return formatted("%.*f\u00A0±\u00A0%.*f", decimals, reading.value * scale.factor, decimals,
                     sigma);
}

std::string noisyText(const Reading& reading, const SiScale& scale) {
    const std::string text = measuredText(reading, scale);
    return text.find("±") != std::string::npos ? text + "\u00A0(noise)" : text;
}

std::string measuredText(const Reading& reading, const std::string& unit) {
    const SiScale scale = siScaleFor(reading.value, unit);
    const std::string text = measuredText(reading, scale);
    const bool hasSigma = text.find("±") != std::string::npos;
    return hasSigma ? "(" + text + ") " + scale.unit : text + " " + scale.unit;
}

std::string capitalized(std::string sentence) {
    if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') {
        sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    }
    return sentence;
}

std::string shareText(long part, long whole) {
    if (part == 0 || whole == 0) {
        return "0\u00A0%";
    }
    const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    return percent < 0.1 ? "<\u00A00.1\u00A0%" : formatted("%.1f\u00A0%%", percent);
}

}  // namespace asperity
