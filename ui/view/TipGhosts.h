#pragma once

#include "ui/view/GhostLayer.h"
#include "ui/view/ViewLabels.h"
#include "ui/view/ViewOptions.h"

#include <optional>
#include <vector>

namespace asperity {

/// The ghosts of the tip: where it would be without forces, and where it really is.
class TipGhosts {
public:
    /// @param through what is drawn there shows through everything
    explicit TipGhosts(vtkRenderer* through) : commanded_(through), true_(through) {}

    /// Shows those that the options ask for.
    /// @param commanded, trueTip apex, world [m]; none: not known
    void show(const ViewOptions& options, const std::optional<Vector3>& commanded,
              const std::optional<Vector3>& trueTip, GhostStyle style);
    void hide() { show({}, {}, {}, {}); }
    /// Of those that are shown.
    [[nodiscard]] const std::vector<LabelContent::Name>& names() const { return names_; }

private:
    GhostLayer commanded_;
    GhostLayer true_;
    std::vector<LabelContent::Name> names_;
};

}  // namespace asperity
