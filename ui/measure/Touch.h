#pragma once

#include "core/haptics/cycle/ContactCycle.h"

#include <QString>

namespace asperity {

/// One touch of the tip: what its cycle shows, and of which sample.
struct Touch {
    ContactCycle cycle;
    QString material;
    QString scan;  ///< name of the file or shape
};

}  // namespace asperity
