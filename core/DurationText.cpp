#include "core/DurationText.h"

#include "core/FormattedText.h"

#include <cmath>

namespace asperity {

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
