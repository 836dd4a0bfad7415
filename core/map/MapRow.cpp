#include "core/map/MapRow.h"

#include "core/map/MapDeviations.h"
#include "core/map/PixelCycle.h"
#include "core/map/RasterLine.h"

namespace asperity {

namespace {

std::vector<MapValues> cyclesOf(const MapInstrument& instrument, const MapPlan& plan, int row,
                                const CancelCheck& check) {
    std::vector<MapValues> pixels;
    const bool deviates = hasDeviations(plan);
    for (int column = 0; column < plan.grid.columns; ++column) {
        check();
        VerticalPath path(instrument, plan.place(row, column));
        const CycleStates states = runCycle(path, plan.setpoint);
        pixels.push_back(valuesOf(states, path));
        if (deviates && states.engaged) {
            takeDeviations(instrument.scene(), states.engaged->atSetpoint.state, pixels.back());
        }
    }
    return pixels;
}

}  // namespace

std::vector<double> mapRow(const MapInstrument& instrument, const MapPlan& plan, int row,
                           const CancelCheck& check) {
    const std::vector<MapValues> pixels = plan.mode == MapMode::Approach
                                              ? cyclesOf(instrument, plan, row, check)
                                              : rasterLine(instrument, plan, row, check);
    std::vector<double> values;
    values.reserve(plan.quantities.size() * pixels.size());
    for (const MapQuantity quantity : plan.quantities) {
        for (const MapValues& pixel : pixels) {
            values.push_back(pixel[quantity]);
        }
    }
    return values;
}

}  // namespace asperity
