#pragma once

#include "core/EnumTable.h"
#include "core/scene/SceneDescription.h"
#include "core/scene/SettingFields.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace asperity {

/// Topic of keys of a scene; those of one are in one section of a file.
enum class SceneGroup : std::uint8_t {
    Sample,
    Shape,
    Material,
    Tip,
    Probe,
    Truth,
    Physics,
    Fidelity,
    Uncertainty,
    Approach,
    View,
};

template <>
inline constexpr auto kEnumTable<SceneGroup> =
    std::to_array<EnumRow<SceneGroup>>({{SceneGroup::Sample, "sample", "Sample"},
                                        {SceneGroup::Shape, "sample", "Shape"},
                                        {SceneGroup::Material, "sample", "Material"},
                                        {SceneGroup::Tip, "tip", "Tip"},
                                        {SceneGroup::Probe, "probe", "Probe"},
                                        {SceneGroup::Truth, "truth", "Truth"},
                                        {SceneGroup::Physics, "physics", "Physics"},
                                        {SceneGroup::Fidelity, "fidelity", "Fidelity"},
                                        {SceneGroup::Uncertainty, "uncertainty", "Uncertainty"},
                                        {SceneGroup::Approach, "approach", "Approach"},
                                        {SceneGroup::View, "view", "View"}});

/// Word in files and panels for what a key leaves to the program.
inline constexpr const char* kLeftOpen = "auto";

/// A number [SI], a switch, or a text: that of a choice is its key.
using SceneValue = std::variant<double, bool, std::string>;

/// Input of a value in a panel.
enum class SceneInput : std::uint8_t {
    Number,
    Whole,   ///< a number without decimals
    Switch,  ///< bool
    Choice,  ///< of a list
    Text,
    File,       ///< a height map: opened, not typed
    Steps,      ///< of leveling, in order: "plane, zero"
    Positions,  ///< of a leveling step [nm]: "10 20, 30 40, 50 10"; entered with the steps
};

/// One of the values that a key can have.
struct SceneChoice {
    std::string key;
    std::string name;  ///< for people
};

/// Words for a key in the window.
struct SceneWords {
    const char* caption;
    const char* toolTip;
    const char* unit = "";  ///< in which it is shown
    double scale = 1.0;     ///< that unit [SI]
};

/// One key of scene files: how people see it, what it may be, and how files and panels read and
/// write it. Those of [haptics] are in listSettings().
struct SceneField {
    SceneGroup group = SceneGroup::Sample;
    const char* key = "";
    SceneWords words;
    Limits limits;  ///< of a number [SI]
    SceneInput input = SceneInput::Number;
    std::vector<SceneChoice> choices = {};
    SceneValue (*get)(const SceneDescription& scene) = nullptr;
    /// Nothing that follows from it goes along, see SceneFieldChange.h.
    void (*set)(SceneDescription& scene, const SceneValue& value) = nullptr;
    /// Returns why a text is no value, after "it must be"; empty: it is one. Null: any text is.
    std::string (*refusal)(const std::string& text) = nullptr;
    /// Returns whether a file states the value that a scene has; null: always.
    bool (*isStated)(const SceneDescription& scene) = nullptr;
    /// True where a file states it in another form than get(), such as a list or a table, or
    /// instead of another key: readers of the section have it.
    bool ownForm = false;
};

/// The one list of the keys of scenes that a panel shows, in its order.
[[nodiscard]] const std::vector<SceneField>& sceneFields();

/// Returns the row of a key, which must be in the list.
[[nodiscard]] const SceneField& sceneField(SceneGroup group, std::string_view key);

/// A number that a user gives in a unit [SI], rounded once: 5 nm are 5e-9 m. @param unit [SI]
[[nodiscard]] double fromUnit(double number, double unit) noexcept;

/// "probe.length_m"
[[nodiscard]] std::string nameOf(const SceneField& field);

}  // namespace asperity
