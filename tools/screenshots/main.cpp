/// Opens the live window, approaches to the setpoint of the scene and retracts, and saves what the
/// window shows at the setpoint and shortly before pull-off. Usage: asperity_screenshots
/// SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX

#include "app/commands/VirtualDisplay.h"
#include "app/session/LiveWindow.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"

#include <QStatusBar>
#include <QTimer>

#include <numbers>
#include <string>

namespace asperity {

namespace {

constexpr double kDuration = 12.0;  // of the approach and the way back [s]

/// Watches the run from frame to frame and saves each picture once.
class Photographer {
public:
    Photographer(LiveWindow& live, std::string prefix) : live_(live), prefix_(std::move(prefix)) {}

    void look() {
        Session& session = live_.session();
        const TickOutput& now = session.run()->loop().snapshot().sample.output;
        const bool bonded = now.model.contact.branch == ContactBranch::Bonded;
        const ApproachDevice* const approach = session.devices().approaching();
        if (!indented_ && approach != nullptr && approach->phase() == ApproachPhase::Dwell) {
            save("indenting");
            indented_ = true;
        }
        if (indented_ && !retracting_ && bonded &&
            now.model.contact.force < 0.9 * pull(now.model)) {
            save("retracting");
            retracting_ = true;
            live_.window().close();
        }
    }

    [[nodiscard]] bool isDone() const { return retracting_; }

private:
    /// Force at which the tip lets go, about [N].
    [[nodiscard]] double pull(const TipState& state) const {
        const ContactPair pair = contactModelAt(live_.session().run()->scene(), state).pair();
        return -1.3 * std::numbers::pi * pair.tipRadius * pair.workOfAdhesion;
    }
    void save(const std::string& name) {
        live_.window().statusBar()->clearMessage();  // it names the file of the picture before
        Q_EMIT live_.window().pictureFileChosen(QString::fromStdString(prefix_ + name + ".png"));
    }

    LiveWindow& live_;
    std::string prefix_;
    bool indented_ = false;
    bool retracting_ = false;
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
        throw Error("the tip was not seen indenting and about to pull off");
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
