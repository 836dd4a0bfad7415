#include "core/scene/UncertaintyFields.h"

#include "core/scene/SceneFieldOf.h"

#include <cstddef>
#include <utility>

namespace asperity {

namespace {

constexpr SceneGroup kGroup = SceneGroup::Uncertainty;
constexpr const auto& kRows = kEnumTable<UncertaintyInput>;

template <std::size_t I>
void addRow(std::vector<SceneField>& fields) {
    constexpr const UncertaintyRow& kRow = kRows[I];
    if constexpr (kRow.deviation != nullptr) {
        fields.push_back(scene_field::at(
            kGroup, kRow.key, {kRow.caption, kRow.source, kRow.unit, kRow.scale},
            {0.0, kRow.max, kRow.limits},
            [](auto& scene) -> auto& { return scene.uncertainty.*kRows[I].deviation; }));
    }
}

template <std::size_t... I>
void addRows(std::vector<SceneField>& fields, std::index_sequence<I...> /*rows*/) {
    (addRow<I>(fields), ...);
}

}  // namespace

std::vector<SceneField> uncertaintyFields() {
    std::vector<SceneField> fields{
        scene_field::at<&SceneDescription::uncertainty, &Uncertainty::enabled>(
            kGroup, "enabled",
            {"Stated with results", "Off: results carry the detector's noise alone"}, {})};
    addRows(fields, std::make_index_sequence<kUncertaintyInputCount>());
    fields.push_back(
        scene_field::at<&SceneDescription::uncertainty, &Uncertainty::thermalStiffness>(
            kGroup, "thermal_stiffness",
            {"Stiffness by InvOLS",
             "On: from a thermal spectrum read with the same InvOLS; forces go as 1/InvOLS"},
            {}));
    return fields;
}

}  // namespace asperity
