#include "core/io/recording/TickMemoryFile.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/StoredRow.h"

#include <limits>
#include <string>

namespace asperity {

namespace {

constexpr double kMissing = std::numeric_limits<double>::quiet_NaN();

template <class Memory, class Cell>
void listModel(Memory& memory, const Cell& cell) {
    cell({"feet"}, memory.model.pointCount);
    for (std::size_t i = 0; i < memory.model.points.size(); ++i) {
        const std::string closest = "foot" + std::to_string(i);
        auto& kept = memory.model.points[i];
        cell({closest, "_x_m"}, kept.guess.x);
        cell({closest, "_y_m"}, kept.guess.y);
        cell({closest, "_valid"}, kept.guess.valid);
        cell({closest, "_branch"}, kept.contact.branch);
        cell({closest, "_coordinate"}, kept.contact.coordinate);
        cell({closest, "_friction_n"}, kept.friction);
    }
    listVector(cell, "deflection_", memory.model.deflection, "_m");
}

template <class Memory, class Cell>
void listSignals(Memory& memory, const Cell& cell) {
    cell({"innovation_normal_defect"}, memory.innovation.normalDefect);
    cell({"innovation_friction_defect"}, memory.innovation.frictionDefect);
    cell({.front = "innovation_normal_variance", .holds = Holds::NotNegative},
         memory.innovation.normalVariance);
    cell({.front = "innovation_friction_variance", .holds = Holds::NotNegative},
         memory.innovation.frictionVariance);
    cell({"innovation_bending_noise"}, memory.innovation.bendingNoise);
    cell({"innovation_torsion_noise"}, memory.innovation.torsionNoise);
    cell({"innovation_age_s"}, memory.innovation.age);
    cell({"innovation_contradicted"}, memory.innovation.contradicted);
    cell({"innovation_friction_wrong"}, memory.innovation.frictionWrong);
    cell({"innovation_noisy"}, memory.innovation.noisy);
    cell({"signals_bending_rad"}, memory.signals.expected.bending);
    cell({"signals_torsion_rad"}, memory.signals.expected.torsion);
    cell({"signals_bending_change_rad"}, memory.signals.change.bending);
    cell({"signals_torsion_change_rad"}, memory.signals.change.torsion);
    cell({"signals_started"}, memory.signals.started);
}

template <class Memory, class Cell>
void listCouplingMemory(Memory& memory, const Cell& cell) {
    cell({"mapping_follows"}, memory.mapping.follows);
    listVector(cell, "proxy_stretch_", memory.proxy.stretch, "_m");
    listVector(cell, "proxy_load_", memory.proxy.load, "_n");
    listVector(cell, "proxy_normal_", memory.proxy.normal, "_1");
    cell({"proxy_friction_n"}, memory.proxy.friction);
    cell({"proxy_stiffness_n_m"}, memory.proxy.gains.stiffness);
    cell({"proxy_coupling_damping_n_s_m"}, memory.proxy.gains.damping);
    cell({"proxy_damping_n_s_m"}, memory.proxy.gains.proxyDamping);
    cell({"proxy_force_gain"}, memory.proxy.forceGain);
}

template <class Memory, class Cell>
void listGuideMemory(Memory& memory, const Cell& cell) {
    cell({"guide"}, memory.guide.fixture.kind);
    listVector(cell, "guide_point_", memory.guide.fixture.point, "_m");
    listVector(cell, "guide_axis_", memory.guide.fixture.axis, "_1");
    cell({"guide_stiffness_n_m"}, memory.guide.fixture.stiffness);
    cell({"guide_damping_n_s_m"}, memory.guide.fixture.damping);
    cell({"guide_force_limit_n"}, memory.guide.fixture.forceLimit);
    cell({.front = "guide_capture_m", .holds = Holds::Endless},
         memory.guide.fixture.captureDistance);
    cell({"guide_position_gain"}, memory.guide.positionGain);
    cell({.front = "guide_share", .holds = Holds::Share}, memory.guide.share);
    listVector(cell, "guide_velocity_", memory.guide.velocity, "_m_s");
}

template <class Memory, class Cell>
void listGovernorMemory(Memory& memory, const Cell& cell) {
    cell({.front = "governor_share", .holds = Holds::Share}, memory.governor.share);
    cell({.front = "governor_edge_share", .holds = Holds::Share}, memory.governor.edgeShare);
    cell({"governor_starts"}, memory.governor.starts);
    listVector(cell, "governor_from_", memory.governor.speed.from, "_m");
    cell({"governor_time_s"}, memory.governor.speed.time);
    cell({"governor_started"}, memory.governor.speed.started);
    cell({"governor_speed_m_s"}, memory.governor.speed.speed);
}

/// The columns of tick_memory.csv.
template <class Memory, class Cell>
void listMemory(Memory& memory, const Cell& cell) {
    const auto later = [&cell](Column column, auto& value) {
        column.later = true;
        cell(column, value);
    };
    listModel(memory, cell);
    listVector(cell, "compensation_", memory.compensation, "_m");
    cell({"control"}, memory.control);
    listVector(cell, "base_", memory.base, "_m");
    listVector(cell, "correction_", memory.correction, "_n");
    listSignals(memory, later);
    listVector(later, "tip_", memory.model.tip, "_m");
    listVector(cell, "hand_", memory.mapping.device, "_m");
    listCouplingMemory(memory, later);
    listGuideMemory(memory, later);
    listGovernorMemory(memory, later);
    later({"may_lack_point"}, memory.model.mayLackPoint);
    later({"unsolved_s"}, memory.unsolved);
    later({"asperity_flags"}, memory.asperity.flags);
    later({"asperity_hold_for"}, memory.asperity.holdFor);
    cell({"started"}, memory.started);
    cell({"fault"}, memory.fault);
    cell({"rearms"}, memory.rearms);
}

}  // namespace

void writeTickMemory(const std::filesystem::path& path, const TickMemory& memory) {
    const auto list = [&memory](const auto& cell) { listMemory(memory, cell); };
    CsvWriter csv(path,
                  {std::string("Asperity ") + kVersion + ": what the first tick starts from",
                   "SI units, as each column's name ends; lab frame"},
                  columnNames(list));
    addCells(csv, list);
    csv.endRow();
    csv.close();
}

TickMemory readTickMemory(const std::filesystem::path& path) {
    const CsvTable table = readCsv(path);
    if (table.rows() != 1) {
        throw InputError(path.string(), "", "expected one row of values");
    }
    TickMemory memory;
    memory.mapping.follows = true;  // there was no clutch
    memory.model.tip.setConstant(kMissing);
    stored::readCells(table, 0, [&memory](const auto& cell) { listMemory(memory, cell); });
    if (memory.model.tip.array().isNaN().any()) {
        memory.model.tip = memory.base + memory.model.deflection;
    }
    return memory;
}

}  // namespace asperity
