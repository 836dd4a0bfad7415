#pragma once

#include "app/window/LongWork.h"
#include "app/window/RunControl.h"
#include "core/scene/Scene.h"
#include "core/scene/SceneDescription.h"
#include "core/surface/GivenScale.h"

#include <QString>
#include <QUndoStack>

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A scene of the history.
struct PastScene {
    SceneDescription description;
    int origin = 0;  ///< number of the opening that it came by; changes keep it
};

/// The changes of the scene that can be undone, as descriptions: never as surfaces. A change comes
/// here once it is made; moving in the history makes none.
class SceneHistory {
public:
    SceneHistory();

    /// A change that is made. @param number what it turns, where such changes in a row are one;
    /// empty: it is alone
    void add(const QString& name, const QString& number, const PastScene& before,
             const PastScene& after);
    /// So many changes are made; the others are undone.
    void moveTo(int index) { stack_.setIndex(index); }
    void clear() { stack_.clear(); }

    [[nodiscard]] int count() const { return stack_.count(); }
    /// Returns the number of changes that are made.
    [[nodiscard]] int index() const { return stack_.index(); }
    /// Returns the scene after a number of changes, at most as many as there are.
    [[nodiscard]] const PastScene& after(int changes) const;
    /// Returns the name of the change with this number, from 0.
    [[nodiscard]] QString nameOf(int change) const { return stack_.text(change); }

private:
    QUndoStack stack_;
};

/// The one way to change the scene that the window shows, with undo and redo. What takes time is
/// made in the background while the present run goes on: a model on the surface that is there, or
/// the surface reread from its file. Until then, or where it fails or is canceled, nothing changes.
class SceneEdits : public QObject {
    Q_OBJECT

public:
    /// @param host, live, runs outlive this
    SceneEdits(Host& host, LivePanels& live, RunControl& runs);

    /// Returns the scene that is wanted: as it is, or as the change under way will make it; the
    /// next change starts from it. Null: there is no scene.
    [[nodiscard]] const SceneDescription* wanted() const;
    /// Number of the opening that the scene came by: changes keep it, undo of an opening gives back
    /// the one before.
    [[nodiscard]] int origin() const { return origin_; }

    /// Makes the scene that of another description; says in the window why it cannot be so.
    /// @param name   of the change in the menu: "Tip radius: 20 nm"
    /// @param number what it turns, where such changes in a row are one step of the history:
    ///               "radius_m"; empty: it is alone
    void change(const QString& name, const SceneDescription& next, const QString& number = {});

    /// A scene that replaces the present one.
    struct Opening {
        QString name;  ///< of the file
        LongWork<LoadedScene>::Work load;
        /// Position of the tip, once it is loaded [m]; none: as at the start.
        std::function<std::optional<Vector2>()> position = [] { return std::nullopt; };
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
    /// Returns the name of the change that undo and redo are about; empty: there is none.
    [[nodiscard]] QString undoName() const;
    [[nodiscard]] QString redoName() const;

Q_SIGNALS:
    /// wanted() is another scene, or not the one that was asked for; the run is the same.
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
    /// Goal of the scene: a position in the history, and new steps from there on.
    struct Target {
        int index = 0;
        std::vector<Step> steps;
    };

    void begun();
    [[nodiscard]] Target target() const;
    [[nodiscard]] const SceneDescription& goalOf(const Target& target) const;
    [[nodiscard]] const SceneDescription& present() const;
    /// Returns whether nothing can be changed now; the window says why.
    [[nodiscard]] bool isFixed();
    [[nodiscard]] bool isOpening();
    /// Returns whether there can be such a scene; if not, the window says why.
    [[nodiscard]] bool allows(const SceneDescription& scene);
    void goTo(const Target& target);
    void startWork(const SceneDescription& next, SceneChange change);
    void adopt();
    void use(LoadedScene& scene);
    /// Keeps where the tip is, for when its scan comes back.
    void rememberView();
    void begin(LoadedScene& scene);
    void useOpened(LoadedScene& scene);
    void fail(const std::exception_ptr& reason);
    /// Says why a change cannot be made, or what is missing for it.
    void explain(const Target& failed, const std::exception_ptr& reason);
    void giveUp();
    /// Moves the history to where the scene is. @param before the change
    void keep(const Target& target, const SceneDescription& before, const SceneDescription& after);

    Host& host_;
    LivePanels& live_;
    RunControl& runs_;
    SceneHistory history_;
    int origin_ = 0;                  ///< of the present scene
    int origins_ = 0;                 ///< so many there were
    std::optional<Target> target_;    ///< none: no change is under way
    std::optional<Opening> opening_;  ///< none: nothing is being opened
    bool using_ = false;              ///< the run that begins is of a change or opening here
    /// Position of tip and view on a scan, kept while another scan is shown.
    struct KeptView {
        Vector2 tip = Vector2::Zero();  ///< world [m]
        double halfWidth = 0.0;         ///< of the large view [m]
    };
    std::map<std::string, KeptView> keptViews_;  ///< by the scan, or part of one
    LongWork<LoadedScene> work_;
};

}  // namespace asperity
