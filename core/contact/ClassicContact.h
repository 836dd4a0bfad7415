#pragma once

#include "core/contact/Material.h"

namespace asperity {

/// Force of an elastic contact without adhesion [N], 0 for indentation <= 0.
/// Source: Hertz (1882); docs/physics.md 2.1, 2.7.
[[nodiscard]] double hertzForce(const ContactPair& pair, double indentation) noexcept;

/// Its contact radius [m], 0 for indentation <= 0.
[[nodiscard]] double hertzContactRadius(const ContactPair& pair, double indentation) noexcept;

/// Indentation [m] at `approach` = indentation + compliance x force; `approach` itself where the
/// surfaces do not touch. @param compliance of the lever [m/N], >= 0
[[nodiscard]] double hertzIndentation(const ContactPair& pair, double approach,
                                      double compliance) noexcept;

}  // namespace asperity
