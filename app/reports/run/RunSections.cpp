#include "app/reports/run/RunSections.h"

#include "app/program/ProgramParts.h"
#include "core/FormattedText.h"
#include "core/scene/Validity.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string_view>
#include <utility>

namespace asperity {

void RunHistory::take(TickSample sample) {
    if (events().ticks == 0) {
        first_ = sample.time;
    }
    sample.time -= first_;
    last_ = sample.time;
    events_.take(sample);
    path_.push_back(sample.output.tip);
    takeCurve(sample);
    takeFlags(sample.output);
}

void RunHistory::takeCurve(const TickSample& sample) {
    detector_.take(sample.time, sample.input, sample.output);
    if (detector_.number() != number_) {
        number_ = detector_.number();
        present_.clear();
    }
    present_.take(detector_);
    const std::size_t cycles = events().cycles.size();
    if (!detector_.cycle().touched() || cycles > kDrawnCycles) {
        return;
    }
    if (curves_.size() < cycles) {
        curves_.emplace_back();
    }
    curves_.back() = {detector_.cycle(), present_};
}

void RunHistory::takeFlags(const TickOutput& out) {
    std::optional<Severity> worst;
    for (const ValidityTraits& traits : kValidityTraits) {
        if (traits.basis != FlagBasis::Signals && out.flags.has(traits.flag)) {
            worst = std::max(worst.value_or(traits.severity), traits.severity);
        }
    }
    if (worst) {
        ++worst_.at(static_cast<std::size_t>(*worst));
    }
    if (out.fault != Fault::None) {
        ++faults_[out.fault];
    }
}

std::string numberText(double value, const SiScale& scale) {
    if (value == 0.0) {
        return "0";  // never "-0"
    }
    std::string text = formatted("%#.4g", value * scale.factor);  // with zeros at the end
    if (text.ends_with('.')) {
        text.pop_back();
    }
    return text;
}

std::string measuredText(const Reading& reading, const SiScale& scale) {
    const double sigma = reading.sigma * scale.factor;
    if (!(sigma > 0.0) || !std::isfinite(sigma)) {
        return numberText(reading.value, scale);
    }
    constexpr int kMaxDecimals = 6;
    const int decimals =
        std::clamp(1 - static_cast<int>(std::floor(std::log10(sigma))), 0, kMaxDecimals);
    // No-break spaces: a table must not part them.
    return formatted("%.*f\u00A0±\u00A0%.*f", decimals, reading.value * scale.factor, decimals,
                     sigma);
}

std::string noisyText(const Reading& reading, const SiScale& scale) {
    const std::string text = measuredText(reading, scale);
    return text.find("±") != std::string::npos ? text + "\u00A0(noise)" : text;
}

std::string measuredText(const Reading& reading, const std::string& unit) {
    const SiScale scale = siScaleFor(reading.value, unit);
    const std::string text = measuredText(reading, scale);
    const bool hasSigma = text.find("±") != std::string::npos;
    return hasSigma ? "(" + text + ") " + scale.unit : text + " " + scale.unit;
}

std::string capitalized(std::string sentence) {
    if (!sentence.empty() && sentence[0] >= 'a' && sentence[0] <= 'z') {
        sentence[0] = static_cast<char>(sentence[0] - 'a' + 'A');
    }
    return sentence;
}

std::string shareText(long part, long whole) {
    if (part == 0 || whole == 0) {
        return "0\u00A0%";
    }
    const double percent = 100.0 * static_cast<double>(part) / static_cast<double>(whole);
    return percent < 0.1 ? "<\u00A00.1\u00A0%" : formatted("%.1f\u00A0%%", percent);
}

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

namespace {

/// A moment of a run, for people.
struct Moment {
    const char* name;
    const std::optional<TickSample>& sample;
};

bool isContact(const std::optional<TickSample>& sample) {
    return sample && sample->output.region() == TipRegion::Contact;
}

std::vector<Moment> momentsOf(const RunEvents& events) {
    return {{"last tick before snap-in", events.beforeSnapIn},
            {"first tick after snap-in", events.snapIn},
            {isContact(events.deepest) ? "maximum indentation" : "nearest to the sample",
             events.deepest},
            {"strongest attraction", events.strongestPull},
            {"before pull-off, signals and model both hold the tip", events.lastHold},
            {"last tick of the model's contact", events.beforePullOff}};
}

/// With its deviation by noise, stiffness and calibration.
Reading estimateOf(const Uncertainty& given, const TickOutput& out) {
    const Vector3& normal = out.model.normal;
    const double force = out.estimate.force.dot(normal);
    const double noise = std::sqrt(std::max(0.0, normal.dot(out.estimate.covariance * normal)));
    return {force, forceBudget(given, force, noise).total()};
}

struct MomentScales {
    SiScale length;
    SiScale force;
};

MomentScales scalesOf(const Uncertainty& given, const std::vector<Moment>& moments) {
    double length = 0.0;
    double force = 0.0;
    for (const Moment& moment : moments) {
        if (moment.sample) {
            const TipState& state = moment.sample->output.model;
            length = std::max(
                {length, std::abs(state.contact.indentation), state.contact.contactRadius});
            const Reading estimate = estimateOf(given, moment.sample->output);
            force = std::max({force, std::abs(state.normalForce), std::abs(estimate.value)});
        }
    }
    return {siScaleFor(length, "m"), siScaleFor(force, "N")};
}

PageTable momentTable(const Uncertainty& given, const RunEvents& events) {
    const std::vector<Moment> moments = momentsOf(events);
    const auto [length, force] = scalesOf(given, moments);
    PageTable table{.columns = {{"moment"},
                                {"time [s]", true},
                                {"indentation [" + length.unit + "]", true},
                                {"contact radius [" + length.unit + "]", true},
                                {"force, model [" + force.unit + "]", true},
                                {"force, signals [" + force.unit + "]", true}},
                    .rows = {}};
    for (const Moment& moment : moments) {
        if (!moment.sample) {
            continue;
        }
        const TickOutput& out = moment.sample->output;
        table.rows.push_back({{moment.name},
                              {formatted("%.3f", moment.sample->time)},
                              {numberText(out.model.contact.indentation, length)},
                              {numberText(out.model.contact.contactRadius, length)},
                              {numberText(out.model.normalForce, force)},
                              {measuredText(estimateOf(given, out), force)}});
    }
    return table;
}

}  // namespace

void addPictures(PageContent& page, const ReportedRun& run) {
    page.addHeading("Contact and deformation");
    if (run.deformation.empty()) {
        page.addParagraph("The contact model has no contact in this run: no deformation is drawn.");
    } else {
        page.addPicture(
            {run.deformation, "The deformed surface of the sample under the tip",
             "The deformed surface as the contact model has it, colored by displacement."});
    }
    page.addTable(momentTable(run.loaded.scene.description.uncertainty, run.history.events()));
    page.addParagraph(
        "Single ticks, along the normal at the contact. Indentation below zero is a gap, or in "
        "contact the height of a neck above the undeformed surface. Signals: the force estimated "
        "from the lever signals, with one standard deviation by noise, stiffness and calibration.");
}

namespace {

std::string nameOf(const std::optional<RecordedProgram>& program) {
    return program ? "asperity " + program->version + ", compiler " + program->compiler
                   : "the folder of the run does not say";
}

PageTable factTable(const ReportedRun& run) {
    const RunEvents& events = run.history.events();
    return {.columns = {{"quantity"}, {"value"}},
            .rows = {{{"Made by"}, {nameOf(run.program)}},
                     {{"Replayed for this page by"},
                      {"asperity " + versionWithCommit() + ", " + compilerName()}},
                     {{"Length"},
                      {std::to_string(events.ticks) + " ticks, " +
                       formatted("%.3f s", run.history.duration())}},
                     {{"Run"}, {run.folder.string()}}},
            .hasTitles = false};
}

std::vector<std::string> commandsOf(const ReportedRun& run) {
    const std::string folder = shellWord(run.folder.string());
    return {"asperity replay " + folder + " --out AGAIN",
            "asperity report " + folder + " --out REPORT"};
}

std::string lineOf(const HashedFile& file) { return file.sha256 + "  " + file.file; }

void addHashes(PageContent& page, const ReportedRun& run) {
    page.addParagraph("SHA-256, as sha256sum prints and checks it:");
    if (run.bundle) {
        page.addCode({lineOf(*run.bundle)});
        page.addParagraph("Of the files in the bundle " + run.folder.filename().string() +
                          ", in the folder that it is unpacked into:");
    }
    std::vector<std::string> lines;
    lines.reserve(run.hashes.size());
    for (const HashedFile& file : run.hashes) {
        lines.push_back(lineOf(file));
    }
    page.addCode(lines);
}

}  // namespace

void addReproduction(PageContent& page, const ReportedRun& run) {
    const std::string same =
        run.difference.empty()
            ? "All numbers of this page come from a replay of the recorded inputs, which gave each "
              "recorded tick again, bit for bit."
            : "The replay differs from the recorded log: " + run.difference +
                  ". All numbers of this page are those of the replay.";
    page.addHeading("How to reproduce this");
    page.addTable(factTable(run));
    page.addParagraph(same, run.difference.empty() ? PageTone::Plain : PageTone::Fault);
    page.addParagraph(
        "The first command repeats the run and compares every tick, the second makes this page:");
    page.addCode(commandsOf(run));
    addHashes(page, run);
}

std::string shellWord(const std::string& text) {
    constexpr std::string_view kPlain = "/._-+=:,@";
    const bool isPlain = !text.empty() && std::ranges::all_of(text, [&](unsigned char byte) {
        return byte >= 0x80 || std::isalnum(byte) != 0 ||
               kPlain.find(static_cast<char>(byte)) != std::string_view::npos;
    });
    if (isPlain) {
        return text;
    }
    std::string word = "'";
    for (const char byte : text) {
        word += byte == '\'' ? std::string("'\\''") : std::string(1, byte);
    }
    return word + "'";
}

}  // namespace asperity
