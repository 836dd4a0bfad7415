#include "core/surface/foot/FootSearch.h"

#include "core/surface/foot/CellSweep.h"

#include <boost/container/static_vector.hpp>

namespace asperity {

namespace {

/// Looks into cells as a sweep names them, a batch at a time.
class CellsInBatches {
public:
    CellsInBatches(const BSplineSurface& surface, PartSearch& search)
        : surface_(surface), search_(search) {}

    [[nodiscard]] double limit() const { return search_.limit(); }
    [[nodiscard]] bool mayLook() { return search_.mayLook(); }

    void take(const CellIndex& cell) {
        cells_.push_back(cell);
        if (cells_.size() == cells_.capacity()) {
            lookIntoCells();
        }
    }

    void lookIntoCells() {
        if (cells_.empty()) {
            return;
        }
        PartBatch batch;
        loadCells(surface_.grid(), {cells_.data(), cells_.size()}, batch);
        search_.lookInto(batch, (1U << cells_.size()) - 1U);
        cells_.clear();
    }

private:
    const BSplineSurface& surface_;
    PartSearch& search_;
    boost::container::static_vector<CellIndex, PartBatch::kLanes> cells_;
};

}  // namespace

FootProof completeFeet(const BSplineSurface& surface, const Vector3& query, const FootReach& reach,
                       FootList& feet) noexcept {
    PartSearch search(surface, query, reach, feet);
    CellSweep sweep(surface, query, search.limit());
    for (const SurfaceFoot& foot : feet.all()) {
        if (foot.converged &&
            sweep.settle(sweep.window().blocksAround(foot.point.x(), foot.point.y(), 0.0))) {
            break;
        }
    }
    CellsInBatches cells(surface, search);
    sweep.visit(cells);
    cells.lookIntoCells();
    return search.isComplete() ? FootProof::Nearest : FootProof::ManyFeet;
}

}  // namespace asperity
