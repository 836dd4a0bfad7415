#include "core/studies/extremes/ContactExtremes.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/contact/laws/HertzLaw.h"
#include "core/contact/maugis/MaugisTable.h"
#include "core/scene/TipValidity.h"
#include "core/studies/extremes/ExtremesGrid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace asperity {

namespace {

bool hasTable(ContactLaw law) { return traitsOf(law).table; }

const char* sampleName(const ContactSetting& setting) {
    if (setting.filmThickness > 0.0) {
        return "film";
    }
    return setting.pair.workOfAdhesion > 0.0 ? "adhesive" : "no adhesion";
}

ContactLaw referenceLaw(const ContactSetting& setting) {
    return setting.filmThickness > 0.0 ? ContactLaw::HertzFilm : ContactLaw::SphereMaugis;
}

/// Returns whether a split law's tail makes a state, or its position, that the reference has no
/// like of: where not both touch.
bool isOfTail(const ContactModel& model, const ContactState& state, const ContactState& reference) {
    const bool bothTouch = state.contactRadius > 0.0 && reference.contactRadius > 0.0;
    return hasTail(model.law()) && model.lambda() > 0.0 && !bothTouch;
}

/// Largest relative error that a solver may have: rounding, or what the table says of itself.
double promiseOf(const ContactModel& model) {
    constexpr double kRounding = 1e-11;
    return model.table() != nullptr ? model.table()->errorBound() : kRounding;
}

/// Candidates for one sample under ever larger tips. A table takes time to build and covers
/// effective radii around the one that it is built for, as those of a run: one serves as many tips
/// as it can.
class Candidates {
public:
    [[nodiscard]] std::vector<ContactCandidate> under(const ContactSetting& setting,
                                                      const CancelCheck& check) {
        std::vector<ContactCandidate> all;
        for (const LawOption& lawOption : lawOptions()) {
            check();
            if (isFilm(lawOption.law) && setting.filmThickness == 0.0) {
                continue;  // refusedContacts() has it
            }
            all.push_back(lawOption.solver == SolverSetting::Table ? tabulated(lawOption, setting)
                                                                   : candidate(lawOption, setting));
        }
        return all;
    }

private:
    ContactCandidate tabulated(const LawOption& lawOption, const ContactSetting& setting) {
        constexpr double kReach = 9.9;  // a table's range of radii to either side is 10
        std::optional<ContactModel>& built = built_[lawOption.law];
        if (!built || setting.pair.tipRadius > kReach * built->pair().tipRadius) {
            ContactSetting middle = setting;
            middle.pair.tipRadius *= kReach;
            built = candidate(lawOption, middle).model;
        }
        return {lawOption, built->withTipRadius(setting.pair.tipRadius), ""};
    }

    std::map<ContactLaw, std::optional<ContactModel>> built_;
};

class ContactStudy {
public:
    ContactStudy(const ContactGrid& grid, const CancelCheck& check) : grid_(grid), check_(check) {}

    /// One sample under all tips and levers.
    [[nodiscard]] ExtremesFindings run(ContactSetting setting) {
        Candidates candidates;
        for (const double radius : grid_.tipRadii) {
            setting.pair.tipRadius = radius;
            meet(candidates.under(setting, check_), setting);
        }
        return std::move(findings_);
    }

private:
    /// A law with what became of its states under the present tip.
    struct Contender {
        LawOption lawOption;
        ContactModel model;
        ExtremesRegion region;
    };

    /// Reference for a contender's state at each stop.
    struct Yardstick {
        const std::vector<ContactStop>& stops;
        const ContactCourse& exact;      ///< of the same law, solved afresh
        const ContactCourse& reference;  ///< of the reference law
        const ContactModel& referenceModel;
    };

    static std::vector<Contender> contendersOf(const std::vector<ContactCandidate>& candidates,
                                               const ContactSetting& setting) {
        std::vector<Contender> contenders;
        for (const ContactCandidate& one : candidates) {
            contenders.push_back({one.lawOption, one.model.value(),
                                  ExtremesRegion({.model = keyOf(one.lawOption.law),
                                                  .setting = solverName(one.lawOption),
                                                  .sample = sampleName(setting),
                                                  .tipRadius = setting.pair.tipRadius,
                                                  .modulus = setting.pair.reducedModulus})});
        }
        return contenders;
    }

    void meet(const std::vector<ContactCandidate>& candidates, ContactSetting setting) {
        std::vector<Contender> contenders = contendersOf(candidates, setting);
        for (const double stiffness : grid_.leverStiffnesses) {
            setting.leverStiffness = stiffness;
            compareAll(contenders, setting);
        }
        for (Contender& contender : contenders) {
            findings_.regions.push_back(std::move(contender.region));
        }
    }

    static std::size_t indexOf(const std::vector<Contender>& contenders, ContactLaw law) {
        return static_cast<std::size_t>(
            std::ranges::find(contenders, law,
                              [](const Contender& one) { return one.lawOption.law; }) -
            contenders.begin());
    }

    void compareAll(std::vector<Contender>& contenders, const ContactSetting& setting) {
        const std::size_t reference = indexOf(contenders, referenceLaw(setting));
        const ContactModel& referenceModel = contenders[reference].model;
        const std::vector<ContactStop> stops = contactStops(referenceModel, setting, grid_.stops);
        findings_.states += static_cast<long>(stops.size());
        std::vector<ContactCourse> courses;
        for (const Contender& contender : contenders) {
            check_();
            courses.push_back(contactCourse(contender.model, stops, setting.compliance()));
        }
        for (std::size_t k = 0; k < contenders.size(); ++k) {
            const std::size_t exact = indexOf(contenders, contenders[k].lawOption.law);
            const Yardstick yardstick{stops, courses[exact], courses[reference], referenceModel};
            for (std::size_t i = 0; i < stops.size(); ++i) {
                judge(contenders[k], setting, courses[k], yardstick, i);
            }
        }
    }

    void judge(Contender& by, const ContactSetting& setting, const ContactCourse& course,
               const Yardstick& yardstick, std::size_t i) {
        const ContactStop& stop = yardstick.stops[i];
        const auto sayWhere = [&] {
            return describe(by.lawOption, setting, stop.approach) +
                   (stop.retract ? " on retract" : " on approach");
        };
        const ContactState& state = course.states[i];
        if (!state.solved()) {
            by.region.refuse(refusalOf(state.status));
            return;
        }
        const ComparedState compared = compare(by, setting, course, yardstick, i);
        if (const char* defect = defectOf(state, setting, stop.approach)) {
            findings_.addDefect(sayWhere() + ": " + defect);
        } else if (compared.errors.solver > promiseOf(by.model)) {
            findings_.addDefect(sayWhere() + ": the solver's error exceeds its bound");
        } else {
            by.region.add(compared, sayWhere);
        }
    }

    static ComparedState compare(const Contender& by, const ContactSetting& setting,
                                 const ContactCourse& course, const Yardstick& yardstick,
                                 std::size_t i) {
        // It never yields: the study is of the laws, which know no strength.
        const SampleMaterial sample{.yields = false, .filmThickness = setting.filmThickness};
        const MaugisUnits units = maugisUnits(setting.pair);
        const ContactState& reference = yardstick.reference.states[i];
        ComparedState compared{
            .flags = contactValidity(by.model, course.states[i], sample),
            .referenceHolds =
                contactValidity(yardstick.referenceModel, reference, sample).bits() == 0 &&
                !isOfTail(by.model, course.states[i], reference),
            .errors = contactErrors(course, yardstick.reference, yardstick.stops, i, units)};
        compared.errors.solver =
            stateErrors(course.states[i], yardstick.exact.states[i], units).largest();
        return compared;
    }

    const ContactGrid& grid_;
    const CancelCheck& check_;
    ExtremesFindings findings_;
};

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr ContactPair kGood{.tipRadius = 15e-9, .reducedModulus = 2e9, .workOfAdhesion = 0.05};

struct Request {
    ContactSetting setting;
    double approach = 0.0;  ///< [m]
};

std::vector<Request> requestsOf(ContactLaw law) {
    const double film = isFilm(law) ? 1e-6 : 0.0;  // a good one
    std::vector<Request> requests{{{.pair = kGood, .filmThickness = 10.0}},
                                  {{.pair = kGood, .filmThickness = film, .cohesiveStress = 1e20}}};
    if (isFilm(law)) {
        requests.push_back({{.pair = kGood}});
    }
    for (const double radius : {1e-13, 10.0, kNan}) {
        requests.push_back({{{radius, kGood.reducedModulus, kGood.workOfAdhesion}, film}});
    }
    for (const double modulus : {1e-3, 1e17, kNan}) {
        requests.push_back({{{kGood.tipRadius, modulus, kGood.workOfAdhesion}, film}});
    }
    for (const double work : {-0.05, 1e5, kNan}) {
        requests.push_back({{{kGood.tipRadius, kGood.reducedModulus, work}, film}});
    }
    for (const double stiffness : {1e-7, -1.0, kNan}) {
        requests.push_back({{kGood, film, stiffness}});
    }
    for (const double approach : {1e4, kNan}) {
        requests.push_back({{kGood, film}, approach});
    }
    return requests;
}

}  // namespace

std::vector<LawOption> lawOptions() {
    std::vector<LawOption> all;
    for (const ContactLaw law : kValues<ContactLaw>) {
        all.push_back({law, SolverSetting::Exact});
        if (hasTable(law)) {
            all.push_back({law, SolverSetting::Newton});
            all.push_back({law, SolverSetting::Table});
        }
    }
    return all;
}

const char* solverName(const LawOption& lawOption) noexcept {
    return hasTable(lawOption.law) ? keyOf(lawOption.solver) : "-";
}

std::string describe(const LawOption& lawOption, const ContactSetting& setting, double approach) {
    return formatted(
        "%s (%s), tip radius %.17g m, E* %.17g Pa, w %.17g J/m^2, film %.17g m (Poisson "
        "ratio %.17g), lever %.17g N/m, approach %.17g m",
        keyOf(lawOption.law), solverName(lawOption), setting.pair.tipRadius,
        setting.pair.reducedModulus, setting.pair.workOfAdhesion, setting.filmThickness,
        setting.filmPoissonRatio, setting.leverStiffness, approach);
}

ContactCandidate candidate(const LawOption& lawOption, const ContactSetting& setting) {
    try {
        const ContactOptions options{.cohesiveStress = setting.cohesiveStress,
                                     .filmThickness = setting.filmThickness,
                                     .film = {.poissonRatio = setting.filmPoissonRatio},
                                     .solver = lawOption.solver};
        return {lawOption, ContactModel(lawOption.law, setting.pair, options), ""};
    } catch (const Error& error) {
        return {lawOption, std::nullopt, error.what()};
    }
}

std::string refusalOf(ContactStatus status) { return std::string("contact: ") + nameOf(status); }

std::vector<ContactStop> contactStops(const ContactModel& reference, const ContactSetting& setting,
                                      int positions) {
    constexpr double kMinDepth = 1e-4;  // of the tip radius
    constexpr double kMaxDepth = 3.0;   // of the tip radius
    constexpr double kMinGap = 1e-3;    // of the farthest gap
    const double radius = setting.pair.tipRadius;
    const double compliance = setting.compliance();
    const double farthest = -1.5 * std::max({-reference.pullOffApproach(compliance),
                                             -reference.jumpInApproach(compliance), 0.05 * radius});
    std::vector<ContactStop> stops;
    for (const double gap : logSpaced(farthest, kMinGap * farthest, positions / 2)) {
        stops.push_back({gap, false});
    }
    const HertzLaw hertz(setting.pair);
    for (const double depth :
         logSpaced(kMinDepth * radius, kMaxDepth * radius, positions - (positions / 2))) {
        stops.push_back({depth + (compliance * hertz.atIndentation(depth).force), false});
    }
    for (std::size_t i = stops.size(); i-- > 0;) {
        stops.push_back({stops[i].approach, true});
    }
    return stops;
}

ContactCourse contactCourse(const ContactModel& model, const std::vector<ContactStop>& stops,
                            double compliance) {
    ContactCourse course{.jumpIn = model.jumpInApproach(compliance),
                         .pullOff = model.pullOffApproach(compliance)};
    ContactMemory memory;
    for (const ContactStop& stop : stops) {
        course.states.push_back(model.equilibrium(stop.approach, compliance, memory));
        memory = course.states.back().memory();
    }
    return course;
}

std::vector<FlatSample> samplesOf(const ContactGrid& grid) {
    std::vector<FlatSample> samples;
    for (const double modulus : grid.moduli) {
        for (const Film& film : grid.films) {
            samples.push_back({.modulus = modulus, .film = film});
        }
        for (const double adhesion : grid.adhesions) {
            samples.push_back({.modulus = modulus, .adhesion = adhesion});
        }
    }
    return samples;
}

ExtremesFindings contactExtremes(const ContactGrid& grid, const FlatSample& sample,
                                 const CancelCheck& check) {
    return ContactStudy(grid, check)
        .run({.pair = {.reducedModulus = sample.modulus, .workOfAdhesion = sample.adhesion},
              .filmThickness = sample.film.thickness,
              .filmPoissonRatio = sample.film.poissonRatio});
}

const char* defectOf(const ContactState& state, const ContactSetting& setting,
                     double approach) noexcept {
    constexpr double kRounding = 1e-9;
    for (const double value : {state.force, state.indentation, state.contactRadius,
                               state.cohesiveRadius, state.stiffness, state.energyLost}) {
        if (!std::isfinite(value)) {
            return "a value is not finite";
        }
    }
    if (state.contactRadius < 0.0 || state.energyLost < 0.0 ||
        state.cohesiveRadius < state.contactRadius * (1.0 - kRounding)) {
        return "a radius or an energy is impossible";
    }
    // Indentation and force are Hertz' less what adhesion takes: that is how large rounding sees
    // them.
    const LawPoint hertz = HertzLaw(setting.pair).atContactRadius(state.contactRadius);
    const double compliance = setting.compliance();
    const double bent = compliance * state.force;
    const double size = std::abs(state.indentation) + std::abs(bent) + std::abs(approach) +
                        hertz.indentation + (compliance * hertz.force);
    const bool balanced = std::abs(state.indentation + bent - approach) <= kRounding * size;
    return balanced ? nullptr : "lever and sample are not in balance";
}

StateErrors stateErrors(const ContactState& state, const ContactState& reference,
                        const MaugisUnits& units) noexcept {
    return {.force = relativeError(state.force, reference.force, units.force),
            .contactRadius =
                relativeError(state.contactRadius, reference.contactRadius, units.radius)};
}

StateErrors contactErrors(const ContactCourse& course, const ContactCourse& other,
                          const std::vector<ContactStop>& stops, std::size_t index,
                          const MaugisUnits& units) noexcept {
    const ContactState& state = course.states[index];
    const ContactState& reference = other.states[index];
    if (state.branch == reference.branch) {
        return stateErrors(state, reference, units);
    }
    return {.jump = stops[index].retract ? relativeError(course.pullOff, other.pullOff, 0.0)
                                         : relativeError(course.jumpIn, other.jumpIn, 0.0)};
}

ExtremesFindings refusedContacts() {
    ExtremesFindings findings;
    for (const ContactLaw law : kValues<ContactLaw>) {
        const LawOption lawOption{law, SolverSetting::Exact};  // no solver is asked
        ExtremesRegion region({.model = keyOf(law), .setting = "-", .sample = "out of range"});
        for (const auto& [setting, approach] : requestsOf(law)) {
            const ContactCandidate asked = candidate(lawOption, setting);
            const double compliance = setting.compliance();
            if (!asked.model) {
                region.refuse(asked.refusal);
            } else if (const auto state = asked.model->equilibrium(approach, compliance, {});
                       !state.solved()) {
                region.refuse(refusalOf(state.status));
            } else {
                findings.addDefect(describe(lawOption, setting, approach) +
                                   ": no instrument has this, and it was not refused");
            }
        }
        findings.regions.push_back(std::move(region));
    }
    return findings;
}

}  // namespace asperity
