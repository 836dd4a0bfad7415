#include "app/exports/RunMoment.h"

#include "app/loading/ComparedRun.h"
#include "app/loading/SceneLoader.h"
#include "app/recording/Bundle.h"
#include "app/recording/RunComparison.h"
#include "app/runs/LiveRun.h"
#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <cmath>
#include <utility>

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

namespace {

std::string valueText(double value, const SiScale& scale) {
    const double shown = value * scale.factor;
    return formatted("%.2f ", std::abs(shown) < 0.005 ? 0.0 : shown) + scale.unit;
}

/// Returns the name in pictures of a contact: adhesion may hold a tip above the surface at rest.
std::string distanceText(const ContactState& contact, const SiScale& scale) {
    const bool isApart = contact.region() != TipRegion::Contact;
    const char* name = isApart                     ? "gap "
                       : contact.indentation < 0.0 ? "neck height "
                                                   : "indentation ";
    const bool isAbove = isApart || contact.indentation < 0.0;
    return name + valueText(isAbove ? -contact.indentation : contact.indentation, scale);
}

}  // namespace

void MomentCaption::take(const TickSample& sample) {
    force_ = std::max(force_, std::abs(normalForce(sample.output)));
    distance_ = std::max(distance_, std::abs(sample.output.model.contact.indentation));
}

std::string MomentCaption::of(const TickSample& sample) const {
    const TickOutput& out = sample.output;
    return formatted("t = %.3f s, normal force ", sample.time) +
           valueText(normalForce(out), siScaleFor(force_, "N")) + ", " +
           distanceText(out.model.contact, siScaleFor(distance_, "m")) + ", " +
           nameOf(out.model.contact.region());
}

std::string exportName(const std::filesystem::path& input) {
    const std::filesystem::path whole = std::filesystem::absolute(input).lexically_normal();
    const std::filesystem::path last =
        whole.has_filename() ? whole.filename() : whole.parent_path().filename();
    return std::filesystem::is_directory(input) ? last.string() : last.stem().string();
}

bool holdsRun(const std::filesystem::path& input) {
    return std::filesystem::is_directory(input) || isBundle(input);
}

ExportInput::ExportInput(const std::filesystem::path& input, Progress* progress) {
    if (!holdsRun(input)) {
        loaded_ = std::make_unique<const LoadedScene>(loadScene(input, {}, progress));
        return;
    }
    const RunLocation named(input);
    RunWithScene read = named.read([&] { return readRunWithScene(named.folder(), progress); });
    loaded_ = std::make_unique<const LoadedScene>(std::move(read.loaded));
    note_ = std::move(read.note);
    run_.emplace(loaded_->scene, std::move(read.run.inputs));
}

TickSample ExportInput::restingSample() const {
    const Vector3 start = startPosition(scene());
    TickSample first;
    runVirtually(scene(), DevicePath({{0.0, start}}), *instrumentOf(scene()), 1,
                 [&first](const TickSample& sample) { first = sample; });
    return first;
}

}  // namespace asperity
