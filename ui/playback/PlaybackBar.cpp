#include "ui/playback/PlaybackBar.h"

#include "ui/measure/PageParts.h"
#include "ui/panels/ChoiceBox.h"
#include "ui/panels/FlowLayout.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>

namespace asperity {

namespace {

constexpr std::array<double, 3> kSpeeds{0.1, 1.0, 10.0};  ///< recorded seconds a second
constexpr int kUsualSpeed = 1;                            ///< of kSpeeds
constexpr int kPages = 50;  ///< of a run: how far Page Up and a click beside the handle go

struct StepWords {
    const char* name;
    const char* objectName;
    const char* toolTip;
    const char* lack;  ///< why it does not work
};

constexpr std::array<StepWords, kPlaybackSteps> kStepWords{
    {{QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Start"), "stepStart",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "First tick of the recording"), ""},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Snap-in"), "stepSnapIn",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "First tick of the first contact"),
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "The tip never came into contact")},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Deepest"), "stepDeepest",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Largest indentation"),
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "The tip never came into contact")},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Pull-off"), "stepPullOff",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Just before the tip came off for the last time"),
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "The tip never came off")},
     {QT_TRANSLATE_NOOP("asperity::PlaybackBar", "End"), "stepEnd",
      QT_TRANSLATE_NOOP("asperity::PlaybackBar", "Last tick of the recording"), ""}}};

QString noRun() { return PlaybackBar::tr("Choose a recording first: Run > Look at a recording…"); }

/// Disables what cannot work and says why; empty: it works.
void refuse(QWidget& control, const QString& reason, const QString& toolTip) {
    control.setEnabled(reason.isEmpty());
    control.setToolTip(reason.isEmpty() ? toolTip : reason);
}

}  // namespace

PlaybackBar::PlaybackBar(QWidget* parent)
    : QWidget(parent)
    , play_(pageButton({}, "playRecording", {}, this))
    , time_(new QSlider(Qt::Horizontal, this))
    , speed_(new ChoiceBox(this))
    , compare_(pageButton(tr("Compare with…"), "compareRuns", {}, this))
    , alone_(pageButton(tr("Stop comparing"), "stopComparing",
                        tr("Shows the recording alone again"), this))
    , back_(pageButton(tr("Back to the live tip"), "backToLive", {}, this)) {
    play_->setCheckable(true);
    time_->setObjectName(QStringLiteral("recordingTime"));
    speed_->setObjectName(QStringLiteral("recordingSpeed"));
    speed_->setNames({tr("0.1×"), tr("1×"), tr("10×")});
    speed_->setCurrentIndex(kUsualSpeed);
    speed_->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    buildSteps();
    auto* rows = new QVBoxLayout(this);
    rows->setContentsMargins(0, 0, 0, 0);
    rows->setSpacing(3);
    rows->addWidget(timeRow());
    rows->addWidget(stepRow());
    connect(play_, &QToolButton::toggled, this, &PlaybackBar::playingChosen);
    connect(time_, &QSlider::valueChanged, this, &PlaybackBar::tickChosen);
    connect(compare_, &QToolButton::clicked, this, &PlaybackBar::compareRequested);
    connect(alone_, &QToolButton::clicked, this, &PlaybackBar::endComparisonRequested);
    connect(back_, &QToolButton::clicked, this, &PlaybackBar::backRequested);
    setPlaying(false);
    setComparing(false);
    setRun(0, {});
}

void PlaybackBar::buildSteps() {
    for (std::size_t i = 0; i < kPlaybackSteps; ++i) {
        buttons_[i] = pageButton(tr(kStepWords[i].name), kStepWords[i].objectName, {}, this);
        connect(buttons_[i], &QToolButton::clicked, this, [this, i] {
            if (steps_[i]) {
                Q_EMIT tickChosen(*steps_[i]);
            }
        });
    }
}

QWidget* PlaybackBar::timeRow() {
    auto* bar = new QWidget(this);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(play_);
    row->addWidget(time_, 1);
    row->addWidget(speed_);
    return bar;
}

QWidget* PlaybackBar::stepRow() {
    auto* bar = new QWidget(this);
    auto* row = new FlowLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(4);
    for (QToolButton* const button : buttons_) {
        row->addWidget(button);
    }
    row->addStretch();
    for (QToolButton* const button : {compare_, alone_, back_}) {
        row->addWidget(button);
    }
    return bar;
}

void PlaybackBar::setRun(int ticks, const Steps& steps) {
    steps_ = steps;
    const QString lack = ticks > 0 ? QString() : noRun();
    const QSignalBlocker quiet(time_);
    time_->setRange(0, std::max(ticks - 1, 0));
    time_->setPageStep(std::max(ticks / kPages, 1));
    refuse(*time_, lack, tr("Moment of the recording that is shown; arrow keys: tick by tick"));
    refuse(*play_, lack, tr("Play the recording, or pause it"));
    refuse(*speed_, lack, tr("How fast it plays"));
    refuse(*compare_, lack, tr("Overlay a second run, and show the difference of the forces"));
    refuse(*back_, ticks > 0 ? QString() : tr("The live tip is shown"),
           tr("Leave the recording: the run goes on, live"));
    for (std::size_t i = 0; i < kPlaybackSteps; ++i) {
        const QString missing = steps[i] ? QString() : tr(kStepWords[i].lack);
        refuse(*buttons_[i], lack.isEmpty() ? missing : lack, tr(kStepWords[i].toolTip));
    }
}

void PlaybackBar::setTick(int tick) {
    if (!time_->isSliderDown()) {
        const QSignalBlocker quiet(time_);
        time_->setValue(tick);
    }
}

void PlaybackBar::setPlaying(bool playing) {
    const QSignalBlocker quiet(play_);
    play_->setChecked(playing);
    play_->setText(playing ? tr("Pause") : tr("Play"));
}

double PlaybackBar::speed() const {
    return kSpeeds.at(static_cast<std::size_t>(std::max(speed_->currentIndex(), 0)));
}

void PlaybackBar::setComparing(bool comparing) { alone_->setVisible(comparing); }

}  // namespace asperity
