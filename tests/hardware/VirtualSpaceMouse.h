#pragma once

#include "tests/hardware/VirtualHid.h"

namespace asperity::test {

/// A SpaceMouse Compact.
class VirtualSpaceMouse : public VirtualHid {
public:
    VirtualSpaceMouse();
};

}  // namespace asperity::test
