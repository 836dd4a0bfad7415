#include "app/session/DeviceControl.h"

#include "core/Error.h"
#include "core/haptics/LiftStep.h"
#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/scene/SettingFields.h"
#include "core/words/DeviceWords.h"
#include "core/words/ScaleWords.h"
#include "hardware/DeviceRegistry.h"
#include "hardware/piloted/PilotedDrivers.h"
#include "ui/CoreWords.h"
#include "ui/HeldKeys.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

#include <algorithm>
#include <utility>

namespace asperity {

namespace {

constexpr double kKeySpeed = 0.25;    // along the sample, of held keys [half widths/s]
constexpr double kTurnSpeed = 1.0;    // of a device's axes: the force turns with them [rad/s]
constexpr double kKeySpeedUp = 0.05;  // and across it [half widths/s]

/// Where held keys send the device, world frame [half widths/s].
Vector3 keyVelocity(const KeyDirection& keys, const ViewCamera& camera) {
    const Vector3 forward = Vector3::UnitZ().cross(camera.right());
    return kKeySpeed * (keys.right * camera.right() + keys.forward * forward) +
           kKeySpeedUp * keys.up * Vector3::UnitZ();
}

}  // namespace

DeviceControl::DeviceControl(MainWindow& window, RunControl& runs)
    : window_(window), runs_(runs), keys_(new HeldKeys(&window.view())) {
    const auto drivers = deviceDrivers();
    list_.assign(drivers.begin(), drivers.end());
    list_.insert(list_.begin() + 1, nullptr);
    QStringList names;
    for (const DeviceDriver* const driver : list_) {
        names << (driver != nullptr ? tr(driver->label) : tr("Scripted path"));
    }
    ControlBar& controls = window.controls();
    controls.setDevices(names);
    connect(&controls, &ControlBar::deviceChosen, this, &DeviceControl::choose);
    connect(&controls, &ControlBar::knobTurned, this, &DeviceControl::turnKnob);
    connect(&window.view(), &ZoomView::tipDragged, this, [this](double dx, double dy) {
        if (runs_.tipRefusal().isEmpty()) {
            device_.displace({dx, dy, 0.0});
        }
    });
    connect(&window.view(), &ZoomView::lifted, this, [this](double notches) {
        if (runs_.run() != nullptr && runs_.tipRefusal().isEmpty()) {
            const Scene& scene = runs_.run()->scene();
            device_.lift(notches,
                         fineLiftStep(window_.view().halfWidth(), scene.description.setpoint,
                                      scene.belief.cantilever.stiffness()));
        }
    });
    connect(&window.overview(), &OverviewPanel::placeChosen, this, [this](double x, double y) {
        travelTo({x, y});
    });
    connect(window.menus().calibrate, &QAction::triggered, this, [this] {
        if (runs_.run() != nullptr) {
            runs_.run()->device().calibrate();
        }
    });
    connect(&window.menus(), &WindowMenus::guideChosen, this, &DeviceControl::chooseGuide);
    connect(&runs, &RunControl::begun, this, &DeviceControl::attach);
    connect(&runs, &RunControl::rebuilt, this, &DeviceControl::takeUp);
    connect(&runs, &RunControl::ending, this, &DeviceControl::detach);
}

void DeviceControl::attach() {
    device_.attach(*runs_.run());
    show();
}

void DeviceControl::detach() {
    const LiveRun& run = *runs_.run();
    before_ = device_.driver();
    scaleBefore_ = {run.settings().positionGain, run.settings().forceGain};
    device_.detach();
}

void DeviceControl::takeUp() {
    if (before_ == nullptr || before_ == device_.driver()) {
        return;
    }
    use(*before_);
    if (runs_.run()->coupling().coupled() != nullptr) {
        runs_.turn([this](Settings& settings) {
            settings.positionGain = scaleBefore_.positionGain;
            settings.forceGain = scaleBefore_.forceGain;
        });
        tell();
    }
}

void DeviceControl::choose(int index) {
    if (runs_.run() == nullptr) {
        return;
    }
    if (const DeviceDriver* const driver = list_.at(static_cast<std::size_t>(index))) {
        use(*driver);
    } else {
        Q_EMIT pathWanted();
    }
}

void DeviceControl::use(const DeviceDriver& driver) {
    try {
        device_.use(driver);
        tell();
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
    show();
}

void DeviceControl::follow(const DevicePath& path) {
    device_.follow(path);
    show();
}

void DeviceControl::approach(const PlannedApproach& approach) {
    device_.approach(approach);
    show();
}

void DeviceControl::engage(double setpoint) {
    device_.engage(setpoint);
    show();
}

void DeviceControl::withdraw() {
    if (device_.followsPath()) {
        use(pointerDriver());
    }
    const Vector3 base = runs_.run()->basePosition();
    if (base.z() < waitingPlace(runs_.run()->scene(), base.head<2>()).z()) {
        travelTo(base.head<2>());
    }
}

void DeviceControl::releaseApproach() {
    if (device_.approaching() != nullptr) {
        use(pointerDriver());
    }
}

void DeviceControl::pilotDevice(const DevicePath& path) {
    device_.use(simulatedDriver());
    device_.pilotAlong(path);
    show();
}

void DeviceControl::travelTo(const Vector2& place) {
    if (runs_.run() == nullptr) {
        return;
    }
    const QString& why = runs_.fixedBy().isEmpty() ? runs_.tipRefusal() : runs_.fixedBy();
    if (!why.isEmpty()) {
        window_.tell(why);
        return;
    }
    if (device_.driver() != &pointerDriver()) {
        device_.use(pointerDriver());
        show();
    }
    device_.travelTo(place);
}

void DeviceControl::turnKnob(const QString& column, double value) {
    // A number that was being typed into the knob when it was disabled.
    if (column == QLatin1String("position_gain") && device_.followsPath()) {
        window_.controls().setKnobs(runs_.run()->settings());
        return;
    }
    runs_.turn([&](Settings& settings) { setSetting(settings, column.toStdString(), value); });
}

void DeviceControl::chooseGuide(FixtureKind kind) {
    if (runs_.run() == nullptr) {
        return;
    }
    LiveRun& run = *runs_.run();
    const TickSample sample = run.loop().snapshot().sample;
    runs_.turn([&](Settings& settings) {
        settings.guide = run.scene().description.settings.guide;
        settings.guide.kind = kind;
        settings.guide.axis = Vector3::UnitZ();
        settings.guide.point = settings.positionControl == PositionControl::Tip
                                   ? sample.output.model.tip
                                   : sample.output.base.position;
    });
}

void DeviceControl::advance(double seconds) {
    const double halfWidth = window_.view().halfWidth();
    const Vector3 keys = keyVelocity(keys_->direction(), window_.view().camera());
    device_.setVelocity(runs_.tipRefusal().isEmpty() ? Vector3(halfWidth * keys)
                                                     : Vector3(Vector3::Zero()));
    device_.advance(seconds, halfWidth);
    turnAxes(seconds);
    const std::string words = wordsOf(runs_.run()->device().status());
    if (words != std::exchange(told_, words) && !words.empty()) {
        window_.tell(coreWords(words));
    }
    followDelay();
}

void DeviceControl::turnAxes(double seconds) {
    const bool turns = window_.menus().followsView->isChecked() && device_.isHardware();
    const ViewCamera& camera = window_.view().camera();
    const auto axes = turns ? viewAxes(camera.right(), camera.up()) : std::nullopt;
    const Vector3 wanted = axes ? turnOf(*axes) : Vector3(Vector3::Zero());
    const Vector3& now = runs_.run()->settings().deviceTurn;
    const Vector3 turned = turnedTowards(now, wanted, kTurnSpeed * seconds);
    if (turned != now) {
        runs_.turn([&turned](Settings& settings) { settings.deviceTurn = turned; });
    }
}

void DeviceControl::followDelay() {
    if (!runs_.run()->followDelay()) {
        return;
    }
    show();
    const CoupledDevice& coupled = *runs_.run()->coupling().coupled();
    if (coupled.holds()) {
        tell();
    } else {
        window_.complain(tr("Forces are off: %1").arg(coreWords(refusalOf(coupled))));
    }
}

void DeviceControl::show() {
    const bool isListed = device_.driver() != nullptr || device_.followsPath();
    const auto found = std::find(list_.begin(), list_.end(), device_.driver());
    window_.controls().setDevice(isListed ? static_cast<int>(found - list_.begin()) : -1);
    window_.setEmergencyStop(runs_.run()->device().specification().rendersForce());
    window_.controls().refuseKnob(
        "position_gain",
        device_.followsPath()
            ? tr("A path gives positions on the scan: the position gain has no effect")
            : QString());
    runs_.showKnobs();
}

/// Of one with motors: its scale, and what is felt; so short that the bottom line has room for it.
void DeviceControl::tell() {
    if (const CoupledDevice* const coupled = runs_.run()->coupling().coupled()) {
        const Settings& settings = runs_.run()->settings();
        window_.tell(
            coreWords(feltWords({settings.positionGain, settings.forceGain}, coupled->judgment)));
    }
}

}  // namespace asperity
