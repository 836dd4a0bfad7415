#include "app/window/device/DeviceControl.h"

#include "app/program/DataFolder.h"
#include "app/window/live/ControlBar.h"
#include "app/window/live/LivePanels.h"
#include "app/window/live/OverviewPanel.h"
#include "core/Error.h"
#include "core/haptics/DevicePath.h"
#include "core/haptics/SetpointApproach.h"
#include "core/haptics/device/HapticDevice.h"
#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/scene/SettingFields.h"
#include "core/words/DeviceWords.h"
#include "hardware/DeviceRegistry.h"
#include "ui/shell/Menus.h"
#include "ui/view/ZoomView.h"
#include "ui/widgets/HeldKeys.h"
#include "ui/widgets/ShownText.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace asperity {

namespace {

constexpr double kJourney = 1.5;  // [s]

// To engage takes some two seconds: down to right above the sample, then slowly to the setpoint.
constexpr double kCoarse = 0.7;  // [s]
constexpr double kFine = 4.0;    // of an approach with its way back [s]

constexpr double kKeySpeed = 0.25;    // along the sample, of held keys [half widths/s]
constexpr double kLead = 0.06;        // of the mouse over a tip that a feedback slows down [s]
constexpr double kTurnSpeed = 1.0;    // of a device's axes: the force turns with them [rad/s]
constexpr double kKeySpeedUp = 0.05;  // and across it [half widths/s]

/// Raises where the base waits to where a ramp begins and ends, never lowers it.
Vector3 topOf(const Ramp& ramp, const Scene& scene, Vector3 waiting) {
    const double top = touchHeight(scene, waiting.x(), waiting.y()) + ramp.size;
    waiting.z() = std::max(waiting.z(), top);
    return waiting;
}

/// Where held keys send the device, world frame [half widths/s].
Vector3 keyVelocity(const KeyDirection& keys, const ViewCamera& camera) {
    const Vector3 forward = Vector3::UnitZ().cross(camera.right());
    return kKeySpeed * (keys.right * camera.right() + keys.forward * forward) +
           kKeySpeedUp * keys.up * Vector3::UnitZ();
}

}  // namespace

void ActiveDevice::attach(LiveRun& run) {
    run_ = &run;
    use(pointerDriver());
}

void ActiveDevice::use(const DeviceDriver& driver) {
    take(&driver, [this, &driver] {
        return driver.open({.hid = [this]() -> HidTransport& { return hid(); },
                            .data = dataFolder(),
                            .start = run_->devicePosition()});
    });
}

void ActiveDevice::take(const DeviceDriver* driver, const LiveRun::MakeDevice& make) {
    run_->takeDevice(make);
    device_ = &run_->device();
    driver_ = driver;
    approach_ = nullptr;
    feedback_ = nullptr;
    if (const PilotedDevice* const piloted = run_->device().piloted()) {
        pilot_ = DevicePilot(piloted->start());
    }
}

DevicePath ActiveDevice::leadIn(const Vector3& start) {
    DevicePath path = journey(run_->scene(), run_->basePosition(), start.head<2>(), kJourney);
    path.push_back({path.back().time + 0.1 * kJourney, start});
    return path;
}

double ActiveDevice::follow(const DevicePath& path) {
    double leadTime = 0.0;
    take(nullptr, [this, &path, &leadTime] {
        DevicePath way = leadIn(path.front().position);
        leadTime = way.back().time;
        const double begin = way.back().time - path.front().time;
        for (std::size_t i = 1; i < path.size(); ++i) {
            way.push_back({begin + path[i].time, path[i].position});
        }
        return std::make_unique<ScriptedDevice>(std::move(way), run_->settings().positionGain,
                                                run_->devicePosition());
    });
    return leadTime;
}

void ActiveDevice::approachBy(const MakeLeadIn& makeLeadIn, const ApproachPlan& plan) {
    const ApproachDevice* made = nullptr;
    take(nullptr, [&] {
        auto device = std::make_unique<ApproachDevice>(
            makeLeadIn(), plan, run_->settings().positionGain, run_->devicePosition());
        made = device.get();
        return device;
    });
    approach_ = made;
}

void ActiveDevice::followFromHere(const MakePath& makePath) {
    take(nullptr, [&] {
        return std::make_unique<ScriptedDevice>(
            makePath(run_->basePosition()), run_->settings().positionGain, run_->devicePosition());
    });
}

void ActiveDevice::hold(const HeldForce& force, const MakePath& makePath) {
    FeedbackDevice* made = nullptr;
    take(makePath ? nullptr : &pointerDriver(), [&] {
        const Vector3 base = run_->basePosition();
        const double gain = run_->settings().positionGain;
        std::unique_ptr<HapticDevice> lateral;
        if (makePath) {
            lateral =
                std::make_unique<ScriptedDevice>(makePath(base), gain, run_->devicePosition());
        } else {
            lateral = std::make_unique<PointerDevice>(run_->devicePosition());
        }
        auto device = std::make_unique<FeedbackDevice>(
            std::move(lateral), planFeedback(run_->scene(), base, force.setpoint, force.freeForce),
            base.z(), gain);
        device->hold(force.setpoint, force.gain);
        made = device.get();
        return device;
    });
    feedback_ = made;
}

void ActiveDevice::approach(const PlannedApproach& approach) {
    approachBy([&] { return leadIn(approach.start); }, approach.plan);
}

Ramp usualRamp(const Scene& scene, const Vector2& position, double setpoint) {
    const PlannedApproach planned =
        planApproach(scene, {.duration = kFine, .position = position, .setpoint = setpoint});
    const Vector3& start = planned.start;
    return {.rate = planned.plan.speed,
            .size = start.z() - touchHeight(scene, start.x(), start.y())};
}

void ActiveDevice::engage(double setpoint, const Vector2& position, const Ramp& ramp) {
    PlannedApproach planned = planApproach(
        run_->scene(), {.duration = kFine, .position = position, .setpoint = setpoint});
    planned.plan.dwell = std::numeric_limits<double>::infinity();
    planned.plan.axis = bendingAxis(run_->scene().belief.cantilever);
    planned.plan.speed = ramp.rate;
    const double usualTop = planned.start.z();
    planned.start = topOf(ramp, run_->scene(), planned.start);
    planned.plan.maxDescent += planned.start.z() - usualTop;
    const auto wayThere = [&]() -> DevicePath {
        const Vector3 base = run_->basePosition();
        if (base.head<2>() != position) {
            return leadIn(planned.start);
        }
        return {{0.0, base}, {kCoarse, {base.x(), base.y(), planned.start.z()}}};
    };
    approachBy(wayThere, planned.plan);
}

HidTransport& ActiveDevice::hid() {
    if (!transport_) {
        transport_.emplace();
    }
    return *transport_;
}

PilotedDevice* ActiveDevice::piloted() const {
    return isOurs() && run_->loop().running() ? run_->device().piloted() : nullptr;
}

bool ActiveDevice::isHardware() const {
    return run_ != nullptr && run_->device().piloted() == nullptr && !followsPath();
}

double ActiveDevice::reach() const {
    return driver() == &pointerDriver() ? 1.0 : 1.0 / run_->settings().positionGain;
}

void ActiveDevice::displace(const Vector3& displacement) {
    if (piloted() != nullptr) {
        pilot_.displace(reach() * displacement);
    }
}

double ActiveDevice::pilotedHeight() const {
    const ContactState& contact = run_->loop().snapshot().sample.output.model.contact;
    const double height = contact.branch == ContactBranch::Far ? -contact.indentation : 0.0;
    const Vector3 ahead = pilot_.target() - run_->devicePosition();
    return height + run_->settings().positionGain * ahead.z();
}

void ActiveDevice::lift(double notches, double fineStep) {
    if (piloted() == nullptr || !(fineStep > 0.0)) {
        return;
    }
    const double gain = run_->settings().positionGain;
    const double height = pilotedHeight();
    const double lifted = liftedHeight(height, notches, gain * reach() * fineStep);
    pilot_.displace((lifted - height) / gain * Vector3::UnitZ());
}

void ActiveDevice::setVelocity(const Vector3& velocity) {
    if (run_ != nullptr) {
        pilot_.setVelocity(reach() * velocity);
    }
}

void ActiveDevice::travelTo(const Vector2& position) {
    if (piloted() != nullptr) {
        pilot_.follow(journey(run_->scene(), run_->basePosition(), position, kJourney));
    }
}

void ActiveDevice::rise(const Ramp& ramp) {
    if (piloted() == nullptr) {
        return;
    }
    const Vector3 base = run_->basePosition();
    const Scene& scene = run_->scene();
    const Vector3 free = topOf(ramp, scene, waitingPosition(scene, base.head<2>()));
    pilot_.follow({{0.0, base}, {std::max(free.z() - base.z(), 0.0) / ramp.rate, free}});
}

void ActiveDevice::advance(double seconds, double halfWidth) {
    if (PilotedDevice* const device = piloted()) {
        const DeviceMapping now{.device = run_->devicePosition(),
                                .base = run_->basePosition(),
                                .positionGain = run_->settings().positionGain};
        pilot_.advance(seconds, now);
        if (const FeedbackDevice* const held = feedback()) {
            pilot_.keepNear(now.device, kLead * held->maxSpeed());
        }
        device->moveTo(pilot_.target());
    }
    if (run_ != nullptr) {
        run_->device().setSeenHalfWidth(halfWidth);
    }
}

DeviceControl::DeviceControl(Stage& stage) : Feature(stage), keys_(new HeldKeys(&live_.view())) {
    stage.onFrame(FrameStep::Move, [this](double elapsed) { advance(elapsed); });
    const auto drivers = deviceDrivers();
    list_.assign(drivers.begin(), drivers.end());
    list_.insert(list_.begin() + 1, nullptr);
    QStringList names;
    for (const DeviceDriver* const driver : list_) {
        names << (driver != nullptr ? tr(driver->label) : tr("Scripted path"));
    }
    ControlBar& controls = live_.controls();
    controls.setDevices(names);
    connect(&controls, &ControlBar::deviceChosen, this, &DeviceControl::choose);
    connect(&controls, &ControlBar::knobTurned, this, &DeviceControl::turnKnob);
    connect(&live_.view(), &ZoomView::tipDragged, this, [this](double dx, double dy) {
        if (runs_.tipRefusal().isEmpty()) {
            device_.displace({dx, dy, 0.0});
        }
    });
    connect(&live_.view(), &ZoomView::lifted, this, &DeviceControl::lift);
    connect(&live_.overview(), &OverviewPanel::positionChosen, this, [this](double x, double y) {
        travelTo({x, y});
    });
    addEntries();
    connect(&runs_, &RunControl::begun, this, &DeviceControl::attach);
    connect(&runs_, &RunControl::rebuilt, this, &DeviceControl::takeUp);
    connect(&runs_, &RunControl::ending, this, &DeviceControl::detach);
}

void DeviceControl::addEntries() {
    Menus& menus = host_.menus();
    followsView_ = &menus.add(
        {MenuName::Device, 0, 30}, "followsView",
        {.text = tr("Device follows the &view"),
         .tip = tr("Right, back and up on the device are right, back and up on the screen"),
         .isCheckable = true,
         .refusal = [this] {
             return runs_.run() != nullptr && hasHardware()
                        ? QString()
                        : tr("Mouse and keyboard follow the view already; for other devices only");
         }});
    addGuides();
    const QAction& calibrate = menus.add(
        {MenuName::Device, 1, 10}, "calibrate",
        {.text = tr("C&alibrate (handle in its rest pose)"),
         .tip = tr("Set the zero of the device's angles"),
         .refusal = [this] {
             LiveRun* const run = runs_.run();
             return run != nullptr && run->device().specification().calibrates
                        ? QString()
                        : tr("This device needs no calibration: it has no encoders to zero");
         }});
    connect(&calibrate, &QAction::triggered, this, [this] {
        if (runs_.run() != nullptr) {
            runs_.run()->device().calibrate();
        }
    });
}

void DeviceControl::addGuides() {
    Menus& menus = host_.menus();
    QMenu& menu = menus.addMenu({MenuName::Device, 0, 40}, "guides", tr("&Guide"));
    auto* group = new QActionGroup(&menu);
    const auto add = [&](FixtureKind kind, const char* name, const QString& text) {
        QAction* entry = group->addAction(text);
        entry->setObjectName(QString::fromLatin1(name));
        entry->setCheckable(true);
        entry->setToolTip(kind == FixtureKind::None ? tr("No guide: the device moves freely")
                                                    : tr("Guide the device to this position"));
        menu.addAction(entry);
        guides_[kind] = entry;
        connect(entry, &QAction::triggered, this, [this, kind] { chooseGuide(kind); });
        if (kind != FixtureKind::None) {
            menus.refuseBy(*entry, [this] { return guideRefusal(); });
        }
    };
    add(FixtureKind::None, "guideNone", tr("&None"));
    add(FixtureKind::Point, "guidePoint", tr("&Point at the tip"));
    add(FixtureKind::Line, "guideLine", tr("Vertical &line through the tip"));
    add(FixtureKind::Plane, "guidePlane", tr("&Horizontal plane through the tip"));
    const auto show = [this](FixtureKind kind) { guides_.at(kind)->setChecked(true); };
    show(FixtureKind::None);
    connect(&runs_, &RunControl::knobsShown, this,
            [this, show] { show(runs_.run()->settings().guide.kind); });
}

QString DeviceControl::guideRefusal() const {
    if (!runs_.fixedBy().isEmpty()) {
        return runs_.fixedBy();
    }
    const LiveRun* const run = runs_.run();
    return run != nullptr && run->settings().coupling.couples()
               ? QString()
               : tr("A guide needs a coupling: a force-feedback device's or the scene's");
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
        if (driver == device_.driver() && device_.feedback() != nullptr) {
            return;  // it has the tip already, and the force is held
        }
        use(*driver);
    } else {
        Q_EMIT pathWanted();
        show();  // the device stays until a path starts
    }
}

void DeviceControl::use(const DeviceDriver& driver) {
    try {
        device_.use(driver);
        tell();
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
    }
    show();
}

double DeviceControl::follow(const DevicePath& path) {
    const double leadTime = device_.follow(path);
    show();
    return leadTime;
}

void DeviceControl::approach(const PlannedApproach& approach) {
    device_.approach(approach);
    show();
}

void DeviceControl::engage(double setpoint, const Vector2& position, const Ramp& ramp) {
    device_.engage(setpoint, position, ramp);
    show();
}

void DeviceControl::hold(const HeldForce& force) {
    device_.hold(force);
    show();
}

void DeviceControl::hold(const HeldForce& force, const ActiveDevice::MakePath& makePath) {
    device_.hold(force, makePath);
    show();
}

void DeviceControl::followFromHere(const ActiveDevice::MakePath& makePath) {
    device_.followFromHere(makePath);
    show();
}

void DeviceControl::withdraw(const Ramp& ramp) {
    release();
    const Scene& scene = runs_.run()->scene();
    const Vector3 base = runs_.run()->basePosition();
    if (base.z() >= topOf(ramp, scene, waitingPosition(scene, base.head<2>())).z()) {
        return;
    }
    if (device_.driver() != &pointerDriver()) {
        use(pointerDriver());
    }
    device_.rise(ramp);
}

void DeviceControl::release() {
    if (device_.followsPath() || device_.feedback() != nullptr) {
        use(pointerDriver());
    }
}

void DeviceControl::lift(double notches) {
    if (runs_.run() == nullptr || !runs_.tipRefusal().isEmpty()) {
        return;
    }
    if (device_.feedback() != nullptr && !device_.followsPath()) {
        Q_EMIT heightWanted();
    }
    const Scene& scene = runs_.run()->scene();
    device_.lift(notches, fineLiftStep(live_.view().halfWidth(), scene.description.setpoint,
                                       scene.belief.cantilever.stiffness()));
}

void DeviceControl::pilotDevice(const DevicePath& path) {
    device_.use(simulatedDriver());
    device_.pilotAlong(path);
    show();
}

void DeviceControl::travelTo(const Vector2& position) {
    if (runs_.run() == nullptr) {
        return;
    }
    if (const QString& why = runs_.editRefusal(); !why.isEmpty()) {
        host_.tell(why);
        return;
    }
    if (device_.driver() != &pointerDriver() || device_.feedback() != nullptr) {
        device_.use(pointerDriver());
        show();
    }
    device_.travelTo(position);
}

void DeviceControl::turnKnob(const QString& column, double value) {
    // A number that was being typed into the knob when it was disabled.
    if (column == QLatin1String("position_gain") && !gainRefusal().isEmpty()) {
        live_.controls().setKnobs(runs_.run()->settings());
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
    const double halfWidth = live_.view().halfWidth();
    const Vector3 keys = keyVelocity(keys_->direction(), live_.view().camera());
    if (keys.z() != 0.0 && device_.feedback() != nullptr && !device_.followsPath() &&
        runs_.tipRefusal().isEmpty()) {
        Q_EMIT heightWanted();
    }
    device_.setVelocity(runs_.tipRefusal().isEmpty() ? Vector3(halfWidth * keys)
                                                     : Vector3(Vector3::Zero()));
    device_.advance(seconds, halfWidth);
    turnAxes(seconds);
    const std::string words = wordsOf(runs_.run()->device().status());
    if (words != std::exchange(told_, words) && !words.empty()) {
        host_.tell(coreWords(words));
    }
    followDelay();
}

void DeviceControl::turnAxes(double seconds) {
    const bool turns = followsView_->isChecked() && device_.isHardware();
    const ViewCamera& camera = live_.view().camera();
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
        host_.complain(tr("Forces are off: %1").arg(coreWords(refusalOf(coupled))));
    }
}

QString DeviceControl::gainRefusal() const {
    if (device_.followsPath()) {
        return tr("A path gives positions on the scan: the position gain has no effect");
    }
    return device_.feedback() != nullptr
               ? tr("The feedback holds the force at the gain with which it began")
               : QString();
}

void DeviceControl::show() {
    runs_.setDriver(device_.driver());
    const bool isListed = device_.driver() != nullptr || device_.followsPath();
    const auto found = std::find(list_.begin(), list_.end(), device_.driver());
    live_.controls().setDevice(isListed ? static_cast<int>(found - list_.begin()) : -1);
    runs_.setEmergencyStop(runs_.run()->device().specification().rendersForce());
    live_.controls().refuseKnob("position_gain", gainRefusal());
    runs_.showKnobs();
}

/// Tells the scale of a device with motors, and what is felt, in words that fit the bottom line.
void DeviceControl::tell() {
    if (const CoupledDevice* const coupled = runs_.run()->coupling().coupled()) {
        const Settings& settings = runs_.run()->settings();
        host_.tell(
            coreWords(feltWords({settings.positionGain, settings.forceGain}, coupled->judgment)));
    }
}

}  // namespace asperity
