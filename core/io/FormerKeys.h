#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// A key of a file that was renamed: a column of a table, a key of a scene, or the word of a flag.
struct FormerKey {
    std::string_view former;
    std::string_view current;
};

/// All renamed keys that a reader may meet. Only readers use them; writers use the current keys.
inline constexpr auto kFormerKeys = std::to_array<FormerKey>({
    // Scenes
    {"foot_search", "closest_point_search"},
    {"max_hand_speed_m_s", "max_device_speed_m_s"},
    // tick_input.csv, tick_memory.csv
    {"hand_x_m", "device_x_m"},
    {"hand_y_m", "device_y_m"},
    {"hand_z_m", "device_z_m"},
    {"hand_max_force_n", "device_max_force_n"},
    {"hand_streams", "device_streams"},
    {"hand_age_s", "device_age_s"},
    {"hand_turn_x_rad", "device_turn_x_rad"},
    {"hand_turn_y_rad", "device_turn_y_rad"},
    {"hand_turn_z_rad", "device_turn_z_rad"},
    {"feet", "contact_points"},
    {"foot0_x_m", "contact_point0_x_m"},
    {"foot0_y_m", "contact_point0_y_m"},
    {"foot0_valid", "contact_point0_valid"},
    {"foot0_branch", "contact_point0_branch"},
    {"foot0_coordinate", "contact_point0_coordinate"},
    {"foot0_friction_n", "contact_point0_friction_n"},
    {"foot1_x_m", "contact_point1_x_m"},
    {"foot1_y_m", "contact_point1_y_m"},
    {"foot1_valid", "contact_point1_valid"},
    {"foot1_branch", "contact_point1_branch"},
    {"foot1_coordinate", "contact_point1_coordinate"},
    {"foot1_friction_n", "contact_point1_friction_n"},
    {"foot2_x_m", "contact_point2_x_m"},
    {"foot2_y_m", "contact_point2_y_m"},
    {"foot2_valid", "contact_point2_valid"},
    {"foot2_branch", "contact_point2_branch"},
    {"foot2_coordinate", "contact_point2_coordinate"},
    {"foot2_friction_n", "contact_point2_friction_n"},
    {"foot3_x_m", "contact_point3_x_m"},
    {"foot3_y_m", "contact_point3_y_m"},
    {"foot3_valid", "contact_point3_valid"},
    {"foot3_branch", "contact_point3_branch"},
    {"foot3_coordinate", "contact_point3_coordinate"},
    {"foot3_friction_n", "contact_point3_friction_n"},
    // force_log.csv
    {"hand_fx_n", "device_fx_n"},
    {"hand_fy_n", "device_fy_n"},
    {"hand_fz_n", "device_fz_n"},
    // Flags
    {"foot_not_found", "closest_point_not_found"},
    {"several_feet", "several_contact_points"},
    {"feet_unproven", "search_not_exhaustive"},
    // Sessions and settings of the window
    {"window/shown/tool/Touches", "window/shown/tool/Force cycles"},
    {"Touches", "Force cycles"},
});

/// Returns the current name of a renamed key, and any other key as it is.
[[nodiscard]] std::string_view currentKey(std::string_view key) noexcept;

/// Replaces renamed keys, but for those whose current name is in the list, too.
[[nodiscard]] std::vector<std::string> currentKeys(std::vector<std::string> keys);

/// Returns flags as validityText() writes them, with their current words.
[[nodiscard]] std::string currentFlags(std::string_view flags);

}  // namespace asperity
