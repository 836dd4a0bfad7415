#include "app/maps/MapRun.h"

#include "core/ShareOut.h"
#include "core/map/MapRow.h"

#include <vector>

namespace asperity {

void computeMap(const Scene& scene, const MapPlan& plan, MapPart& part, int threads,
                Progress* progress) {
    std::vector<int> missing;
    for (int row = 0; row < part.rows(); ++row) {
        if (!part.has(row)) {
            missing.push_back(row);
        }
    }
    if (missing.empty()) {
        return;
    }
    const MapInstrument instrument(scene, plan.truth);
    ProgressPart rest(progress, static_cast<double>(part.count()) / part.rows(), 1.0);
    shareOut(
        static_cast<int>(missing.size()), &rest,
        [&](int index, const CancelCheck& check) {
            const int row = missing[static_cast<std::size_t>(index)];
            part.keep(row, mapRow(instrument, plan, row, check));
        },
        threads);
}

}  // namespace asperity
