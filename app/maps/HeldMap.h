#pragma once

#include "app/maps/MapPart.h"
#include "app/program/LoadedScene.h"
#include "core/PrivateFolder.h"
#include "core/surface/RegionField.h"

namespace asperity {

/// A map with the scene that it is of. Its rows lie in a temporary file, which goes with it.
class HeldMap {
public:
    /// @throw Error where the temporary file cannot be made
    HeldMap(LoadedScene loaded, const MapPlan& plan);

    [[nodiscard]] const LoadedScene& loaded() const { return loaded_; }
    [[nodiscard]] const MapPlan& plan() const { return plan_; }
    [[nodiscard]] MapPart& part() { return part_; }
    [[nodiscard]] const MapPart& part() const { return part_; }

    // Not while rows are computed.

    /// A quantity of the plan over the region; not a number where a pixel has no value, or its row
    /// is not there. @throw Error
    [[nodiscard]] RegionField field(MapQuantity quantity) const;
    /// What the map has at a pixel, row 0 at the top; likewise. @throw Error
    [[nodiscard]] MapValues valuesAt(int row, int column) const;

private:
    PrivateFolder folder_;
    LoadedScene loaded_;
    MapPlan plan_;
    MapPart part_;
};

}  // namespace asperity
