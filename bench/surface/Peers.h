#pragma once

#include "bench/surface/SearchMethod.h"
#include "core/surface/BSplineSurface.h"

#include <memory>
#include <string>
#include <vector>

namespace asperity {

/// The other programs' closest points that this benchmark was built with (tools/peers.txt).
[[nodiscard]] std::vector<std::unique_ptr<SearchMethod>> peerMethods(const BSplineSurface& surface);

/// Names of those that were not found when it was built.
[[nodiscard]] std::vector<std::string> missingPeers();

/// One for each peer; only those that were found are compiled.
[[nodiscard]] std::unique_ptr<SearchMethod> openCascadeMethod(const BSplineSurface& surface);
[[nodiscard]] std::unique_ptr<SearchMethod> openCascadeWindowMethod(const BSplineSurface& surface);
[[nodiscard]] std::unique_ptr<SearchMethod> sislMethod(const BSplineSurface& surface);
[[nodiscard]] std::unique_ptr<SearchMethod> embreeMethod(const BSplineSurface& surface);
[[nodiscard]] std::unique_ptr<SearchMethod> cgalMethod(const BSplineSurface& surface);
[[nodiscard]] std::unique_ptr<SearchMethod> vtkMethod(const BSplineSurface& surface);

}  // namespace asperity
