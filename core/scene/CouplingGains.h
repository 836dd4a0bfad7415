#pragma once

namespace asperity {

/// A spring and a damper between the device and a massless proxy, and the proxy's own damper to the
/// ground; the same along every axis, in the device's frame and units. Source: docs/haptics.md.
struct CouplingGains {
    double stiffness = 0.0;     ///< Kc [N/m]; 0: no coupling, the device is the proxy
    double damping = 0.0;       ///< Bc, of device against proxy [N s/m]
    double proxyDamping = 0.0;  ///< bp, of the proxy against the ground: drag in free air [N s/m]

    [[nodiscard]] bool couples() const noexcept { return stiffness > 0.0; }

    bool operator==(const CouplingGains&) const = default;
};

}  // namespace asperity
