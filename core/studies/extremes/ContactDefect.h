#pragma once

#include "core/contact/ContactState.h"
#include "core/studies/extremes/ContactSetting.h"

namespace asperity {

/// What no solved state may have: "a value is not finite", "lever and sample are not in balance";
/// null where all is well. @param approach of the undeflected tip [m]
[[nodiscard]] const char* defectOf(const ContactState& state, const ContactSetting& setting,
                                   double approach) noexcept;

}  // namespace asperity
