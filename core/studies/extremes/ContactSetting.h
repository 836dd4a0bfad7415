#pragma once

#include "core/contact/laws/ContactModel.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// A contact law and how it is solved.
struct LawTier {
    ContactLaw law = ContactLaw::Hertz;
    SolverTier tier = SolverTier::Exact;
};

/// Every law, first solved afresh; the other tiers where they are anything else.
[[nodiscard]] std::vector<LawTier> lawTiers();

/// "exact", "newton", "table", as scene files call them; "-" where all are the same.
[[nodiscard]] const char* tierName(const LawTier& lawTier) noexcept;

/// Sample, tip and lever that a law is asked about.
struct ContactSetting {
    ContactPair pair;
    double filmThickness = 0.0;   ///< [m]; 0: a half-space
    double leverStiffness = 1.0;  ///< [N/m]; infinite: displacement control
    double cohesiveStress = 0.0;  ///< [Pa]; 0: as ContactOptions has it
    double filmPoissonRatio = 0.5;

    [[nodiscard]] double compliance() const noexcept { return 1.0 / leverStiffness; }
};

/// All of it with 17 digits, so that the state can be repeated.
[[nodiscard]] std::string describe(const LawTier& lawTier, const ContactSetting& setting,
                                   double approach);

/// A model, or why there is none.
struct ContactCandidate {
    LawTier lawTier;
    std::optional<ContactModel> model;
    std::string refusal;
};

[[nodiscard]] ContactCandidate candidate(const LawTier& lawTier, const ContactSetting& setting);

/// Why a state was refused, for people. @param status not Solved
[[nodiscard]] std::string refusalOf(ContactStatus status);

}  // namespace asperity
