#include "core/studies/extremes/ContactExtremes.h"

#include "core/contact/maugis/MaugisTable.h"
#include "core/scene/ContactValidity.h"
#include "core/studies/extremes/ContactDefect.h"
#include "core/studies/extremes/ContactErrors.h"
#include "core/studies/extremes/ContactSetting.h"
#include "core/studies/extremes/ContactStops.h"

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace asperity {

namespace {

const char* sampleName(const ContactSetting& setting) {
    if (setting.filmThickness > 0.0) {
        return "film";
    }
    return setting.pair.workOfAdhesion > 0.0 ? "adhesive" : "no adhesion";
}

ContactLaw referenceLaw(const ContactSetting& setting) {
    return setting.filmThickness > 0.0 ? ContactLaw::HertzFilm : ContactLaw::SphereMaugis;
}

/// Whether a split law's tail makes a state, or its place, that the reference has no like of: where
/// not both touch.
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

    /// What the state of a contender is held against at each stop.
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
        const std::vector<ContactStop> stops = contactStops(referenceModel, setting, grid_.places);
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

}  // namespace

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

}  // namespace asperity
