#include "app/maps/MapSheets.h"

#include "app/maps/UnknownDeviations.h"
#include "core/SiFormat.h"

#include <algorithm>
#include <span>

namespace asperity {

namespace {

constexpr int kMaxPixels = 1024;  // along a side, as drawn
constexpr std::size_t kMapsPerSheet = 6;

/// Every how many pixels one is drawn.
int strideOf(const MapGrid& grid) {
    return (std::max(grid.columns, grid.rows) + kMaxPixels - 1) / kMaxPixels;
}

/// @param place of the quantity in the plan
SheetMap sheetMap(const MapPlan& plan, const MapPart& part, std::size_t place) {
    const MapQuantityRow& quantity = *rowOf(plan.quantities[place]);
    const bool hasBlanks = !unknownDeviations(plan, part, place).empty();
    return sheetMap(plan, quantity.name + std::string(hasBlanks ? " (blank: unknown)" : ""),
                    quantity.unit, [&](int row, double* values) { part.read(row, place, values); });
}

/// Places in the plan of the quantities that are drawn.
std::vector<std::size_t> shownOf(const MapPlan& plan) {
    std::vector<std::size_t> shown;
    for (std::size_t i = 0; i < plan.quantities.size(); ++i) {
        if (plan.quantities[i] != MapQuantity::Validity) {
            shown.push_back(i);
        }
    }
    return shown;
}

std::string titleOf(const MapPlan& plan) {
    return "Force map: mode " + std::string(keyOf(plan.mode)) + ", setpoint " +
           formatSi(plan.setpoint, "N") + ", " +
           formatSi(plan.region.right - plan.region.left, "m") + " x " +
           formatSi(plan.region.top - plan.region.bottom, "m") + ", " +
           (plan.truth ? "true instrument" : "believed model") + "; colors: 1st to 99th percentile";
}

}  // namespace

SheetMap sheetMap(const MapPlan& plan, const std::string& name, const char* unit,
                  const RowReader& readRow) {
    const int stride = strideOf(plan.grid);
    SheetMap map{.quantity = name,
                 .unit = unit,
                 .columns = (plan.grid.columns + stride - 1) / stride,
                 .rows = (plan.grid.rows + stride - 1) / stride,
                 .width = plan.region.right - plan.region.left,
                 .height = plan.region.top - plan.region.bottom,
                 .values = {}};
    std::vector<double> values(static_cast<std::size_t>(plan.grid.columns));
    for (int drawn = 0; drawn < plan.grid.rows; drawn += stride) {
        readRow(drawn, values.data());
        for (std::size_t column = 0; column < values.size();
             column += static_cast<std::size_t>(stride)) {
            map.values.push_back(values[column]);
        }
    }
    return map;
}

std::vector<std::filesystem::path> filesOf(const MapFiles& files, const MapPlan& plan,
                                           bool withSheets) {
    std::vector<std::filesystem::path> all{files.gwy(), files.vti(), files.exr()};
    const std::size_t drawn = withSheets ? shownOf(plan).size() : 0;
    for (std::size_t first = 0; first < drawn; first += kMapsPerSheet) {
        all.push_back(files.sheet(static_cast<int>(1 + (first / kMapsPerSheet))));
    }
    return all;
}

void writeMapSheets(const MapFiles& files, const MapPlan& plan, const MapPart& part) {
    const std::vector<std::size_t> shown = shownOf(plan);
    int sheets = 0;
    for (std::size_t first = 0; first < shown.size(); first += kMapsPerSheet) {
        std::vector<SheetMap> maps;
        for (std::size_t i = first; i < std::min(first + kMapsPerSheet, shown.size()); ++i) {
            maps.push_back(sheetMap(plan, part, shown[i]));
        }
        writeMapSheet(files.sheet(++sheets), titleOf(plan), maps);
    }
}

}  // namespace asperity
