#pragma once

#include "app/loading/SceneLoader.h"
#include "app/window/LongWork.h"
#include "app/window/RunControl.h"
#include "app/window/SceneEdits.h"
#include "ui/shell/Host.h"
#include "ui/shell/Menus.h"
#include "ui/view/SurfaceColors.h"

#include <QObject>
#include <QString>
#include <QTimer>
#include <QVariantMap>

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <typeindex>
#include <utility>
#include <vector>

namespace asperity {

class LivePanels;
class SceneOpener;

/// Steps of a frame, in their order. Between the first two the ticks since the last frame are told.
enum class FrameStep : std::uint8_t {
    Move,  ///< what moves the tip
    Act,   ///< what acts on the ticks that came
    Show   ///< what is drawn
};

/// Part of what a session file keeps beside its scene.
struct SessionPart {
    std::function<void(QVariantMap& kept)> keep;           ///< adds its state; there is a run
    std::function<void(const QVariantMap& kept)> restore;  ///< with its scene; may be empty
};

/// Meeting point of the features of the window. It tells each of them, in the order in which they
/// were added, that a run begins (RunControl::begun), each of its ticks, each frame in three steps,
/// and that the run ends (RunControl::ending).
class Stage : public QObject {
    Q_OBJECT

public:
    /// @param host, live outlive this
    Stage(Host& host, LivePanels& live);
    /// Ends the run; then the features go, the last one first.
    ~Stage() override;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    [[nodiscard]] Host& host() { return host_; }
    [[nodiscard]] LivePanels& live() { return live_; }
    [[nodiscard]] RunControl& runs() { return runs_; }
    /// Returns the present run; null: there is none yet.
    [[nodiscard]] LiveRun* run() const { return runs_.run(); }
    /// Returns the changes of the scene, with their history.
    [[nodiscard]] SceneEdits& edits() { return edits_; }
    /// Returns what opens scenes; a feature does.
    [[nodiscard]] SceneOpener& scenes() { return *scenes_; }
    void setScenes(SceneOpener& scenes) { scenes_ = &scenes; }

    /// Calls a function for every tick, in order.
    void onTick(TickSink take) { takers_.push_back(std::move(take)); }
    /// Calls a function once a frame while there is a run. @param elapsed since the last frame, at
    /// most 0.1 s: what a held key moves in it [s]
    void onFrame(FrameStep step, std::function<void(double elapsed)> act);
    /// Adds a part of what a session keeps. Parts are restored in the order in which they were
    /// added.
    void keepInSession(SessionPart part) { sessionParts_.push_back(std::move(part)); }
    [[nodiscard]] const std::vector<SessionPart>& sessionParts() const { return sessionParts_; }
    /// Begins frames, and watches for Esc: it switches the forces of a device off, else closes what
    /// is open, else ends the tool on the scan, else cancels the work in the background.
    /// @param period from one frame to the next [ms]
    void play(int period = kFramePeriod);

    /// Makes a feature or a part of one. It is told of all later than those that are there.
    template <class Part>
    Part& add() {
        auto part = std::make_shared<Part>(*this);
        parts_.emplace_back(typeid(Part), part);
        return *part;
    }
    /// Returns a part that was added before. @throw std::logic_error there is none
    template <class Part>
    [[nodiscard]] Part& get() const {
        return *static_cast<Part*>(part(typeid(Part)));
    }

    bool eventFilter(QObject* watched, QEvent* event) override;

Q_SIGNALS:
    /// The surface can be colored by another field; none: by none (any more).
    void fieldOffered(const std::optional<asperity::SurfaceField>& field);
    /// The surface is to be colored by the field that was offered.
    void fieldWanted();

private:
    static constexpr int kFramePeriod = 16;  ///< [ms]

    [[nodiscard]] void* part(std::type_index type) const;
    void stop();
    [[nodiscard]] bool closesList(QEvent& escape);
    void advance();

    Host& host_;
    LivePanels& live_;
    RunControl runs_;
    SceneEdits edits_;
    SceneOpener* scenes_ = nullptr;
    std::vector<TickSink> takers_;
    std::vector<std::pair<FrameStep, std::function<void(double)>>> frameSteps_;
    std::vector<SessionPart> sessionParts_;
    std::vector<std::pair<std::type_index, std::shared_ptr<void>>> parts_;
    QTimer frames_;
    QTimer listCloses_;       ///< runs until all parts of the key that closes an open list are over
    double lastFrame_ = 0.0;  ///< [s]
};

/// Base of what acts in the window.
class Feature : public QObject {
protected:
    explicit Feature(Stage& stage);

    /// Adds a page that shows something on the whole scan to the tabs below the view, and the entry
    /// of the menu Measure that opens it. @param rank of the entry @param name as an object
    QAction& addScanTool(QWidget* page, const QString& title, int rank, const char* name,
                         const MenuEntry& entry);

    Stage& stage_;
    Host& host_;
    LivePanels& live_;
    RunControl& runs_;
    SceneEdits& edits_;
};

/// Opens scenes for whoever has one to show: a dialog, the session of before, a recording.
class SceneOpener : public Feature {
    Q_OBJECT

public:
    using FailureWords = std::function<QString(const QString& reason)>;

    /// Loads in the background, then shows; says so in the window when that fails. Where a file
    /// does not hold its scale the user is asked for it first. Another one that is being loaded is
    /// given up. What the scene requires of its model is found out beside its run, see
    /// ModelFitControl.
    /// @param failureWords what to say where that fails, of the reason; none: the reason
    virtual void open(const std::filesystem::path& input, const SceneOverrides& overrides,
                      const FailureWords& failureWords) = 0;
    void open(const std::filesystem::path& input) { open(input, SceneOverrides{}, {}); }
    /// The same of a scene that is loaded in another way. @param shown is called once it is there
    virtual void open(const std::filesystem::path& input, const LongWork<LoadedScene>::Work& load,
                      const std::function<void()>& shown) = 0;

protected:
    using Feature::Feature;

Q_SIGNALS:
    /// Another scene was opened in whatever way, and is shown.
    void sceneTaken();
    /// After sceneTaken(), of a file that a user opens.
    void opened(std::filesystem::path file);
    /// After opened(), of a session: how the window showed the scene.
    void sessionOpened(std::filesystem::path file, QVariantMap kept);
};

}  // namespace asperity
