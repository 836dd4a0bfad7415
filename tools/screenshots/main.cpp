/// Opens the live window, lets a scripted device indent and retract, and saves what the window
/// shows at the deepest indentation and shortly before pull-off. Usage: asperity_screenshots
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

constexpr double kIndent = 3.0;  // time to go in, and again to come out [s]
constexpr double kDepth = 4e-9;  // of the base below first touch [m]

/// Straight down in the middle of the scan, a slide, and slowly up again.
DevicePath path(const Scene& scene) {
    const Vector3 above = startPlace(scene);
    PathPlan plan{.duration = 4.0 * kIndent, .indentation = kDepth, .slideLength = 12e-9};
    plan.place = above.head<2>();
    return slidePath(scene, plan);
}

/// Watches the run from frame to frame and saves each picture once.
class Photographer {
public:
    Photographer(LiveWindow& live, std::string prefix) : live_(live), prefix_(std::move(prefix)) {}

    void look() {
        const TickOutput& now = live_.session().run()->loop().snapshot().sample.output;
        const double indentation = now.model.contact.indentation;
        const bool bonded = now.model.contact.branch == ContactBranch::Bonded;
        if (!indented_ && bonded && indentation > 0.0 && settled(indentation)) {
            save("indenting");
            indented_ = true;
        }
        if (indented_ && !retracting_ && bonded &&
            now.model.contact.force < 0.9 * pull(now.model)) {
            save("retracting");
            retracting_ = true;
            live_.window().close();
        }
        last_ = indentation;
    }

    [[nodiscard]] bool isDone() const { return retracting_; }

private:
    [[nodiscard]] bool settled(double indentation) const {
        return indentation > 0.5e-9 && indentation <= last_;
    }
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
    double last_ = 0.0;
    bool indented_ = false;
    bool retracting_ = false;
};

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live;
    live.window().resize(std::stoi(argv[2]), std::stoi(argv[3]));
    live.session().runs().use(loadScene(argv[1], {}));
    live.session().paths().follow(path(live.session().run()->scene()));
    Photographer photographer(live, argv[4]);
    QTimer timer;
    QObject::connect(&timer, &QTimer::timeout, [&photographer] { photographer.look(); });
    timer.start(30);
    QTimer::singleShot(40000, &live.window(), &QWidget::close);
    const int status = live.exec();
    if (!photographer.isDone()) {
        throw Error("the tip was not seen indenting and about to let go");
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
