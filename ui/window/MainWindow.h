#pragma once

#include "core/Vector.h"
#include "ui/panels/MessageLog.h"

#include <QMainWindow>

#include <memory>
#include <optional>
#include <set>
#include <vector>

class QShortcut;
class QSplitter;

namespace asperity {

class Card;
class CheatSheet;
class ControlBar;
class CrossHairLink;
class EngageBar;
class FidelityPanel;
class ForcePanel;
class HapticPanel;
class LoadingBar;
class LoopStatusBar;
class OverviewPanel;
class RunPanel;
struct Scene;
class ScenePanel;
class SecondView;
class StateBanner;
class SurfaceField;
struct SurfaceLook;
class ViewSide;
class WindowLayout;
class WindowMenus;
class WorkInBackground;
class ZoomView;

/// All panels of the live window, placed by a WindowLayout, with the menus above and the loop's
/// timing below them. Opens in the middle of the screen, no larger than it.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    MainWindow();
    ~MainWindow() override;
    MainWindow(const MainWindow&) = delete;
    MainWindow& operator=(const MainWindow&) = delete;

    [[nodiscard]] WindowMenus& menus() { return *menus_; }
    [[nodiscard]] ControlBar& controls() { return *controls_; }
    [[nodiscard]] StateBanner& banner() { return *banner_; }
    [[nodiscard]] EngageBar& engage() { return *engage_; }
    [[nodiscard]] ZoomView& view() { return *view_; }
    /// Hidden at first.
    [[nodiscard]] SecondView& second() { return *second_; }
    [[nodiscard]] ForcePanel& forces() { return *forces_; }
    [[nodiscard]] OverviewPanel& overview() { return *overview_; }
    /// A window of its own, hidden at first.
    [[nodiscard]] FidelityPanel& fidelity() { return *fidelity_; }
    /// The page beside the live one that shows all keys of the scene.
    [[nodiscard]] ScenePanel& scenePanel() { return *scenePanel_; }
    /// Likewise all knobs of the haptics.
    [[nodiscard]] HapticPanel& hapticPanel() { return *hapticPanel_; }
    [[nodiscard]] LoopStatusBar& loopStatus() { return *loopStatus_; }
    /// All that show a run beside the view.
    [[nodiscard]] const std::vector<RunPanel*>& panels() const { return panels_; }
    /// Those of the column on the right, from the top.
    [[nodiscard]] const std::vector<Card*>& cards() const;
    [[nodiscard]] WindowLayout& layout() { return *layout_; }
    /// Whether one panel has the middle of the window for itself.
    [[nodiscard]] bool isPanelEnlarged() const;
    /// Of the views beside one another; the large view is the first of them.
    [[nodiscard]] QSplitter& views();

    /// Where the pointer is over a view, world x, y [m]; none: over none of them.
    [[nodiscard]] std::optional<Vector2> crossHair() const;

    /// Adds a page to the tabs below the view; it is hidden at first.
    void addTool(QWidget* page, const QString& title);
    /// Shows such a page and puts it on top.
    void showTool(QWidget* page);
    /// Adds a page to the tabs right of the view.
    void addSidePage(QWidget* page, const QString& title);
    /// Shows such a page and puts it on top.
    void showSidePage(QWidget* page);

    /// What the dialog that saves the session begins with.
    void setSceneFile(const QString& path) { sceneFile_ = path; }
    /// How the surface is colored in all views. @param field what the look's quantity is on it
    void showLook(const SurfaceLook& look, const SurfaceField& field);
    /// Sets the scene of all panels; null: none. The scene outlives its use here.
    void showScene(const Scene* scene, const QString& title);
    /// What goes on in the background; a line in place of the hint names it, once it is shown.
    [[nodiscard]] WorkInBackground& works() { return *works_; }
    [[nodiscard]] LoadingBar& loading() { return *loading_; }
    /// A short message for a while.
    void tell(const QString& message);
    void tell(const QString& message, MessageKind kind);
    /// All that the window said; what it shows nowhere else is added here.
    [[nodiscard]] MessageLog& messages() { return *messages_; }
    /// Whether Esc switches the forces of a device off, whatever window is active; else it closes
    /// what is open, no more.
    void setEmergencyStop(bool active);
    /// What moves the tip is disabled. @param why for tool tips; empty: it can be moved
    void refuseTip(const QString& why);
    /// What changes scene and knobs is disabled, no cross-hair goes with the pointer. @param why
    /// for tool tips; empty: it can be changed
    void fix(const QString& why);
    [[nodiscard]] bool isFixed() const { return isFixed_; }
    /// Nothing can be changed any more: for measurements.
    void lock();
    /// A message that must be read; the window goes on meanwhile.
    void complain(const QString& message);

Q_SIGNALS:
    /// By drop.
    void openRequested(QString file);
    void pathFileChosen(QString file);
    void recordingChosen(QString forceLog);
    /// To be looked at: a file of its folder, or a bundle.
    void runChosen(QString file);
    void pictureFileChosen(QString file);
    /// The dialog that saves the session is about to open.
    void sceneFileWanted();
    void sceneFileChosen(QString file);  ///< to be written

protected:
    void showEvent(QShowEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;

private:
    void placeAll();
    /// Of the scene and its knobs, but for those of the bar.
    void allowChanges(bool allowed);
    /// The list of messages and what counts its errors.
    void placeMessages();
    /// Shows a panel that is a window of its own, at first beside this one; or hides it.
    void toggle(QWidget& panel);
    /// Has Esc close it where that is no emergency stop; numbers half typed do not count then.
    void closeByEscape(QWidget& panel);
    /// The bottom line says why a number is refused; windows of their own have lines of their own.
    void tellRefusals();
    void connectMenus();
    void connectViews();
    void connectWorks();
    /// Empty: nothing is done.
    void showLoading(const QString& words);
    void showHint();

    QString sceneFile_;
    bool hasShownScene_ = false;
    bool hasEmergencyStop_ = false;
    bool tipMoves_ = true;
    bool isFixed_ = false;
    MessageLog* messages_;
    WindowMenus* menus_;
    ControlBar* controls_;
    StateBanner* banner_;
    EngageBar* engage_;
    ZoomView* view_;
    SecondView* second_;
    LoadingBar* loading_;
    WorkInBackground* works_;
    ViewSide* viewSide_;
    WindowLayout* layout_;
    OverviewPanel* overview_;
    ForcePanel* forces_;
    LoopStatusBar* loopStatus_;
    FidelityPanel* fidelity_;
    ScenePanel* scenePanel_;
    HapticPanel* hapticPanel_;
    CheatSheet* cheatSheet_;
    std::set<QWidget*> placed_;            ///< panels that have stood beside this window
    std::vector<QShortcut*> toolClosers_;  ///< Esc, where it is no emergency stop
    std::vector<RunPanel*> panels_;
    std::unique_ptr<CrossHairLink> crossHair_;
};

}  // namespace asperity
