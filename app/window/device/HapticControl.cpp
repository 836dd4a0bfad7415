#include "app/window/device/HapticControl.h"

#include "core/Error.h"
#include "core/scene/SettingFields.h"
#include "core/words/DeviceWords.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QCheckBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>

namespace asperity {

namespace {

constexpr int kKnobGap = 6;       ///< [px]
constexpr int kGainWidth = 96;    ///< of a number, at least [px]
constexpr double kLowest = 1e-9;  ///< of a gain, in its unit
constexpr double kHighest = 1e12;
constexpr int kKnobDecimals = 12;

QString aboutOf(SettingGroup group) {
    switch (group) {
    case SettingGroup::Gains:
        return HapticPanel::tr("Scale between device and tip");
    case SettingGroup::Coupling:
        return HapticPanel::tr("Spring and dampers between device and tip");
    case SettingGroup::Governor:
        return HapticPanel::tr("What the force on the operator is held to");
    case SettingGroup::Clutch:
        return HapticPanel::tr("What the device moves");
    case SettingGroup::Guide:
        return HapticPanel::tr("A virtual fixture that helps to hold a target");
    case SettingGroup::Hidden:
        break;
    }
    return {};
}

/// Why the force is not what is wanted.
QString stateText(const TickOutput& output) {
    if (output.fault != Fault::None) {
        return coreWords(nameOf(output.fault));
    }
    const QString words = coreWords(nameOf(output.forceState));
    return words.isEmpty() ? HapticPanel::tr("not limited") : words;
}

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

HapticPanel::HapticPanel(QWidget* parent) : QWidget(parent), rate_(new NumberBox(this)) {
    column_ = new QVBoxLayout(this);
    column_->setContentsMargins(kKnobGap, kKnobGap, kKnobGap, kKnobGap);
    column_->setSpacing(kKnobGap);
    addReadings();
    addSettings();
    column_->addStretch();
    setToolTip(tr("Gains, coupling and limits of the force, and how the loop keeps its time"));
    showEnergy(std::nullopt);
    showDevice(tr("none yet"), false);
}

Section& HapticPanel::addSection(const QString& title, const QString& about) {
    auto* section = new Section(title, about, this);
    column_->addWidget(section);
    return *section;
}

Section& HapticPanel::sectionOf(SettingGroup group) {
    Section*& section = sections_[group];
    if (section == nullptr) {
        section = &addSection(coreWords(nameOf(group)), aboutOf(group));
    }
    return *section;
}

void HapticPanel::addReadings() {
    Section& device = addSection(tr("Device and force"), tr("Device, and the force on it now"));
    device_ = addReading(device, "hapticDevice", tr("Device"),
                         tr("Scale and stiffness of the device that moves the tip"));
    device_->setWordWrap(true);
    force_ = addReading(device, "hapticForce", tr("Force / limit"),
                        tr("Force on the operator, and the most there can be [N]"));
    state_ = addReading(device, "hapticState", tr("Limited by"),
                        tr("Why the force on the operator is less than the sample's"));
    state_->setWordWrap(true);
    energySection_ = &addSection(tr("Energy"), tr("At the port between operator and coupling"));
    energy_ = addReading(*energySection_, "hapticEnergy", tr("Dissipated"),
                         tr("Energy that the coupling took, less a leak of half a second; below 0 "
                            "the coupling gave energy [J]"));
    spring_ = addReading(*energySection_, "hapticSpring", tr("In the spring"),
                         tr("Energy stored in the coupling's spring [J]"));
    Section& loop = addSection(tr("Loop"), tr("The real-time loop"));
    rate_->setObjectName(QStringLiteral("haptics.rate_hz"));
    rate_->setRange(kMinTickRate, kMaxTickRate);
    rate_->setDecimals(3);
    rate_->setToolTip(tr("Ticks per second, %1 to %2; another rate is another run")
                          .arg(kMinTickRate)
                          .arg(kMaxTickRate));
    guardFromWheel(*rate_);
    connect(rate_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            &HapticPanel::rateEntered);
    const int row = loop.rows().rowCount();
    auto* caption = captionLabel(tr("Rate [Hz]"), this);
    caption->setToolTip(rate_->toolTip());
    loop.rows().addWidget(caption, row, 0);
    loop.rows().addWidget(rate_, row, 1);
    tick_ = addReading(loop, "hapticTick", tr("Tick p50 / p99"),
                       tr("Time from the device's position to its force, of the last second"));
    late_ = addReading(loop, "hapticLate", tr("Late p50 / p99"),
                       tr("Begin of a tick after its due time, of the last second"));
    missed_ = addReading(loop, "hapticMissed", tr("Overruns"),
                         tr("Due times that were missed and skipped since the loop began"));
}

QLabel* HapticPanel::addReading(Section& section, const char* name, const QString& caption,
                                const QString& toolTip) {
    auto* words = captionLabel(caption, this);
    auto* value = new QLabel(QStringLiteral("–"), this);
    value->setObjectName(QString::fromUtf8(name));
    value->setTextFormat(Qt::PlainText);
    words->setToolTip(toolTip);
    value->setToolTip(toolTip);
    const int row = section.rows().rowCount();
    section.rows().addWidget(words, row, 0);
    section.rows().addWidget(value, row, 1);
    return value;
}

void HapticPanel::addSettings() {
    const Settings any;
    for (const SettingGroup group : kValues<SettingGroup>) {
        listSettings(any, [&](const SettingField& field, const auto& value) {
            using Value = std::decay_t<decltype(value)>;
            if constexpr (!std::is_same_v<Value, std::uint32_t>) {
                if (group != SettingGroup::Hidden && field.words.group == group) {
                    addRow(sectionOf(group), field, newControl(field, value));
                }
            }
        });
    }
}

void HapticPanel::addRow(Section& section, const SettingField& field, QWidget* control) {
    const QString unit = QString::fromUtf8(field.words.unit);
    const QString caption = coreWords(field.words.caption);
    auto* words =
        captionLabel(unit.isEmpty() ? caption : QStringLiteral("%1 [%2]").arg(caption, unit), this);
    control->setObjectName(QStringLiteral("haptics.") + QString::fromUtf8(field.column));
    control->setToolTip(coreWords(field.words.toolTip));
    words->setToolTip(control->toolTip());
    const int row = section.rows().rowCount();
    section.rows().addWidget(words, row, 0);
    section.rows().addWidget(control, row, 1);
}

QWidget* HapticPanel::newControl(const SettingField& field, double /*value*/) {
    const double unit = field.words.scale;
    const double low = std::max(field.limits.low / unit, -kHighest);
    const double high = std::min(field.limits.high / unit, kHighest);
    NumberBox* box = nullptr;
    if (field.limits.low > 0.0) {
        box = new GainSpinBox(std::max(low, kLowest), high, this);
    } else {
        box = new NumberBox(this);
        box->setDecimals(kKnobDecimals);
        box->setRange(low, high);
        box->setStepType(QAbstractSpinBox::AdaptiveDecimalStepType);
    }
    box->setMinimumWidth(theme::scaled(kGainWidth));
    guardFromWheel(*box);
    const QString column = QString::fromUtf8(field.column);
    connect(box, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this, column, unit](double number) { Q_EMIT settingTurned(column, number * unit); });
    show_[field.column] = [box, unit](double value) {
        const QSignalBlocker blocker(box);
        const double number = std::clamp(value / unit, -kHighest, kHighest);
        box->setRange(std::min(box->minimum(), number), std::max(box->maximum(), number));
        box->setValue(number);
    };
    return box;
}

/// A button of the device, or none.
QWidget* HapticPanel::newControl(const SettingField& field, int /*value*/) {
    QStringList names{tr("none")};
    for (int button = 0; button <= kLastButton; ++button) {
        names << tr("button %1").arg(button);
    }
    auto* box = new ChoiceBox(this);
    box->setNames(names);
    guardFromWheel(*box);
    const QString column = QString::fromUtf8(field.column);
    connect(box, qOverload<int>(&QComboBox::activated), this,
            [this, column](int index) { Q_EMIT settingTurned(column, index + kNoButton); });
    show_[field.column] = [box](double value) {
        box->setCurrentIndex(static_cast<int>(value) - kNoButton);
    };
    return box;
}

QWidget* HapticPanel::newControl(const SettingField& field, bool /*value*/) {
    auto* box = new QCheckBox(this);
    const QString column = QString::fromUtf8(field.column);
    connect(box, &QCheckBox::clicked, this,
            [this, column](bool on) { Q_EMIT settingTurned(column, on ? 1.0 : 0.0); });
    show_[field.column] = [box](double value) { box->setChecked(value != 0.0); };
    return box;
}

template <HasEnumTable Value>
QWidget* HapticPanel::newControl(const SettingField& field, Value /*value*/) {
    QStringList names;
    std::vector<double> values;
    for (const auto& row : kEnumTable<Value>) {
        names << coreWords(row.name);
        values.push_back(static_cast<double>(row.value));
    }
    auto* box = new ChoiceBox(this);
    box->setNames(names);
    guardFromWheel(*box);
    const QString column = QString::fromUtf8(field.column);
    connect(box, qOverload<int>(&QComboBox::activated), this, [this, column, values](int index) {
        Q_EMIT settingTurned(column, values.at(static_cast<std::size_t>(index)));
    });
    show_[field.column] = [box, values](double value) {
        box->setCurrentIndex(static_cast<int>(std::ranges::find(values, value) - values.begin()));
    };
    return box;
}

void HapticPanel::showSettings(const Settings& settings) {
    listSettings(settings, [this](const SettingField& field, const auto& value) {
        if (const auto show = show_.find(field.column); show != show_.end()) {
            show->second(static_cast<double>(value));
        }
    });
}

void HapticPanel::showRate(double rate) {
    const QSignalBlocker blocker(rate_);
    rate_->setValue(rate);
}

void HapticPanel::showDevice(const QString& words, bool rendersForce) {
    device_->setText(words);
    sectionOf(SettingGroup::Governor)
        .refuse(rendersForce ? QString()
                             : tr("For a force-feedback device only: this one has no motors"));
}

void HapticPanel::refuseGuide(const QString& reason) {
    sectionOf(SettingGroup::Guide).refuse(reason);
}

void HapticPanel::showTick(const TickOutput& output, double limit) {
    const QString force = siText(output.deviceForce.norm(), "N");
    force_->setText(limit > 0.0 ? QStringLiteral("%1 / %2").arg(force, siText(limit, "N"))
                                : tr("none: the device only senses"));
    state_->setText(stateText(output));
}

void HapticPanel::showLoop(const LoopStatistics& statistics) {
    const auto pair = [](const LatencyQuantiles& times) {
        return QStringLiteral("%1 / %2").arg(siText(times.median, "s"), siText(times.p99, "s"));
    };
    tick_->setText(pair(statistics.tickTime));
    late_->setText(pair(statistics.lateness));
    missed_->setText(QString::number(statistics.overruns));
}

void HapticPanel::showEnergy(const std::optional<PortEnergy>& energy) {
    energySection_->refuse(energy ? QString()
                                  : tr("Watched for a force-feedback device with a coupling only"));
    if (!energy) {
        energy_->setText(QStringLiteral("–"));
        spring_->setText(QStringLiteral("–"));
        return;
    }
    const QString joules = siText(std::abs(energy->dissipated), "J");
    if (energy->dissipated < 0.0) {
        energy_->setText(energy->warned ? tr("none; the coupling supplied %1").arg(joules)
                                        : tr("none; %1 supplied").arg(joules));
    } else {
        energy_->setText(energy->warned ? tr("%1: the coupling supplies energy").arg(joules)
                                        : joules);
    }
    spring_->setText(siText(energy->spring, "J"));
}

HapticControl::HapticControl(Stage& stage)
    : Feature(stage), panel_(new HapticPanel(&host_.widget())) {
    stage.onFrame(FrameStep::Show, [this](double /*elapsed*/) { show(); });
    host_.addSidePage(panel_, tr("Haptics"));
    HapticPanel& panel = *panel_;
    connect(&panel, &HapticPanel::settingTurned, this, &HapticControl::turn);
    connect(&panel, &HapticPanel::rateEntered, this, &HapticControl::setRate);
    connect(&runs_, &RunControl::begun, this, [this] {
        frame_ = 0;
        showRate();
        panel_->showSettings(runs_.run()->settings());
        shown_ = runs_.run()->settings();
    });
    connect(&edits_, &SceneEdits::changed, this, &HapticControl::showRate);
}

void HapticControl::turn(const QString& column, double value) {
    if (runs_.run() == nullptr) {
        return;
    }
    try {
        const Settings turned = withSetting(runs_.run()->settings(), column.toStdString(), value);
        runs_.turn([&turned](Settings& settings) { settings = turned; });
    } catch (const Error& error) {
        host_.complain(QString::fromUtf8(error.what()));
    }
    panel_->showSettings(runs_.run()->settings());
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
        panel_->showRate(scene->tickRate);
    }
}

void HapticControl::showDevice(LiveRun& run) {
    const CoupledDevice* const coupled = run.coupling().coupled();
    const Settings& settings = run.settings();
    panel_->showDevice(
        coupled != nullptr
            ? coreWords(feltWords({settings.positionGain, settings.forceGain}, coupled->judgment))
            : tr("without force feedback"),
        coupled != nullptr);
    panel_->refuseGuide(
        run.settings().coupling.couples()
            ? QString()
            : tr("A guide needs a coupling: a force-feedback device's or the scene's"));
}

/// Knobs are turned elsewhere, too: by the bar, a menu, a device that takes over.
void HapticControl::show() {
    LiveRun& run = *runs_.run();
    HapticPanel& panel = *panel_;
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
