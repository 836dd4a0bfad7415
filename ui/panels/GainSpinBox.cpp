#include "ui/panels/GainSpinBox.h"

#include "vtkplugins/pictures/Ticks.h"

#include <cmath>
#include <cstdlib>

namespace asperity {

namespace {

constexpr int kGainDecimals = 12;  ///< of the smallest gain

double nextAbove(double value) {
    const double here = niceBelow(value);
    const double digit = std::round(here / std::pow(10.0, std::floor(std::log10(here * 1.01))));
    return here * (digit == 2.0 ? 2.5 : 2.0);
}

double nextBelow(double value) {
    const double below = niceBelow(value);
    // Not on a step yet: the step below comes first.
    return below < value * (1.0 - 1e-6) ? below : niceBelow(value / 1.9);
}

}  // namespace

GainSpinBox::GainSpinBox(double low, double high, QWidget* parent) : NumberBox(parent) {
    setDecimals(kGainDecimals);
    setRange(low, high);
}

void GainSpinBox::stepBy(int steps) {
    double next = value();
    for (int i = 0; i < std::abs(steps); ++i) {
        next = steps > 0 ? nextAbove(next) : nextBelow(next);
    }
    setValue(next);
}

}  // namespace asperity
