#pragma once

#include "ui/window/ExportChoices.h"

class QSettings;

namespace asperity {

/// What was chosen of an export last; where nothing was, the usual choices.
[[nodiscard]] ExportChoices keptChoices(const QSettings& settings);
void keepChoices(QSettings& settings, const ExportChoices& choices);

}  // namespace asperity
