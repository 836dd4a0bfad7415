#pragma once

#include <QString>

#include <vector>

namespace asperity {

/// Action that a user can do by mouse or keys, for the list of all of them.
struct InputHelp {
    QString input;   ///< "Left drag"
    QString effect;  ///< "moves the tip along the sample"
};

using InputHelps = std::vector<InputHelp>;

}  // namespace asperity
