#pragma once

#include "core/surface/closest/LocalClosestPoint.h"
#include "core/surface/closest/PartFacts.h"
#include "tests/core/surface/closest/RoughSurface.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

namespace asperity::test {

inline std::vector<RoughMap> mapsOfParts() {
    return {
        {.name = "Noise", .columns = 20, .rows = 17, .range = 5.0_nm},
        {.name = "Smooth", .columns = 20, .rows = 17, .range = 60.0_nm, .smoothing = 2.0},
        {.name = "WidePixels", .columns = 12, .rows = 15, .pitchX = 7.0_nm, .range = 10.0_nm},
        {.name = "FarOff", .columns = 12, .rows = 15, .range = 5.0_nm, .offset = 1e-3},
        {.name = "SingleRow", .columns = 20, .rows = 1, .range = 5.0_nm},
        {.name = "SingleColumn", .columns = 1, .rows = 20, .range = 5.0_nm},
        {.name = "TwoByTwo", .columns = 2, .rows = 2, .range = 5.0_nm},
        {.name = "FinePixels",
         .columns = 20,
         .rows = 17,
         .pitchX = 0.2_nm,
         .pitchY = 0.3_nm,
         .range = 9.0_nm,
         .smoothing = 3.0},
    };
}

/// Parts of cells of rough surfaces.
class PartsOf : public testing::TestWithParam<RoughMap> {
protected:
    BSplineSurface surface_ = surfaceOf(GetParam());
    Random random_{9};

    /// Four cells, or quarters of quarters of one of them.
    PartBatch randomBatch(int quarterings) {
        const CellBounds::Level& cells = surface_.bounds().level(0);
        const auto below = [&](int count) { return static_cast<int>(random_.uniform() * count); };
        std::array<CellIndex, 4> chosen;
        for (CellIndex& cell : chosen) {
            cell = {.row = below(cells.rows), .column = below(cells.columns)};
        }
        PartBatch batch;
        loadCells(surface_.grid(), chosen, batch);
        for (int i = 0; i < quarterings; ++i) {
            const PartBatch whole = batch;
            quarter(whole, below(PartBatch::kLanes), batch);
        }
        return batch;
    }
    [[nodiscard]] double aboveDatum(double x, double y) const {
        return surface_.at(x, y).height - surface_.grid().datum;
    }
    /// Half the squared distance, its gradient and second derivatives.
    [[nodiscard]] LocalModel modelAt(const Vector3& query, double x, double y) const {
        return HalfSquaredDistance(surface_, query)({x, y});
    }
    Vector3 queryAbove(const PartBatch& batch, double height) {
        const double x = batch.centerX[0] + random_.normal() * 4.0_nm;
        const double y = batch.centerY[0] + random_.normal() * 4.0_nm;
        return {x, y, surface_.at(x, y).height + height};
    }
};

}  // namespace asperity::test
