#include "ui/view/SurfaceReading.h"

#include "ui/ColorScale.h"
#include "ui/Steady.h"

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

/// In nanometers or larger units, to a hundredth of the unit: what is smaller is no length here.
QString lengthText(double meters) {
    const SiScale scale = siScaleFor(std::max(std::abs(meters), 1e-9), "m");
    return QString::fromStdString(scaledText(meters, scale, scale.unit == "nm" ? 2 : 4));
}

}  // namespace

QString textOf(const SurfaceReading& reading) {
    QString text = QStringLiteral("x %1   y %2   z %3")
                       .arg(lengthText(reading.place.x()), lengthText(reading.place.y()),
                            lengthText(reading.place.z()));
    if (!reading.quantity.isEmpty()) {
        text += QStringLiteral("   %1 %2")
                    .arg(reading.quantity, shownValue(reading.value, reading.unit));
    }
    return text;
}

}  // namespace asperity
