#pragma once

namespace asperity::test {

/// How many times as long the same work takes at present as on an idle machine of the kind that
/// limits of time are for; at least 1. Others on the machine slow down its caches and cores, which
/// processor time counts. Takes about 0.3 s.
[[nodiscard]] double machineSlowness();

}  // namespace asperity::test
