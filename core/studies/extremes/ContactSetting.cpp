#include "core/studies/extremes/ContactSetting.h"

#include "core/Error.h"
#include "core/FormattedText.h"

namespace asperity {

namespace {

bool hasTiers(ContactLaw law) { return traitsOf(law).table; }

}  // namespace

std::vector<LawTier> lawTiers() {
    std::vector<LawTier> all;
    for (const ContactLaw law : kValues<ContactLaw>) {
        all.push_back({law, SolverTier::Exact});
        if (hasTiers(law)) {
            all.push_back({law, SolverTier::Newton});
            all.push_back({law, SolverTier::Table});
        }
    }
    return all;
}

const char* tierName(const LawTier& lawTier) noexcept {
    return hasTiers(lawTier.law) ? keyOf(lawTier.tier) : "-";
}

std::string describe(const LawTier& lawTier, const ContactSetting& setting, double approach) {
    return formatted(
        "%s (%s), tip radius %.17g m, E* %.17g Pa, w %.17g J/m^2, film %.17g m (Poisson "
        "ratio %.17g), lever %.17g N/m, approach %.17g m",
        keyOf(lawTier.law), tierName(lawTier), setting.pair.tipRadius, setting.pair.reducedModulus,
        setting.pair.workOfAdhesion, setting.filmThickness, setting.filmPoissonRatio,
        setting.leverStiffness, approach);
}

ContactCandidate candidate(const LawTier& lawTier, const ContactSetting& setting) {
    try {
        const ContactOptions options{.cohesiveStress = setting.cohesiveStress,
                                     .filmThickness = setting.filmThickness,
                                     .film = {.poissonRatio = setting.filmPoissonRatio},
                                     .solver = lawTier.tier};
        return {lawTier, ContactModel(lawTier.law, setting.pair, options), ""};
    } catch (const Error& error) {
        return {lawTier, std::nullopt, error.what()};
    }
}

std::string refusalOf(ContactStatus status) { return std::string("contact: ") + nameOf(status); }

}  // namespace asperity
