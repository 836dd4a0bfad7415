#include "app/maps/ComparedMap.h"

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

std::vector<double> predictedBy(const MapPlan& plan, const MapPart& part, std::size_t place) {
    const auto columns = static_cast<std::size_t>(plan.grid.columns);
    std::vector<double> values(columns * static_cast<std::size_t>(plan.grid.rows));
    for (int row = 0; row < plan.grid.rows; ++row) {
        part.read(row, place, values.data() + static_cast<std::size_t>(row) * columns);
    }
    return values;
}

/// Of measured and predicted values, row by row.
template <class Value>
RowReader readerOf(const ComparedMap& compared, const MapPart& part, Value value) {
    return
        [&compared, rows = static_cast<std::size_t>(part.rows()), value](int row, double* values) {
            const std::vector<double>& measured = compared.values.measured;
            const std::vector<double>& predicted = compared.values.predicted;
            const std::size_t columns = measured.size() / rows;
            const std::size_t first = static_cast<std::size_t>(row) * columns;
            for (std::size_t column = 0; column < columns; ++column) {
                values[column] = value(measured[first + column], predicted[first + column]);
            }
        };
}

}  // namespace

std::vector<ComparedMap> comparedMaps(std::vector<MeasuredChannel> channels, const MapPlan& plan,
                                      const MapPart& part) {
    std::vector<ComparedMap> maps;
    for (MeasuredChannel& channel : channels) {
        const auto place = static_cast<std::size_t>(
            std::ranges::find(plan.quantities, channel.quantity) - plan.quantities.begin());
        const auto before = std::ranges::count(maps, channel.quantity, &ComparedMap::quantity);
        maps.push_back(
            {.channel = std::move(channel.name),
             .quantity = channel.quantity,
             .grid = channel.grid,
             .place = place,
             .number = static_cast<int>(before) + 1,
             .values = compareQuantity(plan, channel.quantity, predictedBy(plan, part, place),
                                       std::move(channel.values))});
    }
    return maps;
}

std::vector<ComparisonLayer> layersOf(const ComparedMap& compared, const MapPart& part) {
    const MapQuantityRow& quantity = *rowOf(compared.quantity);
    const std::string end = compared.number > 1 ? "_" + std::to_string(compared.number) : "";
    const std::string names = std::string(quantity.name) + ", '" + compared.channel + "'";
    return {{.key = std::string(quantity.key) + "_difference" + end,
             .name = names + " minus predicted",
             .readRow =
                 readerOf(compared, part,
                          [](double measured, double predicted) { return measured - predicted; })},
            {.key = std::string(quantity.key) + "_residual" + end,
             .name = names + " minus its line over the prediction",
             .readRow = readerOf(compared, part, [&compared](double measured, double predicted) {
                 return compared.values.numbers.residual(measured, predicted);
             })}};
}

}  // namespace asperity
