#include "app/window/live/EngageBar.h"

#include "core/scene/SceneDescription.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/FlowLayout.h"
#include "ui/widgets/NumberBox.h"
#include "ui/widgets/Theme.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>
#include <QStandardItemModel>

#include <algorithm>

namespace asperity {

namespace {

constexpr int kEngageHeight = 26;   // [px, as theme::scaled() takes them]
constexpr int kSetpointWidth = 76;  // same
constexpr int kRampWidth = 66;      // same
constexpr double kNanoRamp = 1e9;   // ramps are shown in nanometers
constexpr double kMinRamp = 0.1;    // [nm/s], [nm]
constexpr double kMaxRate = 1e6;    // [nm/s]
constexpr double kMaxSize = 2e4;    // [nm], more than the z range of an AFM
constexpr int kSpace = 6;           // [px]
constexpr int kShownDigits = 4;     // of a setpoint in another unit

QPushButton* engageButton(const char* name, const QString& text, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromUtf8(name));
    button->setFixedHeight(theme::scaled(kEngageHeight));
    button->setFocusPolicy(Qt::NoFocus);  // the keys go on moving the tip
    return button;
}

/// A list as wide as its longest choice.
QComboBox* engageChoice(const char* name, const QStringList& names, QWidget* parent) {
    auto* choice = new QComboBox(parent);
    choice->setObjectName(QString::fromUtf8(name));
    choice->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    choice->setFixedHeight(theme::scaled(kEngageHeight));
    choice->addItems(names);
    guardFromWheel(*choice);
    return choice;
}

}  // namespace

EngageBar::EngageBar(QWidget* parent)
    : QWidget(parent)
    , setpoint_(SceneDescription{}.setpoint)
    , units_{{tr("nN"), 1e9}}
    , box_(new GainSpinBox(1e9 * kMinSetpoint, 1e9 * kMaxSetpoint, this))
    , unit_(engageChoice("setpointUnit", {units_.front().name}, this))
    , rate_(new GainSpinBox(kMinRamp, kMaxRate, this))
    , size_(new GainSpinBox(kMinRamp, kMaxSize, this))
    , engage_(engageButton("engage", tr("Engage"), this))
    , withdraw_(engageButton("withdraw", tr("Withdraw"), this))
    , hold_(engageChoice("hold", {tr("force"), tr("height")}, this))
    , error_(valueLabel(QStringLiteral("holdError"), QStringLiteral("± 888.8 pN"), this)) {
    auto* row = new FlowLayout(this);
    row->setContentsMargins(kSpace, 0, kSpace, 0);
    row->setSpacing(kSpace);
    addSetpoint();
    addRamp();
    addHold();
    row->addStretch();
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    showSetpoint();
    setRefusals({}, {});
    connect(engage_, &QPushButton::clicked, this, &EngageBar::engageChosen);
    connect(withdraw_, &QPushButton::clicked, this, &EngageBar::withdrawChosen);
}

void EngageBar::addGroup(std::initializer_list<QWidget*> widgets) {
    auto* group = new QWidget(this);
    auto* row = new QHBoxLayout(group);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(kSpace);
    for (QWidget* const widget : widgets) {
        row->addWidget(widget);
    }
    static_cast<FlowLayout*>(layout())->addWidget(group);
}

void EngageBar::addSetpoint() {
    box_->setObjectName(QStringLiteral("setpoint"));
    box_->setToolTip(
        tr("Deflection force: what the bending of the lever says of the force along z, "
           "counted from the free lever. An approach ends at it, and it is held then. "
           "Fz in the panel is another number: the estimate from both signals and the "
           "model"));
    box_->setFixedSize(theme::scaled(kSetpointWidth), theme::scaled(kEngageHeight));
    guardFromWheel(*box_);
    unit_->setToolTip(tr("Unit of the setpoint: force, deflection of the lever, or volts of the "
                         "detector where the probe gives its sensitivity"));
    unit_->setAccessibleName(tr("Unit of the setpoint"));
    auto* caption = captionLabel(tr("Setpoint"), this);
    caption->setToolTip(box_->toolTip());
    addGroup({caption, box_, unit_});
    connect(box_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this](double shown) {
        setpoint_ = shown / unit().perNewton;
        Q_EMIT setpointChanged(setpoint_);
    });
    connect(box_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this,
            &EngageBar::setpointEntered);
    connect(unit_, qOverload<int>(&QComboBox::activated), this, &EngageBar::showSetpoint);
}

void EngageBar::addRamp() {
    addRampBox(*size_, "rampSize", tr("Size of the ramp"),
               tr("Size of the ramp: distance from the sample at which an approach begins and a "
                  "withdrawal ends [nm]; muted: suits the scene, just out of the sample's reach; "
                  "an emptied box returns to that"));
    addRampBox(
        *rate_, "rampRate", tr("Speed of the ramp"),
        tr("Speed of the base down to the setpoint and up out of the sample's reach "
           "[nm/s]; muted: suits the scene, a cycle takes about four seconds; an emptied box "
           "returns to that"));
    const auto caption = [this](const QString& text, const QWidget& box) {
        auto* label = captionLabel(text, this);
        label->setToolTip(box.toolTip());
        return label;
    };
    addGroup({engage_, withdraw_, size_, caption(tr("nm at"), *size_), rate_,
              caption(tr("nm/s"), *rate_)});
}

void EngageBar::addRampBox(GainSpinBox& box, const char* name, const QString& spoken,
                           const QString& toolTip) {
    box.setObjectName(QString::fromUtf8(name));
    box.setToolTip(toolTip);
    box.setAccessibleName(spoken);
    box.setFixedSize(theme::scaled(kRampWidth), theme::scaled(kEngageHeight));
    guardFromWheel(box);
    box.setMuted(true);
    connect(&box, qOverload<double>(&QDoubleSpinBox::valueChanged), &box,
            [&box] { box.setMuted(false); });
    connect(box.findChild<QLineEdit*>(), &QLineEdit::textEdited, &box, [&box](const QString& text) {
        if (text.trimmed().isEmpty()) {
            box.setMuted(true);
        }
    });
    connect(&box, &QDoubleSpinBox::editingFinished, this, &EngageBar::showUsualRamp);
}

void EngageBar::addHold() {
    hold_->setToolTip(
        tr("In contact: a feedback holds the force at the setpoint by moving the "
           "lever up and down, or the height of the lever stays. While a force is held the tip "
           "follows the mouse no faster than the feedback allows"));
    hold_->setAccessibleName(tr("What is held in contact"));
    auto* caption = captionLabel(tr("Hold"), this);
    caption->setToolTip(hold_->toolTip());
    error_->setToolTip(tr(
        "Error of the force that is held: root mean square of force less setpoint, over the last "
        "quarter of a second"));
    addGroup({caption, hold_, error_});
    connect(hold_, qOverload<int>(&QComboBox::activated), this,
            [this] { Q_EMIT holdChosen(holdsForce()); });
}

const SetpointUnit& EngageBar::unit() const {
    return units_.at(static_cast<std::size_t>(std::max(unit_->currentIndex(), 0)));
}

void EngageBar::showSetpoint() {
    const QSignalBlocker blocker(box_);
    const double perNewton = unit().perNewton;
    box_->setRange(perNewton * kMinSetpoint, perNewton * kMaxSetpoint);
    const double exact = perNewton * setpoint_;
    const bool isRound = units_.front().perNewton == perNewton;
    box_->setValue(isRound ? exact : QString::number(exact, 'g', kShownDigits).toDouble());
}

void EngageBar::setSetpoint(double force) {
    if (force != setpoint_) {
        setpoint_ = force;
        showSetpoint();
    }
}

void EngageBar::setUnits(std::vector<SetpointUnit> units) {
    if (units == units_) {
        return;
    }
    const QString chosen = unit().name;
    units_ = std::move(units);
    QStringList names;
    for (const SetpointUnit& each : units_) {
        names << each.name;
    }
    unit_->clear();
    unit_->addItems(names);
    const auto* entries = qobject_cast<const QStandardItemModel*>(unit_->model());
    for (std::size_t i = 0; i < units_.size(); ++i) {
        QStandardItem* const entry = entries->item(static_cast<int>(i));
        entry->setEnabled(units_[i].perNewton > 0.0);
        entry->setToolTip(units_[i].whyNot);
    }
    const int index = std::max(static_cast<int>(names.indexOf(chosen)), 0);
    unit_->setCurrentIndex(entries->item(index)->isEnabled() ? index : 0);
    showSetpoint();
}

Ramp EngageBar::ramp() const {
    return {.rate = rate_->value() / kNanoRamp, .size = size_->value() / kNanoRamp};
}

void EngageBar::setUsualRamp(const Ramp& usual) {
    usual_ = usual;
    const QSignalBlocker blocker(size_);
    size_->setRange(QString::number(kNanoRamp * usual.size, 'g', 2).toDouble(), kMaxSize);
    showUsualRamp();
}

void EngageBar::showUsualRamp() {
    const auto show = [](GainSpinBox& box, double length) {
        if (box.isMuted()) {
            const QSignalBlocker blocker(box);
            box.setValue(QString::number(kNanoRamp * length, 'g', 2).toDouble());
        }
    };
    show(*rate_, usual_.rate);
    show(*size_, usual_.size);
}

bool EngageBar::holdsForce() const { return hold_->currentIndex() == 0; }

void EngageBar::setHoldsForce(bool holds) { hold_->setCurrentIndex(holds ? 0 : 1); }

void EngageBar::setRefusals(const QString& why, const QString& whyNotUp) {
    engage_->setEnabled(why.isEmpty());
    engage_->setToolTip(why.isEmpty() ? tr("Approach until the force reaches the setpoint") : why);
    withdraw_->setEnabled(whyNotUp.isEmpty());
    withdraw_->setToolTip(whyNotUp.isEmpty() ? tr("Rise out of the sample's reach") : whyNotUp);
}

void EngageBar::showError(const QString& error) { error_->setText(error); }

}  // namespace asperity
