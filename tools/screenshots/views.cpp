/// Opens the live window with the second view, approaches to the setpoint of the scene and
/// retracts, and saves what docs/views.md is about: the section through the cycle, and at the
/// setpoint each quantity, each color map, the ghosts, the sides and the second view in 3-D. Usage:
/// asperity_view_pictures SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX

#include "app/commands/VirtualDisplay.h"
#include "app/session/LiveWindow.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/ZoomView.h"
#include "ui/window/ColorsMenu.h"
#include "ui/window/SecondView.h"
#include "ui/window/ViewOptionsMenu.h"
#include "ui/window/WindowMenus.h"

#include <QAction>
#include <QStatusBar>
#include <QTimer>

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

constexpr double kDuration = 12.0;  // of the approach and the way back [s]
constexpr int kStep = 700;          // from one picture of the setpoint to the next [ms]
constexpr int kWatch = 30;          // [ms]

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

/// A moment of the cycle that is worth a picture, in their order.
struct Moment {
    const char* name;
    std::function<bool(Session&)> hasCome;
};

std::vector<Moment> moments() {
    return {{"far",
             [](Session& session) { return session.run()->loop().snapshot().sample.time > 1.0; }},
            {"snapped_in", isBonded},
            {"indenting", [](Session& session) { return isIn(session, ApproachPhase::Dwell); }},
            {"retracting",
             [](Session& session) {
                 return isBonded(session) && newest(session).model.contact.force < 0.0 &&
                        isIn(session, ApproachPhase::Retract);
             }},
            {"off", [](Session& session) { return !isBonded(session); }}};
}

/// One after another at the setpoint.
struct Shot {
    std::string name;
    std::function<void()> set;
};

class Photographer {
public:
    Photographer(LiveWindow& live, std::string prefix) : live_(live), prefix_(std::move(prefix)) {
        addShots();
        QObject::connect(&timer_, &QTimer::timeout, [this] { look(); });
        timer_.start(kWatch);
    }

    [[nodiscard]] bool isDone() const { return next_ == moments_.size(); }

private:
    MainWindow& window() { return live_.window(); }

    void choose(SurfaceQuantity quantity, ColorMap map, RangeRule rule = RangeRule::Full) {
        SurfaceLook look;
        look.quantity = quantity;
        look.of(quantity).map = map;
        look.of(quantity).rule = rule;
        window().menus().colors().choose(look);
    }

    void showSecond(const SecondViewSettings& settings) {
        window().second().setSettings(settings);
        window().menus().secondView->setChecked(true);
    }

    void addShots() {
        for (const SurfaceQuantity quantity : kValues<SurfaceQuantity>) {
            const ColorMap map = SurfaceLook().of(quantity).map;
            shots_.push_back({std::string("by_") + keyOf(quantity), [this, quantity, map] {
                                  if (quantity == SurfaceQuantity::Channel) {
                                      chooseChannel();
                                  } else {
                                      choose(quantity, map);
                                  }
                              }});
        }
        for (const ColorMap map : kValues<ColorMap>) {
            shots_.push_back({std::string("map_") + keyOf(map),
                              [this, map] { choose(SurfaceQuantity::Height, map); }});
        }
        shots_.push_back({"clipped", [this] {
                              choose(SurfaceQuantity::Height, ColorMap::Gold, RangeRule::Percent);
                          }});
        shots_.push_back({"ghosts", [this] {
                              choose(SurfaceQuantity::Height, ColorMap::Standard);
                              window().view().setOptions({.commandedTip = true, .trueTip = true});
                          }});
        shots_.push_back({"cross_hair", [this] {
                              window().view().setOptions({});
                              choose(SurfaceQuantity::Pressure, ColorMap::Diverging);
                              const Vector3 tip = newest(live_.session()).tip;
                              Q_EMIT window().view().placeHovered(tip.x(), tip.y());
                          }});
        shots_.push_back(
            {"second_3d", [this] {
                 Q_EMIT window().view().placeLeft();
                 choose(SurfaceQuantity::Height, ColorMap::Standard);
                 showSecond({.content = SecondContent::Space, .options = {.heightScale = 3.5}});
                 window().second().space().lookFrom(ViewDirection::Front);
             }});
        shots_.push_back({"section_filled", [this] {
                              showSecond({.azimuth = 45.0, .heightFactor = 0.0});
                              window().view().lookFrom(ViewDirection::Top);
                          }});
        shots_.push_back({"perspective", [this] {
                              window().view().resetCamera();
                              window().view().setPerspective(true);
                          }});
    }

    void chooseChannel() {
        SurfaceLook look;
        const std::vector<std::string>& images = live_.session().run()->loaded().images;
        if (!images.empty()) {
            look.quantity = SurfaceQuantity::Channel;
            look.channel = QString::fromStdString(images.front());
        }
        window().menus().colors().choose(look);
    }

    void look() {
        if (isDone() || !moments_[next_].hasCome(live_.session())) {
            return;
        }
        const Moment& moment = moments_[next_++];
        save(std::string("section_") + moment.name);
        if (std::string(moment.name) == "indenting") {
            timer_.stop();
            live_.session().runs().pause();
            shoot(0);
        } else if (isDone()) {
            window().close();
        }
    }

    /// Sets a picture up, and saves it once it has come to rest.
    void shoot(std::size_t index) {
        if (index == shots_.size()) {
            window().view().setPerspective(false);
            showSecond({});
            live_.session().runs().start();
            timer_.start(kWatch);
            return;
        }
        shots_[index].set();
        QTimer::singleShot(kStep, &window(), [this, index] {
            save(shots_[index].name);
            shoot(index + 1);
        });
    }

    void save(const std::string& name) {
        window().statusBar()->clearMessage();  // it names the file of the picture before
        Q_EMIT window().pictureFileChosen(QString::fromStdString(prefix_ + name + ".png"));
    }

    LiveWindow& live_;
    std::string prefix_;
    std::vector<Moment> moments_ = moments();
    std::vector<Shot> shots_;
    std::size_t next_ = 0;
    QTimer timer_;
};

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live;
    live.window().resize(std::stoi(argv[2]), std::stoi(argv[3]));
    live.session().runs().use(loadScene(argv[1], {}));
    const Scene& scene = live.session().run()->scene();
    live.session().devices().approach(planApproach(
        scene, {.duration = kDuration, .place = Vector2(startPlace(scene).head<2>())}));
    live.window().menus().secondView->setChecked(true);
    Photographer photographer(live, argv[4]);
    QTimer::singleShot(90000, &live.window(), &QWidget::close);
    const int status = live.exec();
    if (!photographer.isDone()) {
        throw Error("the cycle was not seen to its end");
    }
    return status;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 4,
                                    "asperity_view_pictures SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX",
                                    asperity::run);
}
