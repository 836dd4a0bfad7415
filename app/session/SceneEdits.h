#pragma once

#include "app/session/LongWork.h"
#include "app/session/RunControl.h"
#include "app/session/SceneHistory.h"
#include "core/scene/SceneChange.h"
#include "core/surface/ScaleGap.h"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// The one way to change the scene that the window shows, with undo and redo. What takes time is
/// made in the background while the present run goes on: a model on the surface that is there, or
/// the surface anew from its file. Until then, or where it fails or is canceled, nothing changes.
class SceneEdits : public QObject {
    Q_OBJECT

public:
    SceneEdits(MainWindow& window, RunControl& runs);

    /// What the scene is to be: as it is, or as the change under way will make it; that is what
    /// the next change starts from. Null: there is no scene.
    [[nodiscard]] const SceneDescription* wanted() const;
    /// Number of the opening that the scene came by: changes keep it, undo of an opening gives back
    /// the one before.
    [[nodiscard]] int origin() const { return origin_; }

    /// Makes the scene that of another description; says in the window why it cannot be so.
    /// @param name   of the change in the menu: "Tip radius: 20 nm"
    /// @param number what it turns, where such changes in a row are one step of the history:
    ///               "radius_m"; empty: it stands alone
    void change(const QString& name, const SceneDescription& next, const QString& number = {});

    /// A scene that takes the place of the present one.
    struct Opening {
        QString name;  ///< of the file
        LongWork<LoadedScene>::Work load;
        /// Of the tip, once it is loaded [m]; none: as at first.
        std::function<std::optional<Vector2>()> place = [] { return std::nullopt; };
        std::function<void()> opened;  ///< and it is shown
        std::function<void(const std::exception_ptr& reason)> failed;
        std::function<void()> canceled;
    };
    void open(Opening opening);
    /// Nothing comes of the change or the opening under way.
    void cancel();

    /// Takes back the change under way, else the last one.
    void undo();
    void redo();
    /// Which change these are about; empty: there is none.
    [[nodiscard]] QString undoName() const;
    [[nodiscard]] QString redoName() const;

Q_SIGNALS:
    /// What the scene is to be is another, or is not what was asked for: without another run.
    void changed();
    /// The scan's file does not say its scale; the change can be asked for again with one.
    void scaleMissing(std::filesystem::path file, asperity::ScaleGap gap, QString name,
                      asperity::SceneDescription next);

private:
    struct Step {
        QString name;
        QString number;
        SceneDescription after;
    };
    /// Where the scene is to go: to a place in the history, and from there on by new steps.
    struct Target {
        int index = 0;
        std::vector<Step> steps;
    };

    void begun();
    [[nodiscard]] Target target() const;
    [[nodiscard]] const SceneDescription& goalOf(const Target& target) const;
    [[nodiscard]] const SceneDescription& present() const;
    /// Whether nothing can be changed now; says so.
    [[nodiscard]] bool isFixed();
    [[nodiscard]] bool isOpening();
    /// Whether there can be such a scene; says why not.
    [[nodiscard]] bool allows(const SceneDescription& scene);
    void goTo(const Target& target);
    void startWork(const SceneDescription& next, SceneChange change);
    void adopt();
    void use(LoadedScene& scene);
    /// Keeps where the tip is, for when its scan comes back.
    void rememberPlace();
    void begin(LoadedScene& scene);
    void useOpened(LoadedScene& scene);
    void fail(const std::exception_ptr& reason);
    /// Says why a change cannot be made, or what is missing for it.
    void explain(const Target& failed, const std::exception_ptr& reason);
    void giveUp();
    /// Moves the history to where the scene is. @param before the change
    void keep(const Target& target, const SceneDescription& before, const SceneDescription& after);

    MainWindow& window_;
    RunControl& runs_;
    SceneHistory history_;
    int origin_ = 0;                  ///< of the present scene
    int origins_ = 0;                 ///< so many there were
    std::optional<Target> target_;    ///< none: no change is under way
    std::optional<Opening> opening_;  ///< none: nothing is being opened
    bool using_ = false;              ///< the run that begins is of a change or opening here
    /// Of the tip on a scan, when another one took its place.
    struct Stand {
        Vector2 place = Vector2::Zero();  ///< world [m]
        double halfWidth = 0.0;           ///< of the large view [m]
    };
    std::map<std::string, Stand> stands_;  ///< by the scan, or part of one
    LongWork<LoadedScene> work_;
};

}  // namespace asperity
