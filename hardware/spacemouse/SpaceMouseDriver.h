#pragma once

#include "hardware/driver/DeviceDriver.h"
#include "hardware/hid/HidTransport.h"

namespace asperity {

/// Whether this is a SpaceMouse of 3Dconnexion: by its ids and by a collection for six axes. Their
/// CadMice have ids in between, and receivers have nodes that are keyboards; both are none.
[[nodiscard]] bool isSpaceMouse(const HidDeviceInfo& device);

/// For the SpaceMice of 3Dconnexion.
[[nodiscard]] const DeviceDriver& spaceMouseDriver();

}  // namespace asperity
