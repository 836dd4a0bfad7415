#include "core/fidelity/extremes/ContactExtremes.h"

#include "core/contact/HertzLaw.h"
#include "core/contact/MaugisUnits.h"
#include "core/fidelity/extremes/ContactDefect.h"
#include "core/fidelity/extremes/ContactSetting.h"
#include "core/fidelity/extremes/LogSpaced.h"
#include "core/scene/ContactValidity.h"

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

/// One place of the undeflected tip on its way.
struct Stop {
    double approach = 0.0;  ///< [m]
    bool retract = false;
};

/// From beyond both jumps to three tip radii of indentation and back; inwards of the first touch
/// the lever's base is moved as far as Hertz' force bends the lever.
std::vector<Stop> wayOf(const ContactModel& reference, const ContactSetting& setting, int places) {
    constexpr double kShallowest = 1e-4;  // of the tip radius
    constexpr double kDeepest = 3.0;      // of the tip radius
    constexpr double kNearest = 1e-3;     // of the farthest gap
    const double radius = setting.pair.tipRadius;
    const double compliance = setting.compliance();
    const double farthest = -1.5 * std::max({-reference.pullOffApproach(compliance),
                                             -reference.jumpInApproach(compliance), 0.05 * radius});
    std::vector<Stop> way;
    for (const double gap : logSpaced(farthest, kNearest * farthest, places / 2)) {
        way.push_back({gap, false});
    }
    const HertzLaw hertz(setting.pair);
    for (const double depth :
         logSpaced(kShallowest * radius, kDeepest * radius, places - (places / 2))) {
        way.push_back({depth + (compliance * hertz.atIndentation(depth).force), false});
    }
    for (std::size_t i = way.size(); i-- > 0;) {
        way.push_back({way[i].approach, true});
    }
    return way;
}

/// The states along a way, each with the memory of the one before, as a run has them.
std::vector<ContactState> follow(const ContactModel& model, const std::vector<Stop>& way,
                                 double compliance) {
    std::vector<ContactState> states;
    ContactMemory memory;
    for (const Stop& stop : way) {
        states.push_back(model.equilibrium(stop.approach, compliance, memory));
        memory = states.back().memory();
    }
    return states;
}

/// Against the state of another law or solver; near zero the units of adhesion count.
StateErrors errorsOf(const ContactState& state, const ContactState& reference,
                     const MaugisUnits& units) {
    return {.force = relativeError(state.force, reference.force, units.force),
            .contactRadius =
                relativeError(state.contactRadius, reference.contactRadius, units.radius)};
}

/// What a state is held against.
struct Yardstick {
    ContactState exact;      ///< of the same law, solved afresh
    ContactState reference;  ///< of the reference law
};

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
    [[nodiscard]] std::vector<ContactCandidate> under(const ContactSetting& setting) {
        std::vector<ContactCandidate> all;
        for (const LawTier& lawTier : lawTiers()) {
            if (lawTier.law == ContactLaw::HertzFilm && setting.filmThickness == 0.0) {
                continue;  // refusedContacts() has it
            }
            all.push_back(lawTier.tier == SolverTier::Table ? tabulated(lawTier, setting)
                                                            : candidate(lawTier, setting));
        }
        return all;
    }

private:
    ContactCandidate tabulated(const LawTier& lawTier, const ContactSetting& setting) {
        constexpr double kReach = 9.9;  // a table's range of radii to either side is 10
        std::optional<ContactModel>& built = built_[lawTier.law];
        if (!built || setting.pair.tipRadius > kReach * built->pair().tipRadius) {
            ContactSetting middle = setting;
            middle.pair.tipRadius *= kReach;
            built = candidate(lawTier, middle).model;
        }
        return {lawTier, built->withTipRadius(setting.pair.tipRadius), ""};
    }

    std::map<ContactLaw, std::optional<ContactModel>> built_;
};

class ContactStudy {
public:
    explicit ContactStudy(const ContactGrid& grid) : grid_(grid) {}

    /// One sample under all tips and levers.
    [[nodiscard]] ExtremesFindings run(ContactSetting setting) {
        Candidates candidates;
        for (const double radius : grid_.tipRadii) {
            setting.pair.tipRadius = radius;
            meet(candidates.under(setting), setting);
        }
        return std::move(findings_);
    }

private:
    /// A law with what became of its states under the present tip.
    struct Contender {
        LawTier lawTier;
        ContactModel model;
        ExtremesRegion region;
    };

    static std::vector<Contender> contendersOf(const std::vector<ContactCandidate>& candidates,
                                               const ContactSetting& setting) {
        std::vector<Contender> contenders;
        for (const ContactCandidate& one : candidates) {
            contenders.push_back({one.lawTier, one.model.value(),
                                  ExtremesRegion({.model = keyOf(one.lawTier.law),
                                                  .tier = tierName(one.lawTier),
                                                  .sample = sampleName(setting),
                                                  .tipRadius = setting.pair.tipRadius,
                                                  .modulus = setting.pair.reducedModulus})});
        }
        return contenders;
    }

    void meet(const std::vector<ContactCandidate>& candidates, ContactSetting setting) {
        const bool film = setting.filmThickness > 0.0;
        const auto reference = candidate(
            {film ? ContactLaw::HertzFilm : ContactLaw::SphereMaugis, SolverTier::Exact}, setting);
        std::vector<Contender> contenders = contendersOf(candidates, setting);
        for (const double stiffness : grid_.leverStiffnesses) {
            setting.leverStiffness = stiffness;
            compareAll(contenders, reference.model.value(), setting);
        }
        for (Contender& contender : contenders) {
            findings_.regions.push_back(std::move(contender.region));
        }
    }

    void compareAll(std::vector<Contender>& contenders, const ContactModel& reference,
                    const ContactSetting& setting) {
        const std::vector<Stop> way = wayOf(reference, setting, grid_.places);
        const auto references = follow(reference, way, setting.compliance());
        std::vector<ContactState> exact;
        for (Contender& contender : contenders) {
            const auto states = follow(contender.model, way, setting.compliance());
            if (contender.lawTier.tier == SolverTier::Exact) {
                exact = states;
            }
            for (std::size_t i = 0; i < way.size(); ++i) {
                judge(contender, setting, way[i], states[i], {exact[i], references[i]});
            }
        }
    }

    void judge(Contender& by, const ContactSetting& setting, const Stop& stop,
               const ContactState& state, const Yardstick& yardstick) {
        const auto sayWhere = [&] {
            return describe(by.lawTier, setting, stop.approach) +
                   (stop.retract ? " on the way out" : " on the way in");
        };
        if (!state.solved()) {
            by.region.refuse(refusalOf(state.status));
            return;
        }
        const ValidityFlags flags =
            contactValidity(by.model, state, {.filmThickness = setting.filmThickness});
        const MaugisUnits units = maugisUnits(setting.pair);
        const bool own = by.lawTier.law == ContactLaw::Split && setting.pair.workOfAdhesion > 0.0 &&
                         !flags.has(Validity::LargeContact);
        StateErrors errors = errorsOf(state, own ? yardstick.exact : yardstick.reference, units);
        errors.solver = errorsOf(state, yardstick.exact, units).larger();
        if (const char* defect = defectOf(state, setting, stop.approach)) {
            findings_.addDefect(sayWhere() + ": " + defect);
        } else if (errors.solver > promiseOf(by.model)) {
            findings_.addDefect(sayWhere() + ": the solver is farther off than it promises");
        } else {
            by.region.add(flags, errors, sayWhere);
        }
    }

    const ContactGrid& grid_;
    ExtremesFindings findings_;
};

}  // namespace

std::vector<FlatSample> samplesOf(const ContactGrid& grid) {
    std::vector<FlatSample> samples;
    for (const double modulus : grid.moduli) {
        for (const double thickness : grid.filmThicknesses) {
            samples.push_back({.modulus = modulus, .filmThickness = thickness});
        }
        for (const double adhesion : grid.adhesions) {
            samples.push_back({.modulus = modulus, .adhesion = adhesion});
        }
    }
    return samples;
}

ExtremesFindings contactExtremes(const ContactGrid& grid, const FlatSample& sample) {
    return ContactStudy(grid).run(
        {.pair = {.reducedModulus = sample.modulus, .workOfAdhesion = sample.adhesion},
         .filmThickness = sample.filmThickness});
}

}  // namespace asperity
