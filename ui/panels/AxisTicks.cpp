#include "ui/panels/AxisTicks.h"

#include "vtkplugins/pictures/Ticks.h"

namespace asperity {

std::vector<double> axisTicks(double low, double high, int room) {
    constexpr int kMaxTicks = 6;
    std::vector<double> ticks = niceTicks(low, high, room);
    for (int count = room + 1; ticks.size() < 2 && count <= kMaxTicks; ++count) {
        ticks = niceTicks(low, high, count);
    }
    if (ticks.size() > 2 && static_cast<int>(ticks.size()) > room + 1) {
        ticks = {ticks.front(), ticks.back()};  // more would lie on one another
    }
    return ticks;
}

}  // namespace asperity
