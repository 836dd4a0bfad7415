#include "core/io/recording/SettingsColumns.h"

#include "core/Error.h"
#include "core/io/recording/StoredValue.h"

#include <cmath>

namespace asperity {

namespace {

/// Whether every recording has a column.
enum class Column { Always, Later };

template <typename Fixture, typename Visitor>
void visitGuide(Fixture& guide, const Visitor& number) {
    number("guide", guide.kind, Column::Later);
    number("guide_x_m", guide.point.x(), Column::Later);
    number("guide_y_m", guide.point.y(), Column::Later);
    number("guide_z_m", guide.point.z(), Column::Later);
    number("guide_axis_x", guide.axis.x(), Column::Later);
    number("guide_axis_y", guide.axis.y(), Column::Later);
    number("guide_axis_z", guide.axis.z(), Column::Later);
    number("guide_stiffness_n_m", guide.stiffness, Column::Later);
    number("guide_damping_n_s_m", guide.damping, Column::Later);
    number("guide_force_limit_n", guide.forceLimit, Column::Later);
    number("guide_capture_m", guide.captureDistance, Column::Later);
}

template <typename Workspace, typename Visitor>
void visitWorkspace(Workspace& workspace, const Visitor& number) {
    number("workspace_x_m", workspace.centre.x(), Column::Later);
    number("workspace_y_m", workspace.centre.y(), Column::Later);
    number("workspace_z_m", workspace.centre.z(), Column::Later);
    number("workspace_radius_m", workspace.radius, Column::Later);
    number("workspace_free_share", workspace.freeShare, Column::Later);
    number("edge_stiffness_n_m", workspace.stiffness, Column::Later);
    number("edge_force_limit_n", workspace.forceLimit, Column::Later);
}

/// Calls `number(name, value, column)` for every knob: the one list of them.
template <typename Knobs, typename Visitor>
void visit(Knobs& settings, const Visitor& number) {
    number("position_gain", settings.positionGain, Column::Always);
    number("force_gain", settings.forceGain, Column::Always);
    number("correction_hz", settings.correctionBandwidth, Column::Always);
    number("tip_control", settings.positionControl, Column::Always);
    number("forces_on", settings.forcesOn, Column::Always);
    number("rearms", settings.rearms, Column::Always);
    number("coupling_stiffness_n_m", settings.coupling.stiffness, Column::Later);
    number("coupling_damping_n_s_m", settings.coupling.damping, Column::Later);
    number("proxy_damping_n_s_m", settings.coupling.proxyDamping, Column::Later);
    number("max_force_n", settings.governor.maxForce, Column::Later);
    number("engage_s", settings.governor.engageTime, Column::Later);
    number("max_hand_speed_m_s", settings.governor.maxHandSpeed, Column::Later);
    number("dead_man_button", settings.governor.deadManButton, Column::Later);
    number("clutched", settings.clutched, Column::Later);
    number("clutch_button", settings.clutchButton, Column::Later);
    number("hand_turn_x_rad", settings.handTurn.x(), Column::Later);
    number("hand_turn_y_rad", settings.handTurn.y(), Column::Later);
    number("hand_turn_z_rad", settings.handTurn.z(), Column::Later);
    visitWorkspace(settings.workspace, number);
    visitGuide(settings.guide, number);
}

}  // namespace

std::vector<std::string> settingsColumns() {
    std::vector<std::string> columns;
    const Settings any;
    visit(any, [&](const char* name, const auto&, Column) { columns.emplace_back(name); });
    return columns;
}

void addSettings(CsvWriter& csv, const Settings& settings) {
    visit(settings,
          [&](const char*, const auto& value, Column) { csv.add(static_cast<double>(value)); });
}

Settings readSettings(const CsvTable& table, std::size_t row) {
    Settings settings;
    visit(settings, [&](const std::string& name, auto& value, Column column) {
        if (column == Column::Later && !table.has(name)) {
            return;
        }
        using Value = std::decay_t<decltype(value)>;
        const double number = table.number(row, name);
        const bool isSize = name.starts_with("workspace_radius") ||
                            name.starts_with("workspace_free") || name.starts_with("edge_");
        if (isSize && number < 0.0) {
            throw InputError(table.file(), "line " + std::to_string(table.line(row)),
                             name + " must not be negative");
        }
        // A guide may reach without end.
        if (!stored::standsFor<Value>(number) && !(name == "guide_capture_m" && number > 0.0)) {
            throw InputError(table.file(), "line " + std::to_string(table.line(row)),
                             name + " must be a number as Asperity writes it");
        }
        value = static_cast<Value>(number);
    });
    return settings;
}

}  // namespace asperity
