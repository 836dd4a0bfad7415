#pragma once

#include <QString>

namespace asperity {

/// A share in percent with two digits, whole numbers from ten on: "0.12", "7.0", "295".
[[nodiscard]] inline QString percentText(double share) {
    const double percent = 100.0 * share;
    if (percent >= 1.0) {
        return QString::number(percent, 'f', percent < 9.95 ? 1 : 0);
    }
    return QString::number(percent, 'g', 2);
}

}  // namespace asperity
