#pragma once

#include <string>

namespace asperity {

struct Scene;

/// What holds for every scan: the contact of a tip with it counts the imaging tip a second time.
inline constexpr const char* kScanHoldsItsTip =
    "the heights hold the shape of the tip that recorded them: bumps are wider, and hollows "
    "narrower and shallower, than on the sample";

/// One sentence on what is known of the tip that recorded the scene's scan, and what was done
/// about its shape.
[[nodiscard]] std::string imagingTipNote(const Scene& scene);

/// The same in a few words.
[[nodiscard]] std::string imagingTipWords(const Scene& scene);

}  // namespace asperity
