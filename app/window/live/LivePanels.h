#pragma once

#include "core/Vector.h"

#include <QObject>
#include <QString>
#include <QTimer>

#include <memory>
#include <optional>
#include <vector>

class QAction;
class QSplitter;

namespace asperity {

class ColorsMenu;
class ControlBar;
class CrossHairLink;
class DirectionMenu;
class EngageBar;
class ForcePanel;
class Host;
class LoadingBar;
class LoopStatusBar;
class OverviewPanel;
class RunPanel;
class SecondView;
class StateBanner;
class SurfaceField;
class ViewOptionsMenu;
class ViewSide;
class ZoomView;
struct Scene;
struct SurfaceLook;

/// All that shows the run in a window: control bar, state, views, cards and the loop's timing, with
/// the entries of the menu View. The window owns the widgets.
class LivePanels : public QObject {
    Q_OBJECT

public:
    /// Fills the window. @param host outlives this
    explicit LivePanels(Host& host);
    ~LivePanels() override;
    LivePanels(const LivePanels&) = delete;
    LivePanels& operator=(const LivePanels&) = delete;

    [[nodiscard]] ControlBar& controls() { return *controls_; }
    [[nodiscard]] StateBanner& banner() { return *banner_; }
    [[nodiscard]] EngageBar& engage() { return *engage_; }
    [[nodiscard]] ZoomView& view() { return *view_; }
    [[nodiscard]] SecondView& second() { return *second_; }
    /// Returns the entry that shows the second view.
    [[nodiscard]] QAction& secondEntry() { return *secondEntry_; }
    [[nodiscard]] ForcePanel& forces() { return *forces_; }
    [[nodiscard]] OverviewPanel& overview() { return *overview_; }
    [[nodiscard]] LoopStatusBar& loopStatus() { return *loopStatus_; }
    /// Returns all that show a run beside the view.
    [[nodiscard]] const std::vector<RunPanel*>& panels() const { return panels_; }
    /// Colors of the surface, in all views.
    [[nodiscard]] ColorsMenu& colors() { return *colors_; }
    /// Options of the large view.
    [[nodiscard]] ViewOptionsMenu& viewOptions() { return *viewOptions_; }
    [[nodiscard]] DirectionMenu& directions() { return *directions_; }
    /// Returns the splitter of the views beside one another; the large view is its first.
    [[nodiscard]] QSplitter& views();
    /// Returns the position of the pointer over a view, world x, y [m]; none: over none of them.
    [[nodiscard]] std::optional<Vector2> crossHair() const;

    /// Colors the surface in all views. @param field values of the look's quantity on it
    void showLook(const SurfaceLook& look, const SurfaceField& field);
    /// Sets the scene of all panels; null: none. The scene outlives its use here.
    void showScene(const Scene* scene, const QString& title);
    /// Says in the hint whether Esc switches the forces of a device off, and keeps Esc for that.
    void setEmergencyStop(bool active);
    /// Says in the hint that the tip moves by itself, and how to take it.
    void setDemonstration(bool isPlaying);
    /// Disables all that moves the tip. @param why for tool tips; empty: it can be moved
    void refuseTip(const QString& why);
    /// Disables all that changes scene and knobs, and hides the cross-hair. @param why for tool
    /// tips; empty: it can be changed
    void fix(const QString& why);
    [[nodiscard]] bool isFixed() const { return isFixed_; }
    /// Ends the tool that has the mouse on the whole scan. @return whether one had it when the
    /// present event of the user began: a key comes in several parts
    bool leaveTool();
    /// Disables everything that changes the run: for measurements.
    void lock();

private:
    void placeCards();
    void addEntries();
    void connectViews();
    void connectWorks();
    /// @param words of the work that is named; empty: nothing is done
    void showLoading(const QString& words);
    void showHint();

    Host& host_;
    bool hasShownScene_ = false;
    bool hasEmergencyStop_ = false;
    bool tipMoves_ = true;
    bool isDemonstration_ = false;
    bool isFixed_ = false;
    ControlBar* controls_;
    StateBanner* banner_;
    EngageBar* engage_;
    ZoomView* view_;
    SecondView* second_;
    LoadingBar* loading_;
    ViewSide* side_;
    OverviewPanel* overview_;
    ForcePanel* forces_;
    LoopStatusBar* loopStatus_;
    QAction* cancelLoading_ = nullptr;
    QAction* secondEntry_ = nullptr;
    ColorsMenu* colors_ = nullptr;
    ViewOptionsMenu* viewOptions_ = nullptr;
    DirectionMenu* directions_ = nullptr;
    std::vector<RunPanel*> panels_;
    std::unique_ptr<CrossHairLink> crossHair_;
    QTimer leaving_;  ///< runs until the event that ended a tool is over
};

}  // namespace asperity
