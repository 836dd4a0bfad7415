#pragma once

#include "core/contact/laws/ContactModel.h"
#include "core/probe/TipEquilibrium.h"
#include "core/scene/Settings.h"
#include "core/scene/TickOutput.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace asperity::stored {

/// Whether a number is a whole one from `least` to `largest`.
inline bool isWhole(double number, double least, double largest) {
    return number >= least && number <= largest && number == std::floor(number);
}

/// Whether a number in a table stands for a value of the type of `Value`: tables hold numbers only.
template <typename Value>
bool standsFor(double number) {
    if constexpr (std::is_same_v<Value, double>) {
        return std::isfinite(number);
    } else if constexpr (std::is_same_v<Value, bool>) {
        return isWhole(number, 0.0, 1.0);
    } else if constexpr (std::is_same_v<Value, ContactBranch>) {
        return isWhole(number, 0.0, static_cast<double>(ContactBranch::Bonded));
    } else if constexpr (HasEnumTable<Value>) {
        return std::ranges::any_of(
            kValues<Value>, [number](Value value) { return number == static_cast<double>(value); });
    } else if constexpr (std::is_same_v<Value, std::size_t>) {
        return isWhole(number, 0.0, static_cast<double>(kMaxContactPoints));
    } else if constexpr (std::is_same_v<Value, int>) {
        return isWhole(number, kNoButton, kLastButton);
    } else {
        static_assert(std::is_same_v<Value, std::uint32_t>);
        return isWhole(number, 0.0, std::numeric_limits<std::uint32_t>::max());
    }
}

}  // namespace asperity::stored
