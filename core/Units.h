#pragma once

namespace asperity {

/// Literals for the units that a microscopist writes; every one yields an SI double.
inline namespace units {

// NOLINTBEGIN(google-runtime-int): a user-defined literal takes exactly these types
#define ASPERITY_UNIT(suffix, factor)                                                              \
    constexpr double operator""_##suffix(long double value) {                                      \
        return static_cast<double>(value * (factor));                                              \
    }                                                                                              \
    constexpr double operator""_##suffix(unsigned long long value) {                               \
        return static_cast<double>(static_cast<long double>(value) * (factor));                    \
    }

ASPERITY_UNIT(um, 1e-6L)   // m
ASPERITY_UNIT(nm, 1e-9L)   // m
ASPERITY_UNIT(pm, 1e-12L)  // m
ASPERITY_UNIT(uN, 1e-6L)   // N
ASPERITY_UNIT(nN, 1e-9L)   // N
ASPERITY_UNIT(pN, 1e-12L)  // N
ASPERITY_UNIT(GPa, 1e9L)   // Pa
ASPERITY_UNIT(MPa, 1e6L)   // Pa
ASPERITY_UNIT(kPa, 1e3L)   // Pa
ASPERITY_UNIT(ms, 1e-3L)   // s
ASPERITY_UNIT(us, 1e-6L)   // s

#undef ASPERITY_UNIT
// NOLINTEND(google-runtime-int)

}  // namespace units

}  // namespace asperity
