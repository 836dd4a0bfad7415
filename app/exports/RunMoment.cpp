#include "app/exports/RunMoment.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/io/TextValue.h"

#include <cmath>

namespace asperity {

namespace {

std::string rangeOf(const RunPlayback& run) {
    return formatted("%.6g s to %.6g s", run.firstTime(), run.lastTime());
}

std::size_t tickAtTime(const RunPlayback& run, double time) {
    if (!(time >= run.firstTime() - RunPlayback::kTimeRounding &&
          time <= run.lastTime() + RunPlayback::kTimeRounding)) {
        throw Error(formatted("%.6g s", time) + " is not in the run: it goes from " + rangeOf(run));
    }
    return run.tickAt(time);
}

RunEvents eventsOf(RunPlayback& run, Progress* progress) {
    RunEventRecorder recorder;
    run.play(
        0,
        [&recorder](const TickSample& sample) {
            recorder.take(sample);
            return true;
        },
        progress);
    return recorder.events();
}

}  // namespace

std::optional<TickSample> sampleOf(const RunEvents& events, NamedMoment moment) {
    switch (moment) {
    case NamedMoment::Deepest:
        return events.deepest;
    case NamedMoment::SnapIn:
        return events.snapIn;
    default:
        return events.lastHold ? events.lastHold : events.beforePullOff;
    }
}

RunMoment runMoment(const std::string& text) {
    if (const auto named = fromKey<NamedMoment>(text)) {
        return *named;
    }
    const std::optional<double> time = parseNumber(text);
    if (!time || !std::isfinite(*time)) {
        throw Error("'" + text + "' is no moment of a run: expected a time in seconds or one of " +
                    keyList<NamedMoment>());
    }
    return *time;
}

std::size_t tickOf(RunPlayback& run, const RunMoment& moment, Progress* progress) {
    if (const auto* const time = std::get_if<double>(&moment)) {
        return tickAtTime(run, *time);
    }
    const NamedMoment named = std::get<NamedMoment>(moment);
    if (named == NamedMoment::Start) {
        return 0;
    }
    if (named == NamedMoment::End) {
        return run.size() - 1;
    }
    const std::optional<TickSample> sample = sampleOf(eventsOf(run, progress), named);
    if (!sample) {
        throw Error(std::string("the run has no ") + keyOf(named) + ": the tip never " +
                    (named == NamedMoment::SnapIn ? "snapped into contact" : "came off") +
                    " from " + rangeOf(run));
    }
    return run.tickAt(sample->time);
}

}  // namespace asperity
