#pragma once

#include "core/studies/extremes/ExtremesStudy.h"

namespace asperity {

/// Every law at parameters that no instrument has: all must be refused.
[[nodiscard]] ExtremesFindings refusedContacts();

}  // namespace asperity
