// Which hand a session gives the tip, and what its knobs may be.

#include "app/recording/RecordedRun.h"
#include "app/session/PathChecks.h"
#include "app/session/Session.h"
#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/haptics/mapping/WorkspaceMapping.h"
#include "core/io/scene/HandPathFile.h"
#include "core/scene/BelievedModel.h"
#include "core/scene/SettingFields.h"
#include "ui/HeldKeys.h"
#include "ui/panels/ControlBar.h"
#include "ui/panels/OverviewPanel.h"
#include "ui/view/ZoomView.h"
#include "ui/window/MainWindow.h"
#include "ui/window/WindowMenus.h"

#include <QAction>

#include <array>
#include <utility>

namespace asperity {

namespace {

constexpr double kKeySpeed = 0.25;    // along the sample, of held keys [half widths/s]
constexpr double kTurnSpeed = 1.0;    // of a device's axes: the force turns with them [rad/s]
constexpr double kKeySpeedUp = 0.05;  // and across it [half widths/s]

using PlanPath = HandPath (*)(const Scene&, const PathPlan&);
constexpr std::array<PlanPath, 3> kPaths{approachPath, rasterPath, scratchPath};

/// Where held keys send the hand, world frame [half widths/s].
Vector3 keyVelocity(const KeyDirection& keys, const ViewCamera& camera) {
    const Vector3 forward = Vector3::UnitZ().cross(camera.right());
    return kKeySpeed * (keys.right * camera.right() + keys.forward * forward) +
           kKeySpeedUp * keys.up * Vector3::UnitZ();
}

}  // namespace

void Session::connectViews() {
    connect(&window_.view(), &ZoomView::tipDragged, this, [this](double dx, double dy, double dz) {
        hand_.displace({dx, dy, dz});
    });
    connect(&window_.overview(), &OverviewPanel::placeChosen, this, [this](double x, double y) {
        travelTo({x, y});
    });
}

void Session::connectHandMenu() {
    WindowMenus& menus = window_.menus();
    connect(menus.tipControl, &QAction::triggered, this, [this](bool tip) {
        changeSettings([tip](Settings& settings) {
            settings.positionControl = tip ? PositionControl::Tip : PositionControl::Base;
        });
    });
    connect(menus.clutch, &QAction::triggered, this, [this](bool clutched) {
        changeSettings([clutched](Settings& settings) { settings.clutched = clutched; });
    });
    connect(menus.calibrate, &QAction::triggered, this, [this] {
        if (run_) {
            run_->hand().calibrate();
        }
    });
    connect(&menus, &WindowMenus::guideChosen, this, &Session::chooseGuide);
}

void Session::chooseGuide(FixtureKind kind) {
    if (!run_) {
        return;
    }
    const TickSample sample = run_->loop().snapshot().sample;
    changeSettings([&](Settings& settings) {
        settings.guide = run_->scene().description.settings.guide;
        settings.guide.kind = kind;
        settings.guide.axis = Vector3::UnitZ();
        settings.guide.point = settings.positionControl == PositionControl::Tip
                                   ? sample.output.model.tip
                                   : sample.output.base.position;
    });
    showHand();
    if (kind != FixtureKind::None && !run_->settings().coupling.couples()) {
        window_.tell(tr("A guide pulls at a hand with a coupling: take a device with motors, or "
                        "give the scene a coupling"));
    }
}

void Session::turnHand(double seconds) {
    const bool turns = window_.menus().followsView->isChecked() && hand_.isDevice();
    const ViewCamera& camera = window_.view().camera();
    const auto axes = turns ? viewAxes(camera.right(), camera.up()) : std::nullopt;
    const Vector3 wanted = axes ? turnOf(*axes) : Vector3(Vector3::Zero());
    const Vector3 turn = turnedTowards(run_->settings().handTurn, wanted, kTurnSpeed * seconds);
    if (turn != run_->settings().handTurn) {
        changeSettings([&turn](Settings& settings) { settings.handTurn = turn; });
    }
}

void Session::turnKnob(const QString& column, double value) {
    if (column == QLatin1String("position_gain") && hand_.kind() == HandKind::Script) {
        window_.controls().setKnobs(run_->settings());
        window_.tell(tr("A path is in places of the scan: the position gain waits for a hand"));
        return;
    }
    changeSettings([&](Settings& settings) { setSetting(settings, column.toStdString(), value); });
}

void Session::chooseHand(int index) {
    if (!run_) {
        return;
    }
    if (index == static_cast<int>(HandKind::Script)) {
        choosePath(0);
        return;
    }
    try {
        hand_.use(static_cast<HandKind>(index));
        tellOfHand();
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
    showHand();
}

void Session::showHand() {
    const Settings& settings = run_->settings();
    ControlBar& controls = window_.controls();
    controls.setHand(static_cast<int>(hand_.kind()));
    controls.setForcesOn(settings.forcesOn);
    controls.setKnobs(settings);
    WindowMenus& menus = window_.menus();
    menus.tipControl->setChecked(settings.positionControl == PositionControl::Tip);
    menus.clutch->setChecked(settings.clutched);
    menus.setGuide(settings.guide.kind);
}

/// Of one with motors: its scale, and what is felt; so short that the bottom line has room for it.
void Session::tellOfHand() {
    if (const CoupledHand* const hand = run_->coupling().hand()) {
        const Settings& settings = run_->settings();
        window_.tell(tr("%1; the hand feels %2 of %3")
                         .arg(QString::fromStdString(
                                  scaleWords({settings.positionGain, settings.forceGain})),
                              QString::fromStdString(formatSi(hand->judgement.felt, "N/m")),
                              QString::fromStdString(formatSi(hand->judgement.contact, "N/m"))));
    }
}

void Session::followDelay() {
    if (!run_->followDelay()) {
        return;
    }
    showHand();
    const CoupledHand& hand = *run_->coupling().hand();
    if (hand.holds()) {
        tellOfHand();
    } else {
        window_.complain(tr("Forces are off: %1").arg(QString::fromStdString(hand.refusal)));
    }
}

void Session::requireHolding(const SceneDescription& scene) const {
    if (run_->coupling().hand() != nullptr) {
        run_->coupling().requireHolding(believedSystem(scene, usualModel(scene)), run_->settings());
    }
}

Session::LedDevice Session::ledDevice() const {
    return {.kind = run_->coupling().hand() != nullptr ? hand_.kind() : HandKind::Other,
            .scale = {run_->settings().positionGain, run_->settings().forceGain}};
}

void Session::takeUp(const LedDevice& device) {
    if (device.kind == HandKind::Other) {
        return;
    }
    chooseHand(static_cast<int>(device.kind));
    if (hand_.kind() == device.kind) {
        changeSettings([&device](Settings& settings) {
            settings.positionGain = device.scale.positionGain;
            settings.forceGain = device.scale.forceGain;
        });
        tellOfHand();
    }
}

void Session::choosePath(int index) {
    if (run_) {
        const Vector2 here = run_->basePosition().head<2>();
        window_.controls().setPath(index);
        follow(kPaths.at(static_cast<std::size_t>(index))(run_->scene(), {.place = here}));
    }
}

/// @return whether the hand follows it
bool Session::followFile(const QString& file, const ReadPath& read) {
    if (!run_) {
        return false;
    }
    try {
        const HandPath path = read(file.toStdString());
        requireNear(run_->scene(), path, file.toStdString());
        window_.controls().setPath(-1);
        follow(path);
        return true;
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
        return false;
    }
}

void Session::repeatRecording(const std::filesystem::path& forceLog) {
    const auto read = [](const std::filesystem::path& file) {
        return readRecordedPath(readRunTable(file));
    };
    if (followFile(QString::fromStdString(forceLog.string()), read)) {
        const std::string cutOff = sentenceOf(stateOf(forceLog.parent_path()));
        if (!cutOff.empty()) {
            window_.tell(QString::fromStdString(cutOff));
        }
    }
}

void Session::follow(const HandPath& path) {
    hand_.follow(path);
    showHand();
    window_.overview().showPath(outline(path));
}

void Session::leadDevice(const HandPath& path) {
    hand_.use(HandKind::SimulatedDevice);
    hand_.leadAlong(path);
    showHand();
}

void Session::travelTo(const Vector2& place) {
    if (!run_) {
        return;
    }
    if (hand_.kind() != HandKind::Pointer) {
        hand_.usePointer();
        showHand();
    }
    hand_.travelTo(place);
}

void Session::moveHand(double seconds) {
    const double halfWidth = window_.view().halfWidth();
    hand_.setVelocity(halfWidth * keyVelocity(keys_->direction(), window_.view().camera()));
    hand_.advance(seconds, halfWidth);
    turnHand(seconds);
    const std::string status = hand_.deviceStatus();
    if (status != std::exchange(deviceStatus_, status) && !status.empty()) {
        window_.tell(QString::fromStdString(status));
    }
}

}  // namespace asperity
