/// Opens the live window, approaches to the setpoint of the scene and retracts, and saves what the
/// window shows of the whole cycle: far, snapped in, at the setpoint, shortly before pull-off and
/// off. Usage: asperity_screenshots SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX

#include "app/commands/VirtualDisplay.h"
#include "app/session/LiveWindow.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"

#include <QStatusBar>
#include <QTimer>

#include <functional>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr double kDuration = 12.0;  // of the approach and the way back [s]

/// A moment of an approach and a retract that is worth a picture.
struct Moment {
    const char* name;
    std::function<bool(Session&)> hasCome;
    bool isLast = false;  ///< its last frame is wanted, not its first
};

const TickOutput& newest(Session& session) {
    return session.run()->loop().snapshot().sample.output;
}

bool isIn(Session& session, ApproachPhase phase) {
    const ApproachDevice* const approach = session.devices().approaching();
    return approach != nullptr && approach->phase() == phase;
}

bool isBonded(Session& session) {
    return newest(session).model.contact.branch == ContactBranch::Bonded;
}

bool isPulled(Session& session) {
    return isBonded(session) && newest(session).model.contact.force < 0.0 &&
           isIn(session, ApproachPhase::Retract);
}

/// In their order.
std::vector<Moment> moments() {
    return {{"far",
             [](Session& session) { return session.run()->loop().snapshot().sample.time > 1.0; }},
            {"snapped_in", isBonded},
            {"indenting", [](Session& session) { return isIn(session, ApproachPhase::Dwell); }},
            {.name = "retracting", .hasCome = isPulled, .isLast = true},
            {"off", [](Session& session) { return !isBonded(session); }}};
}

/// Watches the run from frame to frame and saves a picture of each moment.
class Photographer {
public:
    Photographer(LiveWindow& live, std::string prefix) : live_(live), prefix_(std::move(prefix)) {}

    void look() {
        if (isDone()) {
            return;
        }
        if (moments_[next_].hasCome(live_.session())) {
            save(moments_[next_++]);
        } else if (next_ > 0 && moments_[next_ - 1].isLast &&
                   moments_[next_ - 1].hasCome(live_.session())) {
            save(moments_[next_ - 1]);
        }
        if (isDone()) {
            live_.window().close();
        }
    }

    [[nodiscard]] bool isDone() const { return next_ == moments_.size(); }
    [[nodiscard]] const char* awaited() const { return moments_[next_].name; }

private:
    void save(const Moment& moment) {
        live_.window().statusBar()->clearMessage();  // it names the file of the picture before
        Q_EMIT live_.window().pictureFileChosen(
            QString::fromStdString(prefix_ + moment.name + ".png"));
    }

    LiveWindow& live_;
    std::string prefix_;
    std::vector<Moment> moments_ = moments();
    std::size_t next_ = 0;
};

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live;
    live.window().resize(std::stoi(argv[2]), std::stoi(argv[3]));
    live.session().runs().use(loadScene(argv[1], {}));
    const Scene& scene = live.session().run()->scene();
    live.session().devices().approach(planApproach(
        scene, {.duration = kDuration, .place = Vector2(startPlace(scene).head<2>())}));
    Photographer photographer(live, argv[4]);
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&photographer] { photographer.look(); });
    timer.start(30);
    QTimer::singleShot(40000, &live.window(), &QWidget::close);
    const int status = live.exec();
    if (!photographer.isDone()) {
        throw Error(std::string("the tip was not seen ") + photographer.awaited());
    }
    return status;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 4,
                                    "asperity_screenshots SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX",
                                    asperity::run);
}
