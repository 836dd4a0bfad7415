/// Opens the live window on a scan, brings it into one of the states of docs/window.md as a user
/// does, saves what the screen shows then, and prints the frames a second of each view.
/// Usage: asperity_window_picture start|profile|profiles|roughness|spectrum|touches|map|path|
///        section|replay|scene|haptics|curves SCENE_OR_SCAN WIDTH HEIGHT OUT.png [dark]
/// curves: the room of measured curves with the file SCENE_OR_SCAN, under a sphere of 5 um.

#include "app/commands/VirtualDisplay.h"
#include "app/loading/SceneLoader.h"
#include "app/program/DataFolder.h"
#include "app/window/Stage.h"
#include "app/window/ViewControl.h"
#include "app/window/curve/CurveFitControl.h"
#include "app/window/curve/CurveFitPage.h"
#include "app/window/lab/LiveWindow.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "app/window/map/ForceMapControl.h"
#include "core/Error.h"
#include "tools/screenshots/PictureTool.h"
#include "ui/shell/Menus.h"
#include "ui/view/OverviewMap.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/Theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QComboBox>
#include <QElapsedTimer>
#include <QLabel>
#include <QMouseEvent>
#include <QStatusBar>
#include <QTabWidget>

#include <functional>
#include <iostream>
#include <map>
#include <string>

namespace asperity {

namespace {

constexpr int kPatience = 60000;  // [ms]
constexpr int kMoment = 1500;     // in which curves and frame rate show something [ms]

/// Lets the window live until something holds.
void waitFor(const std::string& what, const std::function<bool()>& holds) {
    QElapsedTimer time;
    time.start();
    while (!holds()) {
        if (time.elapsed() > kPatience) {
            throw Error("it was not seen within a minute: " + what);
        }
        QApplication::processEvents(QEventLoop::WaitForMoreEvents, 50);
    }
}

void live(int milliseconds) {
    QElapsedTimer time;
    time.start();
    waitFor("time", [&] { return time.elapsed() > milliseconds; });
}

/// A user at the window.
class User {
public:
    explicit User(LiveWindow& live) : live_(live) {}

    void engage() {
        click("engage");
        waitFor("contact", [this] { return region() == TipRegion::Contact; });
        live(kMoment);
    }
    void withdraw() {
        click("withdraw");
        waitFor("the tip far from the sample", [this] { return region() == TipRegion::Far; });
        live(kMoment);
    }
    void touch() {
        engage();
        withdraw();
    }
    /// Drags over the whole scan, by shares of its size.
    void dragOnScan(const QPointF& from, const QPointF& to) {
        OverviewMap& map = live_.panels().overview().map();
        const auto pixel = [&map](const QPointF& share) {
            const QRectF scan = map.mapRect();
            return QPointF(scan.left() + share.x() * scan.width(),
                           scan.top() + share.y() * scan.height());
        };
        const auto send = [&map](QEvent::Type type, const QPointF& position,
                                 Qt::MouseButton button) {
            QMouseEvent event(type, position, map.mapToGlobal(position.toPoint()), button,
                              type == QEvent::MouseButtonRelease ? Qt::NoButton : Qt::LeftButton,
                              Qt::NoModifier);
            QApplication::sendEvent(&map, &event);
        };
        send(QEvent::MouseButtonPress, pixel(from), Qt::LeftButton);
        send(QEvent::MouseMove, pixel(0.5 * (from + to)), Qt::NoButton);
        send(QEvent::MouseMove, pixel(to), Qt::NoButton);
        send(QEvent::MouseButtonRelease, pixel(to), Qt::LeftButton);
    }
    void click(const char* button) {
        auto* found = window().findChild<QAbstractButton*>(QString::fromUtf8(button));
        if (found == nullptr) {
            throw Error(std::string("there is no button ") + button);
        }
        found->click();
    }
    /// A page of the column on the right.
    void showPage(int index) {
        window().findChild<QTabWidget*>(QStringLiteral("sidePages"))->setCurrentIndex(index);
        live(kMoment);
    }
    [[nodiscard]] MainWindow& window() { return live_.window(); }
    [[nodiscard]] Stage& stage() { return live_.stage(); }

private:
    TipRegion region() { return stage().run()->loop().snapshot().sample.output.region(); }

    LiveWindow& live_;
};

void showProfile(User& user) {
    user.window().menus().entry("profile").trigger();
    live(200);
    user.dragOnScan({0.1, 0.5}, {0.9, 0.5});
    live(kMoment);
}

void showRoughness(User& user) {
    user.window().menus().entry("roughness").trigger();
    live(200);
    user.click("drawRectangle");
    user.dragOnScan({0.2, 0.2}, {0.7, 0.6});
    live(kMoment);
}

void showProfiles(User& user) {
    showProfile(user);
    user.click("addProfile");
    user.dragOnScan({0.2, 0.15}, {0.85, 0.9});
    live(kMoment);
}

void showSpectrum(User& user) {
    showRoughness(user);
    user.window().findChild<QComboBox*>(QStringLiteral("roughnessCurve"))->setCurrentIndex(1);
    live(kMoment);
}

void showForceCycles(User& user) {
    user.window().menus().entry("touches").trigger();
    user.touch();
    user.touch();
}

void showMap(User& user) {
    user.window().menus().entry("forceMap").trigger();
    live(kMoment);
    user.click("startMap");
    waitFor("a map", [&] { return user.stage().get<ForceMapControl>().map() != nullptr; });
    user.dragOnScan({0.63, 0.42}, {0.635, 0.425});
    live(kMoment);
}

void showPath(User& user) {
    user.window().menus().entry("showPath").trigger();
    user.click("startPath");
    const auto* progress = user.window().findChild<QLabel*>(QStringLiteral("pathProgress"));
    waitFor("a path", [&] { return progress->text().startsWith(QStringLiteral("Line")); });
    waitFor("its end", [&] { return !progress->text().startsWith(QStringLiteral("Line")); });
    live(kMoment);
}

void showSection(User& user) { user.engage(); }

/// The last pull-off again, in slow motion.
void showReplay(User& user) {
    user.window().menus().entry("secondView").setChecked(true);
    user.touch();
    user.window().menus().entry("replayLastJump").trigger();
    waitFor("the replay", [&] { return user.stage().runs().showsRecording(); });
    live(kMoment);
}

void showCurves(User& user, const char* file) {
    auto& control = user.stage().get<CurveFitControl>();
    auto* const page = user.window().findChild<CurveFitPage*>();
    user.window().menus().entry("fitCurve").trigger();
    page->findChild<QComboBox*>(QStringLiteral("fitTip"))->setCurrentIndex(1);
    bool isShown = false;
    QObject::connect(&control, &CurveFitControl::shown, page, [&isShown] { isShown = true; });
    control.open(file);
    waitFor("a fit", [&isShown] { return isShown; });
    page->resize(user.window().size());
    live(kMoment);
}

int run(char** argv) {
    const VirtualDisplay display;
    LiveWindow live_;
    User user(live_);
    const std::string state = argv[1];
    const std::map<std::string, std::function<void()>> states{
        {"start", [] {}},
        {"profile", [&] { showProfile(user); }},
        {"profiles", [&] { showProfiles(user); }},
        {"roughness", [&] { showRoughness(user); }},
        {"spectrum", [&] { showSpectrum(user); }},
        {"touches", [&] { showForceCycles(user); }},
        {"map", [&] { showMap(user); }},
        {"path", [&] { showPath(user); }},
        {"section", [&] { showSection(user); }},
        {"replay", [&] { showReplay(user); }},
        {"scene", [&] { user.showPage(1); }},
        {"haptics", [&] { user.showPage(2); }},
        {"curves", [&] { showCurves(user, argv[2]); }}};
    const auto show = states.find(state);
    if (show == states.end()) {
        throw Error("no such state: " + state);
    }
    if (argv[6] != nullptr) {
        theme::choose(ThemeChoice::Dark);
    }
    user.window().setGeometry(0, 0, std::stoi(argv[3]), std::stoi(argv[4]));
    user.window().show();
    const bool isOfCurves = state == "curves";
    user.stage().runs().use(loadScene(isOfCurves ? defaultSceneFile().string() : argv[2], {}));
    live(kMoment);
    show->second();
    user.window().statusBar()->clearMessage();
    live(200);
    for (const ViewRate& rate : user.stage().get<ViewControl>().rates()) {
        std::cout << rate.view << ' ' << rate.framesPerSecond << " frames/s\n";
    }
    QWidget& shown = isOfCurves ? static_cast<QWidget&>(*user.window().findChild<CurveFitPage*>())
                                : user.window();
    const bool saved = shown.grab().save(QString::fromUtf8(argv[5]));
    if (!saved) {
        throw Error(std::string(argv[5]) + ": the picture cannot be written");
    }
    return 0;
}

}  // namespace

}  // namespace asperity

int main(int argc, char** argv) {
    return asperity::runPictureTool(
        {argv, static_cast<std::size_t>(argc)}, argc == 7 ? 6 : 5,
        "asperity_window_picture start|profile|profiles|roughness|spectrum|touches|map|path|"
        "section|replay|scene|haptics|curves SCENE_OR_SCAN WIDTH HEIGHT OUT.png [dark]",
        asperity::run);
}
