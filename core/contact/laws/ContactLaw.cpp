#include "core/contact/laws/ContactLaw.h"

#include <algorithm>

namespace asperity {

namespace {

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kLawTraits.size(); ++i) {
        if (static_cast<std::size_t>(kLawTraits.at(i).law) != i) {
            return false;
        }
    }
    return true;
}
static_assert(isInOrder());

template <class Fits>
std::optional<ContactLaw> lawWhere(const Fits& fits) noexcept {
    const auto* const found = std::ranges::find_if(kLawTraits, fits);
    return found != kLawTraits.end() ? std::optional(found->law) : std::nullopt;
}

}  // namespace

std::optional<ContactLaw> lawFromKey(std::string_view key) noexcept {
    return lawWhere([key](const LawTraits& one) { return key == one.key; });
}

std::optional<ContactLaw> lawLike(ContactLaw law, bool sphere, bool tail) noexcept {
    return lawWhere([like = traitsOf(law), sphere, tail](const LawTraits& one) {
        return one.attraction == like.attraction && one.film == like.film && one.sphere == sphere &&
               one.tail == tail;
    });
}

}  // namespace asperity
