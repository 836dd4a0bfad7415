#pragma once

#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "core/deformation/SurfaceField.h"
#include "ui/view/ColorScale.h"

#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// Colors of the surface: finds the quantity of a look on the scene shown, reads what only
/// its file has in the background, and says which quantities there are.
class ColorControl : public Feature {
public:
    explicit ColorControl(Stage& stage);

    /// The force map that the surface can be colored by, or another quantity of it; none: there is
    /// none (any more).
    void setForceMap(const std::optional<SurfaceField>& map);
    /// Colors the surface by it. There is one.
    void showForceMap();

private:
    void choose(const SurfaceLook& look);
    void beginScene();
    void leaveScene();
    void show();
    void showHeights(const QString& reason);
    void load();
    [[nodiscard]] bool isOfFile() const;
    [[nodiscard]] bool isMissing() const;
    [[nodiscard]] SurfaceField field() const;
    [[nodiscard]] std::string imageKey() const;
    void offer();

    SurfaceLook look_;
    std::string loading_;  ///< key of the image that is being read
    std::string loaded_;   ///< key of `image_`
    std::shared_ptr<const PixelField> image_;
    std::optional<SurfaceField> forceMap_;
    BackgroundWork<PixelField> loader_;
};

}  // namespace asperity
