#include "core/FormattedText.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

namespace asperity {

std::string formatted(const char* format, ...) {
    char text[512];
    std::va_list values;
    va_start(values, format);
    std::vsnprintf(text, sizeof text, format, values);
    va_end(values);
    return text;
}

std::string durationText(double seconds) {
    const long whole = std::lround(seconds);
    constexpr long kMinute = 60;
    constexpr long kHour = 60 * kMinute;
    if (whole < 2 * kMinute) {
        return std::to_string(whole) + " s";
    }
    if (whole < 2 * kHour) {
        return std::to_string((whole + kMinute / 2) / kMinute) + " min";
    }
    return formatted("%.1f h", seconds / kHour);
}

}  // namespace asperity
