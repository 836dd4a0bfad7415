#pragma once

#include <cstddef>
#include <variant>

namespace asperity {

/// Calls `visitor` with what a variant holds, as std::visit does, but can never throw: a variant of
/// types that copy without throwing always holds something.
template <std::size_t First = 0, class Visitor, class... Alternatives>
auto onAlternative(const Visitor& visitor, const std::variant<Alternatives...>& variant) noexcept {
    if constexpr (First + 1 < sizeof...(Alternatives)) {
        if (variant.index() != First) {
            return onAlternative<First + 1>(visitor, variant);
        }
    }
    return visitor(*std::get_if<First>(&variant));
}

}  // namespace asperity
