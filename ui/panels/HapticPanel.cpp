#include "ui/panels/HapticPanel.h"

#include "ui/CoreWords.h"
#include "ui/NumberText.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/ChoiceBox.h"
#include "ui/panels/GainSpinBox.h"
#include "ui/panels/Section.h"
#include "ui/panels/WheelGuard.h"

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
                         tr("Energy that the coupling's spring holds [J]"));
    Section& loop = addSection(tr("Loop"), tr("The real-time loop"));
    rate_->setObjectName(QStringLiteral("haptics.rate_hz"));
    rate_->setRange(100.0, 20000.0);
    rate_->setDecimals(3);
    rate_->setToolTip(tr("Ticks per second, 100 to 20000; another rate is another run"));
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
    const QString joules = siText(energy->dissipated, "J");
    energy_->setText(energy->warned ? tr("%1: the coupling gives energy").arg(joules) : joules);
    spring_->setText(siText(energy->spring, "J"));
}

}  // namespace asperity
