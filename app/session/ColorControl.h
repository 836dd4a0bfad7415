#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/RunControl.h"
#include "core/deformation/SurfaceField.h"
#include "ui/SurfaceLook.h"

#include <memory>
#include <optional>
#include <string>

namespace asperity {

/// By what the surface is colored: finds the quantity of a look on the scene shown, reads what only
/// its file has in the background, and says which quantities there are.
class ColorControl : public QObject {
public:
    ColorControl(MainWindow& window, RunControl& runs);

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

    MainWindow& window_;
    RunControl& runs_;
    SurfaceLook look_;
    std::string loading_;  ///< key of the image that is being read
    std::string loaded_;   ///< key of `image_`
    std::shared_ptr<const PixelField> image_;
    std::optional<SurfaceField> forceMap_;
    BackgroundWork<PixelField> loader_;
};

}  // namespace asperity
