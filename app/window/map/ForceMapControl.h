#pragma once

#include "app/maps/MapPart.h"
#include "app/window/LongWork.h"
#include "app/window/Stage.h"
#include "app/window/map/PixelCurveView.h"
#include "core/Progress.h"
#include "core/deformation/SurfaceField.h"
#include "ui/view/ShapeTool.h"

#include <QString>
#include <QTimer>

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

namespace asperity {

class ForceMapPage;

/// Writes the force map of the window: the files of `asperity map`, to the byte.
class ForceMapSaving {
public:
    explicit ForceMapSaving(Host& host);

    /// Asks for a file, and whether those beside it may be replaced.
    void ask(const std::shared_ptr<const HeldMap>& map);
    /// Draws the pictures, then writes the other files in the background; says in the window how it
    /// went. @param gwy a name without a type gets it
    void saveTo(const std::shared_ptr<const HeldMap>& map, const std::filesystem::path& gwy);

private:
    void write(const std::shared_ptr<const HeldMap>& map, const std::filesystem::path& gwy);

    Host& host_;
    LongWork<QString> work_;
};

/// Computes a force map of the scan in the background, offers its quantities as colors of the
/// surface, and shows the force curve of a pixel that is clicked. A map is of the scene that it was
/// started with; it stays as long as the scan does.
class ForceMapControl : public Feature {
    Q_OBJECT

public:
    explicit ForceMapControl(Stage& stage);

    [[nodiscard]] ForceMapPage& page() { return *page_; }
    /// Another scan is shown: the map was of the last one.
    void forget();
    /// The scene is another one, of the same scan, or the live one is shown again.
    void refresh();
    /// Once a frame. There is a run.
    void show();
    /// Writes the map, if there is one, see ForceMapSaving.
    void saveTo(const std::filesystem::path& gwy);

    /// The quantity that is shown, as colors of the surface; none: there is no map.
    [[nodiscard]] const std::optional<SurfaceField>& layer() const { return layer_; }
    /// Null: there is none.
    [[nodiscard]] const HeldMap* map() const { return map_.get(); }

private:
    /// A map under way.
    struct Making {
        SceneDescription scene;  ///< that it was started with
        std::shared_ptr<HeldMap> map;
    };

    void addEntry();
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
    /// Returns whether a recording of another scan is shown, which the map says nothing of.
    [[nodiscard]] bool isHidden() const;
    void hide();
    [[nodiscard]] std::optional<MapPlan> plan(QString& refusal) const;
    /// Returns whether a map of this scene is outdated: the present scene differs.
    [[nodiscard]] bool isEarlier(const SceneDescription& scene) const;

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

/// Input of a force map of the window: the scan that is open, and the scene as it is to be mapped.
/// The work copies the scene and then releases the run's.
struct MapSubject {
    std::shared_ptr<const LoadedScene> present;
    SceneDescription description;
    MapPlan plan;
};

/// Threads that map in the window: the loop keeps a core of its own where there are two.
[[nodiscard]] int mapThreads();

/// Computes what the map lacks. @param map gets it before its first row: it is there, with the rows
/// that are finished, also where this throws @throw Canceled, Error
void computeHeldMap(MapSubject subject, std::shared_ptr<HeldMap>& map, Progress& progress);

/// Time of a pixel on one core [s], measured on some of a row in the middle of the map.
/// @throw Canceled, Error
[[nodiscard]] double measuredPixelTime(MapSubject subject, const Progress& progress);

}  // namespace asperity
