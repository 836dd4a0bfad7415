#include "core/io/recording/TickMemoryFile.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/recording/StoredValue.h"
#include "core/io/tables/CsvTable.h"
#include "core/io/tables/CsvWriter.h"

#include <algorithm>
#include <array>
#include <string>
#include <type_traits>

namespace asperity {

namespace {

/// Calls `number(name, value)` for every value of the memory: the one list of its columns.
template <typename Memory, typename Visitor>
void visit(Memory& memory, const Visitor& number) {
    const auto vector = [&number](const std::string& name, auto& value, const char* unit) {
        number(name + "_x_" + unit, value.x());
        number(name + "_y_" + unit, value.y());
        number(name + "_z_" + unit, value.z());
    };
    number("feet", memory.model.footCount);
    for (std::size_t i = 0; i < memory.model.feet.size(); ++i) {
        const std::string foot = "foot" + std::to_string(i);
        auto& kept = memory.model.feet[i];
        number(foot + "_x_m", kept.guess.x);
        number(foot + "_y_m", kept.guess.y);
        number(foot + "_valid", kept.guess.valid);
        number(foot + "_branch", kept.contact.branch);
        number(foot + "_coordinate", kept.contact.coordinate);
        number(foot + "_friction_n", kept.friction);
    }
    vector("deflection", memory.model.deflection, "m");
    vector("compensation", memory.compensation, "m");
    number("control", memory.control);
    vector("base", memory.base, "m");
    vector("correction", memory.correction, "n");
    number("innovation_normal_defect", memory.innovation.normalDefect);
    number("innovation_friction_defect", memory.innovation.frictionDefect);
    number("innovation_normal_variance", memory.innovation.normalVariance);
    number("innovation_friction_variance", memory.innovation.frictionVariance);
    number("innovation_bending_noise", memory.innovation.bendingNoise);
    number("innovation_torsion_noise", memory.innovation.torsionNoise);
    number("innovation_age_s", memory.innovation.age);
    number("innovation_contradicted", memory.innovation.contradicted);
    number("innovation_friction_wrong", memory.innovation.frictionWrong);
    number("innovation_noisy", memory.innovation.noisy);
    number("signals_bending_rad", memory.signals.expected.bending);
    number("signals_torsion_rad", memory.signals.expected.torsion);
    number("signals_bending_change_rad", memory.signals.change.bending);
    number("signals_torsion_change_rad", memory.signals.change.torsion);
    number("signals_started", memory.signals.started);
    vector("hand", memory.mapping.hand, "m");
    number("mapping_follows", memory.mapping.follows);
    vector("proxy_stretch", memory.proxy.stretch, "m");
    vector("proxy_load", memory.proxy.load, "n");
    vector("proxy_normal", memory.proxy.normal, "1");
    number("proxy_friction_n", memory.proxy.friction);
    number("proxy_stiffness_n_m", memory.proxy.gains.stiffness);
    number("proxy_coupling_damping_n_s_m", memory.proxy.gains.damping);
    number("proxy_damping_n_s_m", memory.proxy.gains.proxyDamping);
    number("proxy_force_gain", memory.proxy.forceGain);
    number("guide", memory.guide.fixture.kind);
    vector("guide_point", memory.guide.fixture.point, "m");
    vector("guide_axis", memory.guide.fixture.axis, "1");
    number("guide_stiffness_n_m", memory.guide.fixture.stiffness);
    number("guide_damping_n_s_m", memory.guide.fixture.damping);
    number("guide_force_limit_n", memory.guide.fixture.forceLimit);
    number("guide_capture_m", memory.guide.fixture.captureDistance);
    number("guide_position_gain", memory.guide.positionGain);
    number("guide_share", memory.guide.share);
    vector("guide_velocity", memory.guide.velocity, "m_s");
    number("governor_share", memory.governor.share);
    number("governor_edge_share", memory.governor.edgeShare);
    number("governor_starts", memory.governor.starts);
    vector("governor_from", memory.governor.speed.from, "m");
    number("governor_time_s", memory.governor.speed.time);
    number("governor_started", memory.governor.speed.started);
    number("governor_speed_m_s", memory.governor.speed.speed);
    number("unsolved_s", memory.unsolved);
    number("started", memory.started);
    number("fault", memory.fault);
    number("rearms", memory.rearms);
}

/// Whether there are memories from before there was such a value.
bool isLater(const std::string& name) {
    constexpr std::array kLater{"proxy_",     "governor_",   "guide",   "mapping_",
                                "unsolved_s", "innovation_", "signals_"};
    return std::any_of(kLater.begin(), kLater.end(),
                       [&name](const char* begin) { return name.starts_with(begin); });
}

}  // namespace

void writeTickMemory(const std::filesystem::path& path, const TickMemory& memory) {
    std::vector<std::string> columns;
    visit(memory, [&columns](const std::string& name, const auto&) { columns.push_back(name); });
    CsvWriter csv(path,
                  {std::string("Asperity ") + kVersion + ": what the first tick starts from",
                   "SI units, as each column's name ends; lab frame"},
                  columns);
    visit(memory,
          [&csv](const std::string&, const auto& value) { csv.add(static_cast<double>(value)); });
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
    visit(memory, [&](const std::string& name, auto& value) {
        if (isLater(name) && !table.has(name)) {
            return;
        }
        using Value = std::decay_t<decltype(value)>;
        const double number = table.number(0, name);
        const bool isShare = name.ends_with("_share");
        if (isShare && !(number >= 0.0 && number <= 1.0)) {
            throw InputError(path.string(), name, "expected a share from 0 to 1");
        }
        if (name.ends_with("_variance") && !(number >= 0.0)) {
            throw InputError(path.string(), name, "expected a variance, 0 or more");
        }
        // A guide may reach without end.
        if (!stored::standsFor<Value>(number) && !(name == "guide_capture_m" && number > 0.0)) {
            throw InputError(path.string(), name, "expected a value as Asperity writes it");
        }
        value = static_cast<Value>(number);
    });
    return memory;
}

}  // namespace asperity
