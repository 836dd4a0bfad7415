#include "app/session/HapticControl.h"

#include "core/Error.h"
#include "core/scene/SettingFields.h"
#include "core/words/ScaleWords.h"
#include "ui/CoreWords.h"
#include "ui/panels/HapticPanel.h"
#include "ui/window/MainWindow.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr int kFramesPerReading = 10;  ///< as often as the eye reads numbers

/// The knobs with one turned. @throw Error where no scene may have them
Settings withSetting(Settings settings, const std::string& column, double value) {
    setSetting(settings, column, value);
    if (column.starts_with("guide_axis") && settings.guide.axis.norm() > 0.0) {
        settings.guide.axis.normalize();
    }
    checkSettings(settings);
    return settings;
}

}  // namespace

HapticControl::HapticControl(MainWindow& window, RunControl& runs, SceneEdits& edits)
    : window_(window), runs_(runs), edits_(edits) {
    HapticPanel& panel = window.hapticPanel();
    connect(&panel, &HapticPanel::settingTurned, this, &HapticControl::turn);
    connect(&panel, &HapticPanel::rateEntered, this, &HapticControl::setRate);
    connect(&runs, &RunControl::begun, this, [this] {
        frame_ = 0;
        showRate();
        window_.hapticPanel().showSettings(runs_.run()->settings());
        shown_ = runs_.run()->settings();
    });
    connect(&edits, &SceneEdits::changed, this, &HapticControl::showRate);
}

void HapticControl::turn(const QString& column, double value) {
    if (runs_.run() == nullptr) {
        return;
    }
    try {
        const Settings turned = withSetting(runs_.run()->settings(), column.toStdString(), value);
        runs_.turn([&turned](Settings& settings) { settings = turned; });
    } catch (const Error& error) {
        window_.complain(QString::fromUtf8(error.what()));
    }
    window_.hapticPanel().showSettings(runs_.run()->settings());
}

void HapticControl::setRate(double rate) {
    if (const SceneDescription* const now = edits_.wanted()) {
        SceneDescription next = *now;
        next.tickRate = rate;
        edits_.change(tr("Rate: %1 Hz").arg(rate), next, QStringLiteral("haptics.rate_hz"));
    }
}

void HapticControl::showRate() {
    if (const SceneDescription* const scene = edits_.wanted()) {
        window_.hapticPanel().showRate(scene->tickRate);
    }
}

void HapticControl::showDevice(LiveRun& run) {
    const CoupledDevice* const coupled = run.coupling().coupled();
    const Settings& settings = run.settings();
    window_.hapticPanel().showDevice(
        coupled != nullptr
            ? coreWords(feltWords({settings.positionGain, settings.forceGain}, coupled->judgment))
            : tr("without force feedback"),
        coupled != nullptr);
    window_.hapticPanel().refuseGuide(
        run.settings().coupling.couples()
            ? QString()
            : tr("A guide needs a coupling: a force-feedback device's or the scene's"));
}

/// Knobs are turned elsewhere, too: by the bar, a menu, a device that takes over.
void HapticControl::show() {
    LiveRun& run = *runs_.run();
    HapticPanel& panel = window_.hapticPanel();
    if (!panel.isVisible()) {
        return;
    }
    if (run.settings() != shown_) {
        shown_ = run.settings();
        panel.showSettings(shown_);
    }
    if (frame_++ % kFramesPerReading != 0) {
        return;
    }
    showDevice(run);
    const Snapshot& latest = runs_.shown();
    const double most = run.device().specification().maxForce;
    panel.showTick(latest.sample.output,
                   most > 0.0 ? std::min(most, run.settings().governor.maxForce) : 0.0);
    panel.showLoop(latest.statistics);
    const PassivityObserver* const observer = run.energy().observer();
    panel.showEnergy(observer == nullptr
                         ? std::nullopt
                         : std::optional(PortEnergy{.dissipated = observer->energy(),
                                                    .spring = observer->spring(),
                                                    .warned = observer->active()}));
}

}  // namespace asperity
