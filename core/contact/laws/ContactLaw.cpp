#include "core/contact/laws/ContactLaw.h"

namespace asperity {

namespace {

constexpr bool isInOrder() {
    for (std::size_t i = 0; i < kValues<ContactLaw>.size(); ++i) {
        if (static_cast<std::size_t>(kValues<ContactLaw>[i]) != i) {
            return false;
        }
    }
    return true;
}
static_assert(isInOrder());

}  // namespace

std::optional<ContactLaw> lawLike(ContactLaw law, bool sphere, bool tail) noexcept {
    const LawTraits& like = traitsOf(law);
    for (const LawTraits& one : kEnumTable<ContactLaw>) {
        if (one.attraction == like.attraction && one.film == like.film && one.sphere == sphere &&
            one.tail == tail) {
            return one.value;
        }
    }
    return std::nullopt;
}

}  // namespace asperity
