#include "core/studies/extremes/ContactSetting.h"

#include "core/Error.h"
#include "core/FormattedText.h"

namespace asperity {

namespace {

bool hasTable(ContactLaw law) { return traitsOf(law).table; }

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

}  // namespace asperity
