#pragma once

#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"

#include <functional>
#include <optional>
#include <string>

namespace asperity {

/// How a NanoScope before version 4.3 gives the scale of an image.
struct OldScale {
    double fullScale = 1.0;  ///< value of all counts, 256 to the power of the bytes a pixel
    std::string unit;        ///< SI base unit
    std::string source;      ///< entries of the header that it comes from
};

/// Where a parameter of a header stands: the lists of the scanner, the scan and the controller.
enum class NanoscopeList : std::uint8_t { Scanner, Scan, Controller };
/// The text of a parameter; null when there is none.
using FindInList = std::function<const std::string*(NanoscopeList list, const std::string& key)>;

/// The scale by `Z scale: 440 nm (...)` (version 4.2), or, without it, by the parameters that the
/// kind of the image names, `Z scale height`, `Z max` and `Z sensitivity` of a height.
/// @param image the image's list
/// @return empty when neither is there, or a number of them is missing
[[nodiscard]] std::optional<OldScale> oldNanoscopeScale(const NanoscopeSection& image,
                                                        const FindInList& findInList);

}  // namespace asperity
