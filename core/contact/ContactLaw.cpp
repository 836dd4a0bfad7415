#include "core/contact/ContactLaw.h"

namespace asperity {

namespace {

struct LawNames {
    const char* key;
    const char* name;
};

LawNames namesOf(ContactLaw law) noexcept {
    switch (law) {
    case ContactLaw::Hertz:
        return {"hertz", "Hertz"};
    case ContactLaw::Dmt:
        return {"dmt", "DMT"};
    case ContactLaw::Jkr:
        return {"jkr", "JKR"};
    case ContactLaw::Maugis:
        return {"md", "Maugis-Dugdale"};
    case ContactLaw::Sneddon:
        return {"sneddon", "Sneddon's sphere"};
    case ContactLaw::SphereJkr:
        return {"jkr_sphere", "JKR on the exact sphere"};
    case ContactLaw::SphereMaugis:
        return {"md_sphere", "Maugis-Dugdale on the exact sphere"};
    case ContactLaw::Split:
        return {"split", "Maugis-Dugdale with tail"};
    case ContactLaw::SphereSplit:
        return {"split_sphere", "Maugis-Dugdale with tail on the exact sphere"};
    case ContactLaw::HertzFilm:
        return {"hertz_film", "Hertz on a film"};
    }
    return {"unknown", "unknown"};
}

}  // namespace

bool isSphere(ContactLaw law) noexcept {
    return law == ContactLaw::Sneddon || law == ContactLaw::SphereJkr ||
           law == ContactLaw::SphereMaugis || law == ContactLaw::SphereSplit;
}

bool hasTail(ContactLaw law) noexcept {
    return law == ContactLaw::Split || law == ContactLaw::SphereSplit;
}

bool isJkr(ContactLaw law) noexcept {
    return law == ContactLaw::Jkr || law == ContactLaw::SphereJkr;
}

const char* keyOf(ContactLaw law) noexcept { return namesOf(law).key; }

std::optional<ContactLaw> lawFromKey(std::string_view key) noexcept {
    for (const ContactLaw law : kContactLaws) {
        if (key == keyOf(law)) {
            return law;
        }
    }
    return std::nullopt;
}

const char* nameOf(ContactLaw law) noexcept { return namesOf(law).name; }

}  // namespace asperity
