#pragma once

#include "app/loading/ScanPreview.h"
#include "ui/window/OpenPreview.h"

namespace asperity {

/// A preview in words and pictures. Any thread.
[[nodiscard]] OpenPreview shownPreview(const ScanPreview& preview);

}  // namespace asperity
