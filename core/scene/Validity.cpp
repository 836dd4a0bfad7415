#include "core/scene/Validity.h"

namespace asperity {

namespace {

constexpr bool isByBit() {
    for (std::size_t i = 0; i < kValidityFlagCount; ++i) {
        if (static_cast<std::uint64_t>(kValidityTraits.at(i).flag) != std::uint64_t{1} << i) {
            return false;
        }
    }
    return true;
}
static_assert(isByBit());

}  // namespace

std::string validityText(ValidityFlags flags) {
    std::string text;
    for (const ValidityTraits& one : kValidityTraits) {
        if (flags.has(one.flag)) {
            text += (text.empty() ? "" : "|") + std::string(one.key);
        }
    }
    return text.empty() ? "-" : text;
}

}  // namespace asperity
