#include "app/window/device/PathControl.h"

#include "app/recording/RecordedRun.h"
#include "app/runs/RunFolder.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/EngageBar.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "core/Error.h"
#include "core/io/scene/DevicePathFile.h"
#include "core/words/SceneWords.h"
#include "ui/shell/FileDialogs.h"
#include "ui/shell/Menus.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QFileInfo>
#include <QPolygonF>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace asperity {

namespace {

/// A path in other units than meters, or of a larger scan, would lead the tip far away, and take as
/// long. @param why it may do so
/// @throw InputError when the path leaves the scan by more than its width
void requireNear(const Scene& scene, const DevicePath& path, const std::string& file,
                 const std::string& why) {
    const double reach = 2.0 * std::max(scene.surface.sizeX(), scene.surface.sizeY());
    for (const PathPoint& point : path) {
        const Vector2 position = point.position.head<2>();
        if (!scene.surface.contains(position.x(), position.y()) && position.norm() > reach) {
            throw InputError(file, "at " + std::to_string(point.time) + " s",
                             "the path leaves the scan by more than its width: " + why);
        }
    }
}

constexpr double kMaxPoints = 5000.0;  // of a way: more than a plot shows
constexpr double kShortest = 1e-3;     // way to the first position of a file [s]

constexpr const char* kInMeters = "x_m, y_m and z_m must be meters from its lower left corner";

/// Returns the samples of a recording and of the run where they differ: "recorded on ps.gwy,
/// channel Height; followed on steps.gsf, channel Height". Empty: it is the same, or nobody knows.
QString bothSamples(const LoadedScene& here, const std::filesystem::path& recording) {
    const std::optional<RecordedSample> recorded = sampleOf(recording);
    const SampleDescription& sample = here.scene.description.sample;
    const std::string name = sampleName(sample);
    const auto isSame = [&] {
        return recorded->sha256 == here.sha256 && recorded->channel == sample.channel &&
               recorded->crop == sample.crop && (!here.sha256.empty() || recorded->name == name);
    };
    return !recorded || isSame()
               ? QString()
               : PathControl::tr("recorded on %1; followed on %2")
                     .arg(QString::fromStdString(recorded->name), QString::fromStdString(name));
}

/// A path from above, thin enough to draw [m].
QPolygonF outline(const DevicePath& path) {
    constexpr std::size_t kPoints = 1000;
    QPolygonF way;
    const std::size_t step = 1 + path.size() / kPoints;
    for (std::size_t i = 0; i < path.size(); i += step) {
        way << QPointF(path[i].position.x(), path[i].position.y());
    }
    return way;
}

/// Returns a path repeated, with a second from its end to its start.
DevicePath repeated(const DevicePath& path, int times) {
    constexpr double kBack = 1.0;  // [s]
    DevicePath all = path;
    for (int i = 1; i < times; ++i) {
        const double shift = all.back().time + kBack - path.front().time;
        for (const PathPoint& point : path) {
            all.push_back({point.time + shift, point.position});
        }
    }
    return all;
}

}  // namespace

LineRecord::LineRecord(const DevicePath& path, const std::optional<LinesPlan>& lines) {
    const Vector3 along = lines ? Vector3(std::cos(lines->direction), std::sin(lines->direction), 0)
                                : Vector3(Vector3::Zero());
    double distance = 0.0;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vector3 step = path[i].position - path[i - 1].position;
        const double way = step.head<2>().norm();
        const double forward = lines ? step.dot(along) / way : 1.0;
        const bool crosses = std::abs(forward) < 0.5;  // to the next line
        if (way > 0.0 && !crosses) {
            const bool isTrace = forward > 0.0;
            const bool isNewLine = ways_.empty() || (isTrace && lines);
            ways_.push_back({.begin = path[i - 1].time,
                             .end = path[i].time,
                             .line = (ways_.empty() ? 0 : ways_.back().line) + (isNewLine ? 1 : 0),
                             .isTrace = isTrace,
                             .start = lines && isTrace ? 0.0 : distance,
                             .reach = lines && !isTrace ? -way : way,
                             .direction = lines ? along : Vector3(step / way)});
            distance = lines ? (isTrace ? way : 0.0) : distance + way;
            length_ = std::max(length_, distance);
        }
    }
}

int LineRecord::lineAt(double time) const {
    const auto after = std::ranges::find_if(ways_, [&](const Way& way) { return time < way.end; });
    return ways_.empty() ? 0 : (after == ways_.end() ? ways_.back() : *after).line;
}

void LineRecord::take(double time, const TickOutput& output, double height) {
    while (next_ < ways_.size() && time >= ways_[next_].end) {
        ++next_;
    }
    if (next_ == ways_.size() || time < ways_[next_].begin) {
        return;
    }
    const Way& way = ways_[next_];
    if (way.line == line_ && time < last_ + (way.end - way.begin) / kMaxPoints) {
        return;
    }
    last_ = time;
    if (way.line != std::exchange(line_, way.line)) {
        heights_ = {};
        forces_ = {};
    }
    const double share = (time - way.begin) / (way.end - way.begin);
    const double distance = way.start + share * way.reach;
    const auto add = [&](LinePlot::Ways& ways, double value) {
        (way.isTrace ? ways.trace : ways.retrace).append({distance, value});
    };
    add(heights_, height);
    add(forces_, output.estimate.force.dot(way.direction));
}

PathControl::PathControl(Stage& stage)
    : Feature(stage)
    , devices_(stage.get<DeviceControl>())
    , engaging_(stage.get<EngageControl>())
    , page_(new PathPage(&host_.widget())) {
    QStringList names;
    for (const PlannedPath path : kValues<PlannedPath>) {
        names << QString::fromUtf8(nameOf(path));
    }
    live_.controls().setPaths(names);
    host_.addTool(page_, tr("Path"));
    stage.onTick([this](const TickSample& sample) { take(sample); });
    stage.onFrame(FrameStep::Act, [this](double /*elapsed*/) { advance(); });
    connect(&live_.controls(), &ControlBar::pathChosen, this, &PathControl::choose);
    connect(&devices_, &DeviceControl::pathWanted, this, &PathControl::show);
    connect(&engaging_, &EngageControl::engaged, this, [this] {
        if (state_ == State::Engaging) {
            begin();
        }
    });
    connect(&engaging_, &EngageControl::failed, this, [this] {
        if (state_ == State::Engaging) {
            state_ = State::Idle;
            page_->setRunning(false, tr("Not started: the tip did not engage"));
        }
    });
    connect(&runs_, &RunControl::begun, this, [this] {
        if (runs_.isOnOtherScan()) {
            forgetScan();
        }
        page_->setSetpoint(runs_.run()->scene().description.setpoint);
        page_->setRefusal(runs_.moveRefusal());
    });
    connect(&runs_, &RunControl::ending, this, [this] {
        state_ = State::Idle;
        page_->setRunning(false, tr("Choose a path, then Start"));
    });
    connect(&edits_, &SceneEdits::changed, this, [this] {
        if (const SceneDescription* const scene = edits_.wanted()) {
            page_->setSetpoint(scene->setpoint);
        }
    });
    page_->setRefusal(tr("No scan is open"));
    connectPage();
    addEntries();
}

/// Forgets the file, length and plots of another scan: they say nothing of this one.
void PathControl::forgetScan() {
    const Scene& scene = runs_.run()->scene();
    file_.reset();
    record_.reset();
    page_->forgetFile();
    page_->heights().setWays({}, 0.0);
    page_->forces().setWays({}, 0.0);
    page_->setScan(scene.surface.sizeX(), scene.surface.finestPitch(),
                   scene.description.tip.radius);
}

void PathControl::connectPage() {
    connect(page_, &PathPage::changed, this, &PathControl::showChosen);
    connect(page_, &PathPage::hidden, this, [this] {
        if (state_ == State::Idle) {
            showOnScan({});
        }
    });
    connect(page_, &PathPage::gainChanged, &engaging_, &EngageControl::setGain);
    connect(page_, &PathPage::startChosen, this, &PathControl::start);
    connect(page_, &PathPage::stopChosen, this, [this] { end(tr("Path stopped")); });
}

void PathControl::addEntries() {
    Menus& menus = host_.menus();
    const auto refusal = [this] { return runs_.moveRefusal(); };
    const QAction& page =
        menus.add({MenuName::Run, 1, 5}, "showPath",
                  {.text = tr("Follow a pa&th…"),
                   .tip = tr("Lines at a constant force or height, approaches, paths of files")});
    const QAction& file = menus.add({MenuName::Run, 1, 10}, "followPathFile",
                                    {.text = tr("Follow a path from a fi&le…"),
                                     .tip = tr("Move the base along a path from a CSV file"),
                                     .refusal = refusal});
    const QAction& recording = menus.add({MenuName::Run, 1, 20}, "followRecording",
                                         {.text = tr("Replay a &recording…"),
                                          .tip = tr("Move the base as in a recorded run"),
                                          .refusal = refusal});
    const auto askForFile = [this] {
        const QString chosen =
            askWhatToOpen(&host_.widget(), {.kind = FileKind::Path,
                                            .title = tr("Follow a path"),
                                            .filters = tr("Paths: time_s, x_m, y_m, z_m (*.csv)")});
        if (!chosen.isEmpty()) {
            chooseFile(chosen);
        }
    };
    connect(&page, &QAction::triggered, this, &PathControl::show);
    connect(&file, &QAction::triggered, this, askForFile);
    connect(&live_.controls(), &ControlBar::pathFileRequested, this, askForFile);
    connect(page_, &PathPage::fileRequested, this, askForFile);
    connect(&recording, &QAction::triggered, this, [this] {
        const QString chosen = askWhatToOpen(
            &host_.widget(), {.kind = FileKind::Recording,
                              .title = tr("Replay a recording"),
                              .filters = tr("Force logs (%1 %2 *.csv)")
                                             .arg(QLatin1String(run_files::kLog),
                                                  QLatin1String(run_files::kTables))});
        if (!chosen.isEmpty()) {
            replayRecording(chosen.toStdString());
        }
    });
}

void PathControl::show() {
    host_.showTool(page_);
    showChosen();
}

void PathControl::choose(int index) {
    if (runs_.run() != nullptr) {
        page_->choose(kValues<PlannedPath>.at(static_cast<std::size_t>(index)));
        show();
    }
}

void PathControl::chooseFile(const QString& file) {
    std::optional<DevicePath> path = readFile(file, readDevicePath, kInMeters);
    if (path) {
        file_ = std::move(path);
        page_->chooseFile(QFileInfo(file).fileName());
        show();
    }
}

std::optional<DevicePath> PathControl::readFile(const QString& file, const ReadPath& read,
                                                const std::string& whyFar) {
    if (runs_.run() == nullptr) {
        return std::nullopt;
    }
    try {
        DevicePath path = read(file.toStdString());
        requireNear(runs_.run()->scene(), path, file.toStdString(), whyFar);
        return path;
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
        return std::nullopt;
    }
}

void PathControl::showChosen() {
    if (runs_.run() == nullptr || state_ != State::Idle || !page_->isVisibleTo(&host_.widget())) {
        return;
    }
    const PathRequest request = page_->request();
    live_.controls().setPath(request.isFile ? -1 : static_cast<int>(request.kind));
    const bool isLine = request.isFile || request.kind != PlannedPath::Approach;
    const Vector3 base = runs_.run()->basePosition();
    showOnScan(isLine ? outline(pathOf(request, base)) : outline({{0.0, base}}));
}

DevicePath PathControl::pathOf(const PathRequest& request, const Vector3& base) const {
    if (!request.isFile) {
        return linesPath(base, request.lines);
    }
    // An approach keeps clear of the scan's edge: from there it goes to the file's first position.
    DevicePath path;
    double begin = 0.0;
    if (request.holdsForce) {
        path.push_back({0.0, base});
        begin = std::max((file_->front().position - base).head<2>().norm() / request.lines.speed,
                         kShortest);
    }
    for (const PathPoint& point : repeated(*file_, request.lines.lines)) {
        path.push_back({begin + point.time - file_->front().time, point.position});
    }
    return path;
}

void PathControl::showOnScan(const QPolygonF& path) {
    if (path != std::exchange(shown_, path)) {
        live_.overview().showPath(path);
    }
}

void PathControl::follow(const DevicePath& path) {
    devices_.follow(path);
    showOnScan(outline(path));
}

void PathControl::start() {
    if (runs_.run() == nullptr || state_ != State::Idle) {
        return;
    }
    const PathRequest request = page_->request();
    if (!request.isFile && request.kind == PlannedPath::Approach) {
        done_ = 0;
        startApproach(request);
    } else {
        startLines(request);
    }
}

void PathControl::startApproach(const PathRequest& request) {
    const Scene& scene = runs_.run()->scene();
    PlannedApproach planned = planApproach(
        scene, {.position = runs_.run()->basePosition().head<2>(), .setpoint = request.load});
    planned.plan.speed = request.lines.speed;
    planned.plan.axis = bendingAxis(scene.belief.cantilever);
    devices_.approach(planned);
    taken_ = &runs_.run()->device();
    request_ = request;
    state_ = State::Approaching;
    page_->setRunning(true, tr("Approach %1 of %2").arg(done_ + 1).arg(request.lines.lines));
}

void PathControl::startLines(const PathRequest& request) {
    request_ = request;
    if (!request.holdsForce) {
        begin();
        return;
    }
    if (const QString why = engaging_.holdRefusal(); !why.isEmpty()) {
        host_.tell(why);
        return;
    }
    const Vector3 base = runs_.run()->basePosition();
    const Vector2 first =
        request.isFile ? Vector2(file_->front().position.head<2>()) : Vector2(base.head<2>());
    if (!request.isFile && devices_.feedback() != nullptr && !devices_.followsPath()) {
        begin();
        return;
    }
    state_ = State::Engaging;
    page_->setRunning(true, tr("Engaging"));
    engaging_.engage(request.load, first);
}

void PathControl::begin() {
    DevicePath path;
    double leadTime = 0.0;
    const auto make = [&](const Vector3& base) { return path = pathOf(request_, base); };
    if (request_.holdsForce) {
        devices_.hold(engaging_.held(request_.load), make);
    } else if (request_.isFile) {
        path = pathOf(request_, Vector3::Zero());
        leadTime = devices_.follow(path);
    } else {
        devices_.followFromHere(make);
    }
    taken_ = &runs_.run()->device();
    showOnScan(outline(path));
    record_.emplace(path, request_.isFile ? std::nullopt : std::optional(request_.lines));
    began_ = runs_.run()->loop().snapshot().sample.time + leadTime;
    duration_ = path.back().time;
    state_ = State::Moving;
    page_->setRunning(true, progress(0.0));
}

void PathControl::end(const QString& words) {
    if (state_ == State::Idle) {
        return;
    }
    const bool isOurs = state_ == State::Engaging ? engaging_.isEngaging() : hasTip();
    const bool wasHeld = isOurs && devices_.feedback() != nullptr;
    state_ = State::Idle;
    if (wasHeld && live_.engage().holdsForce()) {
        engaging_.hold();
    } else if (isOurs) {
        devices_.release();
    }
    page_->setRunning(false, words);
    if (!page_->isVisibleTo(&host_.widget())) {
        showOnScan({});
    }
    host_.tell(words);
}

void PathControl::take(const TickSample& sample) {
    if (state_ == State::Moving && record_) {
        const Cantilever& lever = runs_.run()->scene().belief.cantilever;
        const double deflection =
            lever.compliance()(2, 2) * bendingAxis(lever).dot(sample.output.estimate.force);
        record_->take(sample.time - began_, sample.output,
                      sample.output.base.position.z() + deflection);
        isFresh_ = true;
    }
}

QString PathControl::progress(double time) const {
    const QString left = tr("%1 left").arg(siText(std::max(duration_ - time, 0.0), "s"));
    return request_.isFile ? left
                           : tr("Line %1 of %2 · %3")
                                 .arg(record_->lineAt(time))
                                 .arg(request_.lines.lines)
                                 .arg(left);
}

void PathControl::advance() {
    page_->setRefusal(state_ == State::Idle ? runs_.moveRefusal()
                                            : tr("A path runs: stop it first"));
    const bool isLost =
        state_ == State::Engaging ? !engaging_.isEngaging() : state_ != State::Idle && !hasTip();
    if (isLost) {
        end(tr("Path ended: something else moves the tip"));
    } else if (state_ == State::Moving) {
        advanceLines();
    } else if (state_ == State::Approaching) {
        advanceApproach();
    } else if (state_ == State::Idle) {
        showChosen();  // it begins where the tip is
    }
}

bool PathControl::hasTip() const { return taken_ == &runs_.run()->device(); }

void PathControl::advanceApproach() {
    const ApproachDevice& approach = *devices_.approaching();
    if (approach.phase() != ApproachPhase::Done) {
        return;
    }
    if (!approach.hasEngaged()) {
        end(approach.isBlocked()
                ? tr("Approach ended: no equilibrium of tip and cantilever below here")
                : tr("Approach ended: the force did not reach %1").arg(siText(request_.load, "N")));
    } else if (++done_ < request_.lines.lines) {
        startApproach(request_);
    } else {
        end(tr("Path done"));
    }
}

void PathControl::advanceLines() {
    if (std::exchange(isFresh_, false)) {
        page_->heights().setWays(record_->heights(), record_->length());
        page_->forces().setWays(record_->forces(), record_->length());
    }
    const FeedbackDevice* const feedback = devices_.feedback();
    if (feedback != nullptr && feedback->hasStopped()) {
        end(feedback->state() == FeedbackState::RangeLeft ? tr("Path stopped: end of the z range")
                                                          : tr("Path stopped: contact lost"));
        return;
    }
    const double time = runs_.run()->loop().snapshot().sample.time - began_;
    if (time > duration_) {
        end(tr("Path done"));
    } else {
        page_->setRunning(true, progress(time));
    }
}

void PathControl::replayRecording(const std::filesystem::path& forceLog) {
    if (runs_.run() == nullptr) {
        return;
    }
    const std::filesystem::path folder = forceLog.parent_path();
    std::string cutOff;
    const auto read = [&](const std::filesystem::path& file) {
        cutOff = sentenceOf(stateOf(folder));  // may refuse it
        return readRecordedPath(readRunLog(file));
    };
    const QString both = bothSamples(runs_.run()->loaded(), folder);
    const std::optional<DevicePath> path =
        readFile(QString::fromStdString(forceLog.string()), read,
                 both.isEmpty() ? kInMeters : both.toStdString());
    if (!path) {
        return;
    }
    live_.controls().setPath(-1);
    follow(*path);
    QStringList words;
    if (!both.isEmpty()) {
        words << tr("Another scan: %1").arg(both);
    }
    if (!cutOff.empty()) {
        words << QString::fromStdString(cutOff);
    }
    if (!words.isEmpty()) {
        host_.tell(words.join(QStringLiteral(" · ")));
    }
}

}  // namespace asperity
