#include "app/reports/run/ValiditySection.h"

#include "app/reports/run/MeasuredText.h"
#include "app/reports/run/RunVerdict.h"
#include "core/FormattedText.h"
#include "core/SiFormat.h"
#include "core/scene/FlagOrder.h"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace asperity {

namespace {

/// By Severity.
constexpr std::array kMeanings{"announces what comes; the result holds",
                               "the result holds, less exactly", "the result does not hold in full",
                               "no result to rely on"};

PageTable flagTable(const RunEvents& events) {
    PageTable table{.columns = {{"What"}, {"Meaning"}, {"Ticks", true}, {"Share", true}},
                    .rows = {}};
    for (const Validity flag : kFlagsByEffect) {
        const ValidityTraits& traits = traitsOf(flag);
        const long ticks = events.flagged.at(indexOf(flag));
        if (ticks == 0) {
            continue;
        }
        const char* const noise = traits.basis == FlagBasis::Signals
                                      ? " (from noisy signals: a few ticks say little)"
                                      : "";
        table.rows.push_back(
            {{capitalized(traits.words) + " [" + traits.key + "]"},
             {kMeanings.at(static_cast<std::size_t>(traits.severity)) + std::string(noise)},
             {std::to_string(ticks)},
             {shareText(ticks, events.ticks)}});
    }
    return table;
}

/// "At the maximum indentation: ..."; nothing where there was no such moment.
void addMoment(std::vector<std::string>& list, const char* when,
               const std::optional<TickSample>& sample) {
    if (!sample) {
        return;
    }
    std::string words;
    for (const Validity flag : kFlagsByEffect) {
        if (sample->output.flags.has(flag)) {
            words += (words.empty() ? "" : "; ") + std::string(traitsOf(flag).words);
        }
    }
    list.push_back(std::string(when) + ": " + (words.empty() ? "no flag" : words) + ".");
}

void addWidth(std::vector<std::string>& list, const TipState& state) {
    list.push_back(
        "Contact radius at the maximum indentation: " + formatSi(state.contact.contactRadius, "m") +
        formatted(". Its ratio to the effective radius of tip and sample there is %.3g; half-space "
                  "theory holds up to 0.3.",
                  state.contactRatio));
}

PageTable faultTable(const std::map<Fault, long>& faults, long ticks) {
    PageTable table{.columns = {{"Fault"}, {"Ticks", true}, {"Share", true}}, .rows = {}};
    for (const auto& [fault, count] : faults) {
        table.rows.push_back(
            {{capitalized(nameOf(fault))}, {std::to_string(count)}, {shareText(count, ticks)}});
    }
    return table;
}

}  // namespace

void addValidity(PageContent& page, const RunHistory& history) {
    const RunEvents& events = history.events();
    const RunVerdict verdict = verdictOn(history);
    page.addHeading("Validity");
    page.addParagraph(verdict.sentence, verdict.tone);
    if (!history.faults().empty()) {
        page.addTable(faultTable(history.faults(), events.ticks));
    }
    PageTable flags = flagTable(events);
    if (flags.rows.empty()) {
        page.addParagraph("No tick has a validity flag.");
    } else {
        page.addTable(std::move(flags));
    }
    const bool isContact = events.deepest && events.deepest->output.region() == TipRegion::Contact;
    std::vector<std::string> list;
    if (isContact) {
        addMoment(list, "Maximum indentation", events.deepest);
        addWidth(list, events.deepest->output.model);
    }
    addMoment(list, "Just before pull-off", events.lastHold);
    if (events.bondedFromStart) {
        list.emplace_back("The contact model is in contact from the first tick on.");
    } else if (!events.snapIn) {
        list.emplace_back("The contact model never snapped into contact.");
    }
    page.addList(list);
}

}  // namespace asperity
