#include "core/studies/extremes/RefusedContacts.h"

#include "core/studies/extremes/ContactSetting.h"

#include <limits>

namespace asperity {

namespace {

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
