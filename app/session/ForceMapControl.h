#pragma once

#include "app/session/BackgroundWork.h"
#include "app/session/ForceMapSaving.h"
#include "app/session/ForceMapWork.h"
#include "app/session/LongWork.h"
#include "app/session/RunControl.h"
#include "core/deformation/SurfaceField.h"
#include "ui/measure/PixelTool.h"
#include "ui/measure/RectangleTool.h"

#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace asperity {

class ForceMapPage;

/// Computes a force map of the scan in the background, offers its quantities as colors of the
/// surface, and shows the force curve of a pixel that is clicked. A map is of the scene that it was
/// started with; it stays as long as the scan does.
class ForceMapControl : public QObject {
    Q_OBJECT

public:
    ForceMapControl(MainWindow& window, RunControl& runs);

    [[nodiscard]] ForceMapPage& page() { return *page_; }
    /// Another scan is shown: the map was of the last one.
    void forget();
    /// The scene is another one, of the same scan.
    void refresh();
    /// Once a frame. There is a run.
    void show();
    /// Writes the map, if there is one, see ForceMapSaving.
    void saveTo(const std::filesystem::path& gwy);

    /// The quantity that is shown, as colors of the surface; none: there is no map.
    [[nodiscard]] const std::optional<SurfaceField>& layer() const { return layer_; }
    /// Null: there is none.
    [[nodiscard]] const HeldMap* map() const { return map_.get(); }

Q_SIGNALS:
    /// layer() is another one.
    void layerChanged();
    /// The user wants to see layer().
    void layerWanted();

private:
    /// A map under way.
    struct Making {
        SceneDescription scene;  ///< that it was started with
        std::shared_ptr<HeldMap> map;
    };

    void connectParts();
    void follow();
    void estimate();
    void showEstimate(double pixelTime);
    void start();
    void cancel();
    void showProgress(double share);
    void leaveWork();
    void take(bool isWhole);
    void showLayer();
    void showPixel(const QPoint& pixel);
    void showState();
    void forgetMap();
    [[nodiscard]] std::optional<MapPlan> plan(QString& refusal) const;
    /// Whether a map of this scene is none of the present one.
    [[nodiscard]] bool isEarlier(const SceneDescription& scene) const;

    MainWindow& window_;
    RunControl& runs_;
    ForceMapPage* page_;  ///< the window's
    RectangleTool rectangle_;
    PixelTool pixels_;
    WorkLine line_;
    QTimer soon_;  ///< runs until what is asked for rests
    bool due_ = true;
    MapQuantity shown_ = MapQuantity::AdhesionForce;
    QString done_;                    ///< what there is to say of the map
    std::shared_ptr<HeldMap> map_;    ///< null: there is none
    std::shared_ptr<Making> making_;  ///< null: none is under way
    std::optional<SurfaceField> layer_;
    std::chrono::steady_clock::time_point begin_;
    ForceMapSaving saving_;
    BackgroundWork<double> trial_;
    BackgroundWork<std::shared_ptr<HeldMap>> work_;
};

}  // namespace asperity
