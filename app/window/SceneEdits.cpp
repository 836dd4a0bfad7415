#include "app/window/SceneEdits.h"

#include "app/loading/SceneLoader.h"
#include "app/window/live/LivePanels.h"
#include "core/Error.h"
#include "core/io/heightmap/ImageScale.h"
#include "core/scene/BelievedModel.h"
#include "ui/shell/Host.h"
#include "ui/view/ZoomView.h"

#include <QUndoCommand>

#include <utility>

namespace asperity {

namespace {

constexpr int kMaxChanges = 500;  ///< some kilobytes each
constexpr int kNumberId = 1;      ///< of commands that may be one

/// One change. It does nothing itself: a change that takes time is made before it is told here.
class ChangeMade : public QUndoCommand {
public:
    ChangeMade(const QString& name, QString number, PastScene before, PastScene after)
        : QUndoCommand(name)
        , number_(std::move(number))
        , before_(std::move(before))
        , after_(std::move(after)) {}

    [[nodiscard]] const PastScene& before() const { return before_; }
    [[nodiscard]] const PastScene& after() const { return after_; }

    [[nodiscard]] int id() const override { return number_.isEmpty() ? -1 : kNumberId; }
    bool mergeWith(const QUndoCommand* other) override {
        const auto& next = static_cast<const ChangeMade&>(*other);
        if (next.number_ != number_) {
            return false;
        }
        setText(next.text());
        after_ = next.after_;
        setObsolete(after_.description == before_.description);
        return true;
    }

private:
    QString number_;
    PastScene before_;
    PastScene after_;
};

/// The same contact laws without their table, which takes long and is made with the scene.
SceneDescription withoutTable(SceneDescription scene) {
    if (scene.choices.solver == SolverSetting::Table) {
        scene.choices.solver = SolverSetting::Newton;
    }
    return scene;
}

/// Before work begins for it. @throw Error where no scene can be made of the description
void requireScene(const SceneDescription& scene) {
    checkScene(scene);
    static_cast<void>(believedSystem(scene, usualModel(scene)));
    static_cast<void>(trueSystem(scene));
}

/// Returns the scan, part of one or shape in which coordinates mean the same positions, so that
/// the tip can stay where it is.
std::string scanOf(const SampleDescription& sample) {
    std::string scan = sample.shape ? "shape" : sample.file;
    if (const auto& crop = sample.crop) {
        for (const int number : {crop->column, crop->row, crop->columns, crop->rows}) {
            scan += ',' + std::to_string(number);
        }
    }
    return scan;
}

}  // namespace

SceneHistory::SceneHistory() { stack_.setUndoLimit(kMaxChanges); }

void SceneHistory::add(const QString& name, const QString& number, const PastScene& before,
                       const PastScene& after) {
    stack_.push(new ChangeMade(name, number, before, after));
}

const PastScene& SceneHistory::after(int changes) const {
    const auto made = [this](int change) -> const ChangeMade& {
        return static_cast<const ChangeMade&>(*stack_.command(change));
    };
    return changes == 0 ? made(0).before() : made(changes - 1).after();
}

SceneEdits::SceneEdits(Host& host, LivePanels& live, RunControl& runs)
    : host_(host)
    , live_(live)
    , runs_(runs)
    , work_(loadingLine(host_),
            {.finished = [this](LoadedScene& scene) { opening_ ? useOpened(scene) : use(scene); },
             .failed = [this](const std::exception_ptr& reason) { fail(reason); },
             .cancel = [this] { cancel(); }}) {
    connect(&runs, &RunControl::begun, this, &SceneEdits::begun);
    connect(&runs, &RunControl::recordingShown, this, &SceneEdits::changed);
    connect(&runs, &RunControl::liveShown, this, &SceneEdits::changed);
}

/// A scene that did not come from here has no history.
void SceneEdits::begun() {
    if (!using_ && runs_.fixedBy().isEmpty()) {
        giveUp();
        origin_ = ++origins_;
        history_.clear();
        keptViews_.clear();
    }
}

const SceneDescription& SceneEdits::present() const { return runs_.scene().description; }

const SceneDescription* SceneEdits::wanted() const {
    if (runs_.run() == nullptr) {
        return nullptr;
    }
    return target_ ? &goalOf(*target_) : &present();
}

SceneEdits::Target SceneEdits::target() const {
    return target_.value_or(Target{.index = history_.index(), .steps = {}});
}

const SceneDescription& SceneEdits::goalOf(const Target& target) const {
    if (!target.steps.empty()) {
        return target.steps.back().after;
    }
    return target.index == history_.index() ? present() : history_.after(target.index).description;
}

bool SceneEdits::isFixed() {
    if (!runs_.editRefusal().isEmpty()) {
        host_.tell(runs_.editRefusal());
    }
    return !runs_.editRefusal().isEmpty();
}

bool SceneEdits::isOpening() {
    if (opening_) {
        host_.tell(
            tr("%1 is being loaded: change the scene afterwards, or cancel").arg(opening_->name));
    }
    return opening_.has_value();
}

bool SceneEdits::allows(const SceneDescription& scene) {
    try {
        const SceneDescription quick = withoutTable(scene);
        requireScene(quick);
        runs_.run()->requireHolding(quick);
        return true;
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
        return false;
    }
}

void SceneEdits::change(const QString& name, const SceneDescription& next, const QString& number) {
    const SceneDescription* const now = wanted();
    if (now == nullptr || next == *now || isFixed() || isOpening()) {
        Q_EMIT changed();
        return;
    }
    Target goal = target();
    if (!number.isEmpty() && !goal.steps.empty() && goal.steps.back().number == number) {
        goal.steps.pop_back();
    }
    goal.steps.push_back({.name = name, .number = number, .after = next});
    goTo(goal);
}

void SceneEdits::goTo(const Target& target) {
    const SceneDescription next = goalOf(target);
    if (allows(next)) {
        target_ = target;
        const SceneChange change = changeBetween(present(), next);
        if (change == SceneChange::None || change == SceneChange::Shown) {
            adopt();
        } else {
            startWork(next, change);
        }
    }
    Q_EMIT changed();
}

void SceneEdits::startWork(const SceneDescription& next, SceneChange change) {
    const QString words =
        tr("%1 …").arg(target_->steps.empty() ? tr("Undo or redo") : target_->steps.back().name);
    if (change == SceneChange::Surface) {
        work_.start(words, [next](Progress& progress) { return loadScene(next, &progress); });
    } else {
        work_.start(words, [next, present = runs_.run()->shared()](Progress& progress) {
            return withDescription(*present, next, &progress);
        });
    }
}

/// What can change while the run goes on does so at once.
void SceneEdits::adopt() {
    const Target made = target();
    const SceneDescription before = present();
    const SceneDescription after = goalOf(made);
    giveUp();
    runs_.run()->adopt(after);
    if (after.zoomHalfWidth != before.zoomHalfWidth && after.zoomHalfWidth > 0.0) {
        live_.view().setHalfWidth(after.zoomHalfWidth);
    }
    keep(made, before, after);
}

void SceneEdits::use(LoadedScene& scene) {
    const Target made = target();
    const SceneDescription before = present();
    const SceneDescription after = scene.scene.description;
    if (!allows(after)) {  // another device may have connected since
        giveUp();
        Q_EMIT changed();
        return;
    }
    giveUp();
    begin(scene);
    keep(made, before, after);
    Q_EMIT changed();
}

/// The tip stays where it is, or is back where it was on that scan.
void SceneEdits::begin(LoadedScene& scene) {
    const Vector3 here = runs_.run()->basePosition();
    const SampleDescription after = scene.scene.description.sample;
    const bool isHere = scanOf(present().sample) == scanOf(after) &&
                        scene.scene.surface.contains(here.x(), here.y());
    rememberView();
    const auto known = keptViews_.find(scanOf(after));
    using_ = true;
    if (isHere) {
        runs_.replace(std::move(scene));
    } else if (known != keptViews_.end() &&
               scene.scene.surface.contains(known->second.tip.x(), known->second.tip.y())) {
        runs_.replace(std::move(scene), known->second.tip);
        live_.view().setHalfWidth(known->second.halfWidth);
    } else {
        runs_.use(std::move(scene));
    }
    using_ = false;
}

void SceneEdits::rememberView() {
    keptViews_[scanOf(present().sample)] = {.tip = runs_.run()->basePosition().head<2>(),
                                            .halfWidth = live_.view().halfWidth()};
}

void SceneEdits::keep(const Target& target, const SceneDescription& before,
                      const SceneDescription& after) {
    PastScene from{.description = before, .origin = origin_};
    if (target.index != history_.index()) {
        from = history_.after(target.index);
        history_.moveTo(target.index);
        origin_ = from.origin;
    }
    for (const Step& step : target.steps) {
        const bool isLast = &step == &target.steps.back();
        history_.add(step.name, step.number, from, {isLast ? after : step.after, origin_});
        from.description = step.after;
    }
}

void SceneEdits::open(Opening opening) {
    if (!runs_.fixedBy().isEmpty()) {
        host_.tell(runs_.fixedBy());
        return;
    }
    target_.reset();
    opening_ = std::move(opening);
    work_.start(tr("Loading %1 …").arg(opening_->name), opening_->load);
    Q_EMIT changed();
}

void SceneEdits::useOpened(LoadedScene& scene) {
    const Opening opening = *opening_;
    giveUp();
    runs_.showLive();
    const SceneDescription after = scene.scene.description;
    std::optional<PastScene> before;
    if (runs_.run() != nullptr) {
        before = {.description = present(), .origin = origin_};
        rememberView();
    }
    using_ = true;
    runs_.use(std::move(scene), opening.position());
    using_ = false;
    origin_ = ++origins_;
    if (before) {
        history_.add(tr("Open %1").arg(opening.name), {}, *before, {after, origin_});
    }
    opening.opened();
    Q_EMIT changed();
}

void SceneEdits::fail(const std::exception_ptr& reason) {
    const std::optional<Opening> opening = opening_;
    const Target failed = target();
    giveUp();
    if (opening) {
        opening->failed(reason);
    } else {
        explain(failed, reason);
    }
    Q_EMIT changed();
}

void SceneEdits::explain(const Target& failed, const std::exception_ptr& reason) {
    try {
        std::rethrow_exception(reason);
    } catch (const MissingScale& missing) {
        if (!failed.steps.empty()) {
            Q_EMIT scaleMissing(missing.path(), missing.gap(), failed.steps.back().name,
                                failed.steps.back().after);
            return;
        }
    } catch (...) {  // in words below
    }
    host_.complain(reasonOf(reason));
}

void SceneEdits::giveUp() {
    target_.reset();
    opening_.reset();
    work_.cancel();
}

void SceneEdits::cancel() {
    const std::optional<Opening> opening = opening_;
    const std::optional<Target> target = target_;
    if (!opening && !target) {
        return;
    }
    giveUp();
    if (opening) {
        opening->canceled();
    } else {
        host_.tell(tr("The change is canceled; the scene stays as it was"));
    }
    Q_EMIT changed();
}

void SceneEdits::undo() {
    if (opening_) {
        cancel();
        return;
    }
    if (runs_.run() == nullptr || undoName().isEmpty()) {
        return;
    }
    Target next = target();
    if (next.steps.empty()) {
        --next.index;
    } else {
        next.steps.pop_back();
    }
    goTo(next);
}

void SceneEdits::redo() {
    if (runs_.run() != nullptr && !redoName().isEmpty()) {
        Target next = target();
        ++next.index;
        goTo(next);
    }
}

QString SceneEdits::undoName() const {
    if (!runs_.editRefusal().isEmpty()) {
        return {};
    }
    if (opening_) {
        return tr("Open %1").arg(opening_->name);
    }
    const Target now = target();
    if (!now.steps.empty()) {
        return now.steps.back().name;
    }
    return now.index > 0 ? history_.nameOf(now.index - 1) : QString();
}

QString SceneEdits::redoName() const {
    const Target now = target();
    return now.steps.empty() && !opening_ && runs_.editRefusal().isEmpty() &&
                   now.index < history_.count()
               ? history_.nameOf(now.index)
               : QString();
}

}  // namespace asperity
