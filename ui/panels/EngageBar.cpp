#include "ui/panels/EngageBar.h"

#include "core/scene/SceneDescription.h"
#include "ui/Theme.h"
#include "ui/panels/Card.h"
#include "ui/panels/GainSpinBox.h"
#include "ui/panels/WheelGuard.h"

#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalBlocker>

namespace asperity {

namespace {

constexpr double kPerNewton = 1e9;  // shown as nanonewtons
constexpr int kEngageHeight = 26;   // [px, as theme::scaled() takes them]
constexpr int kSetpointWidth = 84;  // likewise
constexpr int kSpace = 8;           // [px]

QPushButton* newButton(const char* name, const QString& text, const QString& toolTip,
                       QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setObjectName(QString::fromUtf8(name));
    button->setToolTip(toolTip);
    button->setFixedHeight(theme::scaled(kEngageHeight));
    button->setFocusPolicy(Qt::NoFocus);  // the keys go on moving the tip
    return button;
}

}  // namespace

EngageBar::EngageBar(QWidget* parent)
    : QWidget(parent)
    , setpoint_(new GainSpinBox(kPerNewton * kMinSetpoint, kPerNewton * kMaxSetpoint, this))
    , engage_(newButton("engage", tr("Engage"), {}, this))
    , withdraw_(newButton("withdraw", tr("Withdraw"), {}, this)) {
    setpoint_->setObjectName(QStringLiteral("setpoint"));
    setpoint_->setToolTip(tr("Force along z at which an approach ends [nN]"));
    setpoint_->setFixedSize(theme::scaled(kSetpointWidth), theme::scaled(kEngageHeight));
    guardFromWheel(*setpoint_);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(kSpace, 0, kSpace, 0);
    row->setSpacing(kSpace);
    auto* caption = captionLabel(tr("Setpoint [nN]"), this);
    caption->setToolTip(setpoint_->toolTip());
    row->addWidget(caption);
    row->addWidget(setpoint_);
    row->addWidget(engage_);
    row->addWidget(withdraw_);
    row->addStretch(1);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setSetpoint(SceneDescription{}.setpoint);
    setRefusals({}, {});
    connect(engage_, &QPushButton::clicked, this, &EngageBar::engageChosen);
    connect(withdraw_, &QPushButton::clicked, this, &EngageBar::withdrawChosen);
    connect(setpoint_, qOverload<double>(&QDoubleSpinBox::valueChanged), this,
            [this](double shown) { Q_EMIT setpointChanged(shown / kPerNewton); });
    connect(setpoint_->findChild<QLineEdit*>(), &QLineEdit::returnPressed, this,
            &EngageBar::setpointEntered);
}

double EngageBar::setpoint() const { return setpoint_->value() / kPerNewton; }

void EngageBar::setSetpoint(double force) {
    const QSignalBlocker blocker(setpoint_);
    setpoint_->setValue(kPerNewton * force);
}

void EngageBar::setRefusals(const QString& why, const QString& whyNotUp) {
    engage_->setEnabled(why.isEmpty());
    engage_->setToolTip(why.isEmpty() ? tr("Approach until the force reaches the setpoint") : why);
    withdraw_->setEnabled(whyNotUp.isEmpty());
    withdraw_->setToolTip(whyNotUp.isEmpty() ? tr("Rise out of the sample's reach") : whyNotUp);
}

}  // namespace asperity
