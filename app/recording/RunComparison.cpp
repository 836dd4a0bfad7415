#include "app/recording/RunComparison.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/scene/SceneFields.h"
#include "core/words/SceneWords.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string_view>
#include <type_traits>
#include <utility>

namespace asperity {

namespace {

/// The force of a run at rising times.
class ForceAt {
public:
    explicit ForceAt(const ForceTrace& trace) : trace_(trace) {}

    /// @param time since the start, no earlier than that of the call before [s]
    /// @return NaN where it is not known [N]
    double operator()(double time) {
        while (next_ + 1 < trace_.size() && trace_.sinceBegin(next_ + 1) <= time) {
            ++next_;
        }
        // Times that mean the same may differ in the last bits; a neighbor that is not known must
        // not count then.
        for (const std::size_t tick : {next_, std::min(next_ + 1, trace_.size() - 1)}) {
            if (std::abs(trace_.sinceBegin(tick) - time) <= RunPlayback::kTimeRounding) {
                return trace_.force()[tick];
            }
        }
        const double from = trace_.sinceBegin(next_);
        const double share = (time - from) / (trace_.sinceBegin(next_ + 1) - from);
        const double force = trace_.force()[next_];
        return force + share * (trace_.force()[next_ + 1] - force);  // std::lerp() may hide NaN
    }

private:
    const ForceTrace& trace_;
    std::size_t next_ = 0;  ///< the last tick that is not later
};

void summarize(RunComparison& comparison) {
    double sum = 0.0;
    double squares = 0.0;
    comparison.largest = comparison.ticks.front();
    for (const ComparedForces& tick : comparison.ticks) {
        const double difference = tick.difference();
        sum += difference;
        squares += difference * difference;
        if (std::abs(difference) > std::abs(comparison.largest.difference())) {
            comparison.largest = tick;
        }
    }
    const auto count = static_cast<double>(comparison.ticks.size());
    comparison.mean = sum / count;
    comparison.rms = std::sqrt(squares / count);
}

/// A key of a scene or a knob, and its value for people.
struct NamedValue {
    std::string name;
    std::string value;
};

std::string numberText(double value, const char* unit, double scale) {
    return *unit == '\0' ? formatted("%.6g", value / scale)
                         : formatted("%.6g %s", value / scale, unit);
}

std::string switchText(bool isOn) { return formatted("%s", isOn ? "on" : "off"); }

std::string textOf(const SceneField& field, const SceneValue& value) {
    if (const auto* const number = std::get_if<double>(&value)) {
        return numberText(*number, field.words.unit, field.words.scale);
    }
    if (const auto* const isOn = std::get_if<bool>(&value)) {
        return switchText(*isOn);
    }
    const auto& text = std::get<std::string>(value);
    const auto named = std::ranges::find(field.choices, text, &SceneChoice::key);
    if (named != field.choices.end()) {
        return named->name;
    }
    return text.empty() ? formatted("none") : text;
}

template <class Value>
std::string textOf(const SettingField& field, const Value& value) {
    if constexpr (std::is_enum_v<Value>) {
        return keyOf(value);
    } else if constexpr (std::is_same_v<Value, bool>) {
        return switchText(value);
    } else {
        return numberText(static_cast<double>(value), field.words.unit, field.words.scale);
    }
}

/// Told by the name of the scan; its file may be the same one elsewhere.
bool isOfScan(const SceneField& field) {
    return field.group == SceneGroup::Sample &&
           (field.input == SceneInput::File || std::string_view(field.key) == "channel");
}

/// All that the force can follow from, but the scan.
std::vector<NamedValue> valuesOf(const SceneDescription& scene) {
    std::vector<NamedValue> values;
    for (const SceneField& field : sceneFields()) {
        if (field.group != SceneGroup::View && !isOfScan(field)) {
            values.push_back({formatted("%s, %s", nameOf(field.group), field.words.caption),
                              textOf(field, field.get(scene))});
        }
    }
    listSettings(scene.settings, [&values](const SettingField& field, const auto& value) {
        if (field.key != nullptr && field.words.group != SettingGroup::Hidden) {
            values.push_back({formatted("%s, %s", nameOf(field.words.group), field.words.caption),
                              textOf(field, value)});
        }
    });
    return values;
}

}  // namespace

double normalForce(const TickOutput& output) noexcept {
    return output.estimate.force.dot(output.model.normal);
}

double normalForceSigma(const TickOutput& output) noexcept {
    const Vector3& normal = output.model.normal;
    return std::sqrt(std::max(normal.dot(output.estimate.covariance * normal), 0.0));
}

void ForceTrace::take(const TickSample& sample) {
    const TickOutput& output = sample.output;
    const bool isKnown =
        output.fault == Fault::None && output.estimate.kind != DecouplingCase::InvalidInput;
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    add(sample.time, isKnown ? normalForce(output) : kUnknown, output.model.contact.indentation);
}

void ForceTrace::add(double time, double force, double indentation) {
    const bool isKnown = std::isfinite(force) && std::isfinite(indentation);
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    time_.push_back(time);
    force_.push_back(isKnown ? force : kUnknown);
    indentation_.push_back(isKnown ? indentation : kUnknown);
}

RunSurvey surveyOf(RunPlayback& run, Progress* progress) {
    ForceTrace trace;
    RunEventRecorder events;
    run.play(
        0,
        [&](const TickSample& sample) {
            trace.take(sample);
            events.take(sample);
            return true;
        },
        progress);
    return {.trace = std::move(trace), .events = events.events()};
}

RunComparison compareRuns(const ForceTrace& first, const ForceTrace& second) {
    RunComparison comparison;
    comparison.overlap = std::min(first.duration(), second.duration());
    ForceAt secondForce(second);
    for (std::size_t tick = 0; second.size() > 0 && tick < first.size(); ++tick) {
        const double time = first.sinceBegin(tick);
        if (time > comparison.overlap + RunPlayback::kTimeRounding) {
            break;
        }
        const ComparedForces forces{time, first.force()[tick], secondForce(time)};
        if (std::isfinite(forces.difference())) {
            comparison.ticks.push_back(forces);
        } else {
            ++comparison.excluded;
        }
    }
    if (comparison.ticks.empty()) {
        throw Error("the runs have no moment in which both forces are known");
    }
    summarize(comparison);
    return comparison;
}

RunConditions conditionsOf(const LoadedScene& loaded) {
    return {.scene = loaded.scene.description, .sha256 = loaded.sha256};
}

std::vector<std::string> differencesOf(const RunConditions& first, const RunConditions& second) {
    std::vector<std::string> differences;
    const auto add = [&differences](const std::string& name, const std::string& one,
                                    const std::string& other) {
        std::string text = name;
        differences.push_back(text.append(": ").append(one).append(" → ").append(other));
    };
    if (first.sha256 != second.sha256 ||
        first.scene.sample.channel != second.scene.sample.channel) {
        add("Scan", sampleName(first.scene.sample), sampleName(second.scene.sample));
    }
    const std::vector<NamedValue> ones = valuesOf(first.scene);
    const std::vector<NamedValue> others = valuesOf(second.scene);
    for (std::size_t i = 0; i < ones.size(); ++i) {
        if (ones[i].value != others[i].value) {
            add(ones[i].name, ones[i].value, others[i].value);
        }
    }
    return differences;
}

}  // namespace asperity
