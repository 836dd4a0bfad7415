#include "app/reports/run/RunVerdict.h"

#include "app/reports/run/MeasuredText.h"

namespace asperity {

namespace {

std::string inTicks(long part, long whole) {
    return "in " + std::to_string(part) + " of " + std::to_string(whole) + " ticks (" +
           shareText(part, whole) + ")";
}

std::string namesOf(const std::map<Fault, long>& faults) {
    std::string names;
    for (const auto& [fault, ticks] : faults) {
        names += (names.empty() ? "" : "; ") + std::string(nameOf(fault));
    }
    return names;
}

}  // namespace

RunVerdict verdictOn(const RunHistory& history) {
    const RunEvents& events = history.events();
    const auto ticks = [&](Severity severity) {
        return history.ticksBySeverity().at(static_cast<std::size_t>(severity));
    };
    if (events.faults > 0) {
        return {PageTone::Fault, "fault: forces off",
                "Forces were off after a fault " + inTicks(events.faults, events.ticks) + ": " +
                    namesOf(history.faults()) + ". What follows the fault is no measurement."};
    }
    if (events.cycles.empty() && !events.snapIn && !events.bondedFromStart) {
        return {PageTone::Plain, "no contact",
                "The tip never touched the sample: there is no contact to judge."};
    }
    if (const long invalid = ticks(Severity::Invalid); invalid > 0) {
        return {PageTone::Fault, "no result in " + shareText(invalid, events.ticks),
                "There is no result to rely on " + inTicks(invalid, events.ticks) + ".", true};
    }
    if (const long doubt = ticks(Severity::Doubt); doubt > 0) {
        return {PageTone::Caution, "doubtful in " + shareText(doubt, events.ticks),
                "The contact model does not hold in full " + inTicks(doubt, events.ticks) + ".",
                true};
    }
    if (const long approximate = ticks(Severity::Approximate); approximate > 0) {
        return {PageTone::Plain, "approximate in " + shareText(approximate, events.ticks),
                "The result holds, less exactly " + inTicks(approximate, events.ticks) + ".", true};
    }
    return {PageTone::Plain, "holds",
            "The contact model holds in all " + std::to_string(events.ticks) + " ticks."};
}

}  // namespace asperity
