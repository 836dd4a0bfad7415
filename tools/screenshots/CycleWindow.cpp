#include "tools/screenshots/CycleWindow.h"

#include "app/loading/SceneLoader.h"
#include "app/window/ViewControl.h"
#include "app/window/device/DeviceControl.h"
#include "app/window/live/CyclePanel.h"
#include "app/window/live/ForcePanel.h"
#include "app/window/live/LivePanels.h"
#include "core/Error.h"
#include "ui/shell/MainWindow.h"

#include <QStatusBar>

#include <array>
#include <utility>

namespace asperity {

namespace {

constexpr double kDuration = 12.0;    // of the approach and the way back [s]
constexpr double kSlowest = 200.0;    // the same [s]
constexpr int kWatch = 30;            // [ms]
constexpr int kLooksStanding = 2000;  // with no newer tick: the loop stands still

/// A moment of an approach and a retract that is worth a picture.
struct Moment {
    const char* name;
    bool (*hasCome)(CycleWindow&);
    bool isLast = false;  ///< its last frame is wanted, not its first
};

bool isIn(CycleWindow& cycle, ApproachPhase phase) {
    const ApproachDevice* const approach = cycle.stage().get<DeviceControl>().approaching();
    return approach != nullptr && approach->phase() == phase;
}

bool isBonded(CycleWindow& cycle) {
    return cycle.newest().model.contact.branch == ContactBranch::Bonded;
}

bool isPulled(CycleWindow& cycle) {
    return isBonded(cycle) && cycle.newest().model.contact.force < 0.0 &&
           isIn(cycle, ApproachPhase::Retract);
}

/// In their order.
constexpr std::array kMoments{
    Moment{"far",
           [](CycleWindow& cycle) {
               return cycle.stage().run()->loop().snapshot().sample.time > 1.0;
           }},
    Moment{"snapped_in", isBonded},
    Moment{"indenting", [](CycleWindow& cycle) { return isIn(cycle, ApproachPhase::Dwell); }},
    Moment{.name = "retracting", .hasCome = isPulled, .isLast = true},
    Moment{"off", [](CycleWindow& cycle) { return !isBonded(cycle); }}};

}  // namespace

CycleWindow::CycleWindow(char** arguments)
    : scene_(arguments[1]), prefix_(arguments[4]), duration_(kDuration) {
    window().resize(std::stoi(arguments[2]), std::stoi(arguments[3]));
    begin();
    QObject::connect(&timer_, &QTimer::timeout, [this] { look(); });
}

void CycleWindow::begin() {
    next_ = 0;
    stage().runs().use(loadScene(scene_, {}));
    panels().forces().cycles().clear();  // of a cycle that was too fast
    const Scene& scene = stage().run()->scene();
    stage().get<DeviceControl>().approach(planApproach(
        scene, {.duration = duration_, .position = Vector2(startPosition(scene).head<2>())}));
}

const TickOutput& CycleWindow::newest() { return stage().run()->loop().snapshot().sample.output; }

void CycleWindow::save(const std::string& name) {
    window().statusBar()->clearMessage();  // it names the file of the picture before
    stage().get<ViewControl>().savePicture(QString::fromStdString(prefix_ + name + ".png"));
}

void CycleWindow::pause() {
    timer_.stop();
    stage().runs().pause();
}

void CycleWindow::resume() {
    stage().runs().start();
    timer_.start(kWatch);
}

void CycleWindow::look() {
    if (kMoments[next_].hasCome(*this)) {
        seen_(kMoments[next_++].name);
    } else if (next_ > 0 && kMoments[next_ - 1].isLast && kMoments[next_ - 1].hasCome(*this)) {
        seen_(kMoments[next_ - 1].name);
    }
    if (next_ < kMoments.size() && isBack() && duration_ < kSlowest) {
        duration_ *= 2.0;
        begin();
    } else if (next_ == kMoments.size() || isBack() || isStanding()) {
        timer_.stop();
        window().close();
    }
}

bool CycleWindow::isBack() { return isIn(*this, ApproachPhase::Done); }

bool CycleWindow::isStanding() {
    const double time = stage().run()->loop().snapshot().sample.time;
    looksSince_ = time == newestTime_ ? looksSince_ + 1 : 0;
    newestTime_ = time;
    return looksSince_ >= kLooksStanding;
}

int CycleWindow::run(std::function<void(const std::string&)> seen) {
    seen_ = std::move(seen);
    timer_.start(kWatch);
    const int status = live_.exec();
    if (next_ < kMoments.size()) {
        throw Error(std::string("the tip was not seen ") + kMoments[next_].name);
    }
    return status;
}

}  // namespace asperity
