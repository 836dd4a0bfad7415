#pragma once

#include "app/experiment/ExperimentFolder.h"

namespace asperity {

/// Draws the figures of the paper of what is in the folder, each as PNG and SVG: force against time
/// by task and material (11), mean error (12) and mean time (13) with their intervals.
/// There is a QGuiApplication. @throw Error
void writeStudyFigures(const ExperimentFolder& folder);

}  // namespace asperity
