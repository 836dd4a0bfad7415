#include "app/maps/UnknownDeviations.h"

#include "core/FormattedText.h"
#include "core/map/MapDeviations.h"

#include <algorithm>
#include <cmath>

namespace asperity {

std::string unknownDeviations(const MapPlan& plan, const MapPart& part, std::size_t place) {
    if (!isDeviation(plan.quantities[place])) {
        return {};
    }
    std::vector<double> values(static_cast<std::size_t>(plan.grid.columns));
    long unknown = 0;
    long computed = 0;
    for (int row = 0; row < plan.grid.rows; ++row) {
        if (part.has(row)) {
            part.read(row, place, values.data());
            unknown +=
                std::ranges::count_if(values, [](double value) { return std::isnan(value); });
            computed += plan.grid.columns;
        }
    }
    return unknown == 0 ? std::string()
                        : formatted("unknown in %ld of %ld pixels, not 0: several contacts carry "
                                    "there, or there is no such value",
                                    unknown, computed);
}

std::vector<std::string> unknownDeviations(const MapPlan& plan, const MapPart& part) {
    std::vector<std::string> sentences;
    for (std::size_t place = 0; place < plan.quantities.size(); ++place) {
        const std::string sentence = unknownDeviations(plan, part, place);
        if (!sentence.empty()) {
            sentences.push_back(std::string(rowOf(plan.quantities[place])->name) + ": " + sentence);
        }
    }
    return sentences;
}

}  // namespace asperity
