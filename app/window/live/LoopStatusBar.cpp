#include "app/window/live/LoopStatusBar.h"

#include "core/scene/Scene.h"
#include "ui/widgets/Card.h"
#include "ui/widgets/ShownText.h"
#include "ui/widgets/Theme.h"

#include <QHBoxLayout>
#include <QLocale>

namespace asperity {

namespace {

const QString kNotKnown = QStringLiteral("–");

/// Share of the ticks that may be missed: a few mean nothing, with a system that is not real-time.
constexpr double kMayBeMissed = 0.01;

constexpr int kItemGap = 4;       // between a caption and its number [px]
constexpr int kBetweenItems = 6;  // beyond that [px]
constexpr int kLineMargin = 8;    // at both ends [px]

QString countText(long count) { return QLocale(QLocale::English).toString(qlonglong{count}); }

/// The loop's thread as the system treats it.
QString schedulingText(SchedulingPolicy policy) {
    return policy == SchedulingPolicy::Realtime ? LoopStatusBar::tr("real-time")
                                                : LoopStatusBar::tr("ordinary");
}

/// The same with what would help.
QString schedulingTip(SchedulingPolicy policy) {
    return policy == SchedulingPolicy::Realtime
               ? LoopStatusBar::tr("The system runs the loop before other programs")
               : LoopStatusBar::tr("The system runs the loop as any other program: there is no "
                                   "permission for SCHED_FIFO");
}

}  // namespace

LoopStatusBar::LoopStatusBar(QWidget* parent) : QWidget(parent) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(kLineMargin, 1, kLineMargin, 1);
    layout->setSpacing(kItemGap);
    state_ = captionLabel(QString(), this);
    state_->setObjectName(QStringLiteral("loopState"));
    layout->addWidget(state_);
    rate_ = addItem("rate", tr("Ticks a second that the loop is asked for"), tr("rate"),
                    QStringLiteral("10,000 Hz"));
    tickTime_ = addItem("tickTime", tr("Computing time of a tick: median and 99th percentile"),
                        tr("tick p50 / p99"), QStringLiteral("88.8 µs / 88.8 µs"));
    lateness_ = addItem("lateness", tr("How late a tick begins: 99th percentile"), tr("late p99"),
                        QStringLiteral("88.8 µs"));
    overruns_ = addItem("overruns", tr("Ticks that ended after the next one should have begun"),
                        tr("overruns"), QStringLiteral("88,888"));
    frames_ = addItem("frames", tr("Pictures of the large view a second"), tr("frames/s"),
                      QStringLiteral("88.8"));
    scheduling_ = addItem("scheduling", tr("How the system schedules the loop's thread"),
                          tr("scheduling"), QStringLiteral("real-time"));
    lost_ = addItem("lost", tr("Ticks that the window did not fetch in time: missing in curves"),
                    tr("lost"), QStringLiteral("88,888"));
    ticks_ = addItem("ticks", tr("Ticks since the run began"), tr("ticks"),
                     QStringLiteral("88,888,888"));
    layout->addStretch(1);
    // As narrow as its first word: further numbers fit or are hidden.
    setMinimumWidth(state_->fontMetrics().horizontalAdvance(tr("● loop on time")) +
                    2 * kLineMargin);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    clear();
    showItems();
}

QLabel* LoopStatusBar::addItem(const char* objectName, const QString& meaning,
                               const QString& caption, const QString& widest) {
    auto* value = valueLabel(QString::fromUtf8(objectName), widest, this);
    value->setFont(theme::textFont(theme::kSmallSize));
    value->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    auto* row = static_cast<QHBoxLayout*>(layout());
    auto* name = captionLabel(caption, this);
    name->setContentsMargins(kBetweenItems, 0, 0, 0);
    name->setToolTip(meaning);
    value->setToolTip(meaning);
    row->addWidget(name);
    row->addWidget(value);
    items_.push_back({name, value});
    return value;
}

void LoopStatusBar::setDetailed(bool detailed) {
    isDetailed_ = detailed;
    showItems();
}

void LoopStatusBar::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showItems();
}

/// Those that do not fit are left out, the last ones first.
void LoopStatusBar::showItems() {
    int left = width() - 2 * kLineMargin - state_->sizeHint().width();
    for (const Item& item : items_) {
        left -= item.caption->sizeHint().width() + item.value->width() + 2 * kItemGap;
        const bool isShown = isDetailed_ && left >= 0;
        item.caption->setVisible(isShown);
        item.value->setVisible(isShown);
    }
}

/// Judged once a second of the loop's own time, so that the word does not flicker.
void LoopStatusBar::showState(const LoopStatistics& statistics) {
    const auto ticks = static_cast<double>(statistics.ticks - ticksThen_);
    if (ticks < 0.0 || ticks >= rateAsked_) {
        const auto missed = static_cast<double>(statistics.overruns - overrunsThen_);
        isLate_ = missed > kMayBeMissed * ticks;
        ticksThen_ = statistics.ticks;
        overrunsThen_ = statistics.overruns;
    }
    state_->setText(isLate_ ? tr("▲ loop late") : tr("● loop on time"));
    state_->setToolTip(
        tr("%1 ticks a second are asked for. A tick takes %2 (median) and %3 (99th percentile), "
           "and begins %4 late (99th percentile); %5 were missed. All of it: View > Loop timing in "
           "the bottom line")
            .arg(rate_->text(), siText(statistics.tickTime.median, "s"),
                 siText(statistics.tickTime.p99, "s"), siText(statistics.lateness.p99, "s"),
                 countText(statistics.overruns)));
}

void LoopStatusBar::begin(const Scene& scene) { setRateAsked(scene.description.tickRate); }

void LoopStatusBar::setRateAsked(double rate) {
    rateAsked_ = rate;
    rate_->setText(QLocale(QLocale::English).toString(rate, 'f', 0) + QStringLiteral(" Hz"));
}

void LoopStatusBar::setFramesPerSecond(const std::optional<double>& frames) {
    framesPerSecond_ = frames;
    frames_->setText(frames ? QString::number(*frames, 'f', 1) : kNotKnown);
}

void LoopStatusBar::show(const Snapshot& snapshot) {
    const LoopStatistics& statistics = snapshot.statistics;
    ticks_->setText(countText(statistics.ticks));
    tickTime_->setText(siText(statistics.tickTime.median, "s") + QStringLiteral(" / ") +
                       siText(statistics.tickTime.p99, "s"));
    lateness_->setText(siText(statistics.lateness.p99, "s"));
    overruns_->setText(countText(statistics.overruns));
    lost_->setText(countText(statistics.lostSamples));
    scheduling_->setText(schedulingText(statistics.policy));
    scheduling_->setToolTip(schedulingTip(statistics.policy));
    showState(statistics);
}

ShownNumbers LoopStatusBar::numbers(const Snapshot& snapshot) const {
    const LoopStatistics& statistics = snapshot.statistics;
    const QString second = QStringLiteral("s");
    const auto count = [](long number) { return static_cast<double>(number); };
    ShownNumbers numbers{{tr("loop rate"), rateAsked_, {}, QStringLiteral("Hz")},
                         {tr("tick time, median"), statistics.tickTime.median, {}, second},
                         {tr("tick time, 99th percentile"), statistics.tickTime.p99, {}, second},
                         {tr("lateness, 99th percentile"), statistics.lateness.p99, {}, second},
                         {tr("overruns"), count(statistics.overruns), {}, {}},
                         {tr("lost ticks"), count(statistics.lostSamples), {}, {}},
                         {tr("ticks"), count(statistics.ticks), {}, {}}};
    if (framesPerSecond_) {
        numbers.push_back({tr("frames"), *framesPerSecond_, {}, QStringLiteral("1/s")});
    }
    return numbers;
}

void LoopStatusBar::clear() {
    for (const Item& item : items_) {
        item.value->setText(kNotKnown);
    }
    framesPerSecond_.reset();
    ticksThen_ = 0;
    overrunsThen_ = 0;
    isLate_ = false;
    state_->setText(tr("○ no loop"));
    state_->setToolTip(tr("No run was begun"));
}

}  // namespace asperity
