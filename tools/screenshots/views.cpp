/// Opens the live window with the second view, approaches to the setpoint of the scene and
/// retracts, and saves what docs/views.md is about: the section through the cycle, and at the
/// setpoint each quantity, each color map, the ghosts, the sides and the second view in 3-D. Usage:
/// asperity_view_pictures SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX

#include "app/window/live/LivePanels.h"
#include "tools/screenshots/CycleWindow.h"
#include "tools/screenshots/PictureTool.h"
#include "ui/shell/Menus.h"
#include "ui/view/ColorsMenu.h"
#include "ui/view/ContactPlot.h"
#include "ui/view/SecondView.h"
#include "ui/view/ViewOptionsMenu.h"
#include "ui/view/ZoomView.h"

#include <QAction>
#include <QTimer>

#include <functional>
#include <string>
#include <vector>

namespace asperity {

namespace {

constexpr int kStep = 700;  // from one picture of the setpoint to the next [ms]

/// One after another at the setpoint.
struct Shot {
    std::string name;
    std::function<void()> set;
};

class Photographer {
public:
    explicit Photographer(CycleWindow& cycle) : cycle_(cycle) { addShots(); }

    void see(const std::string& moment) {
        cycle_.save("section_" + moment);
        if (moment == "indenting") {
            cycle_.pause();
            shoot(0);
        }
    }

private:
    MainWindow& window() { return cycle_.window(); }

    void choose(SurfaceQuantity quantity, ColorMap map, RangeRule rule = RangeRule::Full) {
        SurfaceLook look;
        look.quantity = quantity;
        look.of(quantity).map = map;
        look.of(quantity).rule = rule;
        cycle_.panels().colors().choose(look);
    }

    void showSecond(const SecondViewSettings& settings) {
        cycle_.panels().second().setSettings(settings);
        window().menus().entry("secondView").setChecked(true);
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
                              cycle_.panels().view().setOptions(
                                  {.commandedTip = true, .trueTip = true});
                          }});
        shots_.push_back({"cross_hair", [this] {
                              cycle_.panels().view().setOptions({});
                              choose(SurfaceQuantity::Pressure, ColorMap::Diverging);
                              const Vector3 tip = cycle_.newest().tip;
                              Q_EMIT cycle_.panels().view().positionHovered(tip.x(), tip.y());
                          }});
        shots_.push_back(
            {"second_3d", [this] {
                 Q_EMIT cycle_.panels().view().pointerLeft();
                 choose(SurfaceQuantity::Height, ColorMap::Standard);
                 showSecond({.content = SecondContent::Space, .options = {.heightScale = 3.5}});
                 cycle_.panels().second().space().lookFrom(ViewDirection::Front);
             }});
        shots_.push_back({"section_filled", [this] {
                              showSecond(
                                  {.followsContact = false, .azimuth = 45.0, .heightFactor = 0.0});
                              cycle_.panels().view().lookFrom(ViewDirection::Top);
                          }});
        shots_.push_back({"perspective", [this] {
                              cycle_.panels().view().resetCamera();
                              cycle_.panels().view().setPerspective(true);
                          }});
        shots_.push_back({"bottom", [this] {
                              window().menus().entry("secondView").setChecked(false);
                              cycle_.panels().view().setPerspective(false);
                              cycle_.panels().view().lookFrom(ViewDirection::Bottom);
                          }});
    }

    void chooseChannel() {
        SurfaceLook look;
        const std::vector<std::string>& images = cycle_.stage().run()->loaded().images;
        if (!images.empty()) {
            look.quantity = SurfaceQuantity::Channel;
            look.channel = QString::fromStdString(images.front());
        }
        cycle_.panels().colors().choose(look);
    }

    /// Sets a picture up, and saves it once it has come to rest.
    void shoot(std::size_t index) {
        if (index == shots_.size()) {
            cycle_.panels().view().resetCamera();
            showSecond({});
            cycle_.resume();
            return;
        }
        shots_[index].set();
        QTimer::singleShot(kStep, &window(), [this, index] {
            cycle_.save(shots_[index].name);
            shoot(index + 1);
        });
    }

    CycleWindow& cycle_;
    std::vector<Shot> shots_;
};

int run(char** argv) {
    CycleWindow cycle(argv);
    cycle.window().menus().entry("secondView").setChecked(true);
    Photographer photographer(cycle);
    return cycle.run([&](const std::string& moment) { photographer.see(moment); });
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool({argv, static_cast<std::size_t>(argc)}, 4,
                                    "asperity_view_pictures SCENE_OR_SCAN WIDTH HEIGHT OUT_PREFIX",
                                    asperity::run);
}
