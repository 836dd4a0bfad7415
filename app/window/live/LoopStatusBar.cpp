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

QString countText(long count) { return QLocale(QLocale::English).toString(qlonglong{count}); }

/// The loop's thread as the system treats it; the second says what would help.
QString schedulingText(SchedulingPolicy policy) {
    return policy == SchedulingPolicy::Realtime
               ? LoopStatusBar::tr("real-time")
               : LoopStatusBar::tr("ordinary: no permission for SCHED_FIFO");
}

}  // namespace

LoopStatusBar::LoopStatusBar(QWidget* parent) : QWidget(parent) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(8, 1, 8, 1);
    layout->setSpacing(4);
    rate_ = addItem("rate", tr("Ticks a second that the loop is asked for"), tr("loop"),
                    QStringLiteral("10,000 Hz"));
    tickTime_ = addItem("tickTime", tr("Computing time of a tick: median and 99th percentile"),
                        tr("tick p50 / p99"), QStringLiteral("88.8 µs / 88.8 µs"));
    lateness_ = addItem("lateness", tr("How late a tick begins: 99th percentile"), tr("late p99"),
                        QStringLiteral("88.8 µs"));
    overruns_ = addItem("overruns", tr("Ticks that ended after the next one should have begun"),
                        tr("overruns"), QStringLiteral("88,888"));
    lost_ = addItem("lost", tr("Ticks that the window did not fetch in time: missing in curves"),
                    tr("lost"), QStringLiteral("88,888"));
    ticks_ = addItem("ticks", tr("Ticks since the run began"), tr("ticks"),
                     QStringLiteral("88,888,888"));
    frames_ = addItem("frames", tr("Pictures of the large view a second"), tr("frames/s"),
                      QStringLiteral("88.8"));
    layout->addStretch(1);
    scheduling_ = captionLabel(QString(), this);
    scheduling_->setObjectName(QStringLiteral("scheduling"));
    scheduling_->setToolTip(tr("How the system schedules the loop's thread"));
    layout->addWidget(scheduling_);
    clear();
}

QLabel* LoopStatusBar::addItem(const char* objectName, const QString& meaning,
                               const QString& caption, const QString& widest) {
    auto* value = valueLabel(QString::fromUtf8(objectName), widest, this);
    value->setFont(theme::textFont(theme::kSmallSize));
    value->setAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    auto* row = static_cast<QHBoxLayout*>(layout());
    auto* name = captionLabel(caption, this);
    name->setToolTip(meaning);
    value->setToolTip(meaning);
    row->addWidget(name);
    row->addWidget(value);
    row->addSpacing(6);
    return value;
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
    for (QLabel* label : {rate_, ticks_, tickTime_, lateness_, overruns_, lost_, frames_}) {
        label->setText(kNotKnown);
    }
    framesPerSecond_.reset();
    scheduling_->clear();
}

}  // namespace asperity
