#include "core/io/TickMemoryFile.h"

#include "core/Error.h"
#include "core/Version.h"
#include "core/io/CsvTable.h"
#include "core/io/CsvWriter.h"

#include <cmath>
#include <cstdint>
#include <limits>
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
    vector("hand", memory.hand, "m");
    vector("proxy_stretch", memory.proxy.stretch, "m");
    vector("proxy_load", memory.proxy.load, "n");
    vector("proxy_normal", memory.proxy.normal, "1");
    number("proxy_friction_n", memory.proxy.friction);
    number("proxy_stiffness_n_m", memory.proxy.gains.stiffness);
    number("proxy_coupling_damping_n_s_m", memory.proxy.gains.damping);
    number("proxy_damping_n_s_m", memory.proxy.gains.proxyDamping);
    number("proxy_force_gain", memory.proxy.forceGain);
    number("governor_share", memory.governor.share);
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

bool isUpTo(double largest, double number) {
    return number >= 0.0 && number <= largest && number == std::floor(number);
}
bool isValue(double, double number) { return std::isfinite(number); }
bool isValue(bool, double number) { return isUpTo(1.0, number); }
bool isValue(std::size_t, double number) { return isUpTo(static_cast<double>(kMostFeet), number); }
bool isValue(PositionControl, double number) {
    return isUpTo(static_cast<double>(PositionControl::Tip), number);
}
bool isValue(ContactBranch, double number) {
    return isUpTo(static_cast<double>(ContactBranch::Bonded), number);
}
bool isValue(Fault, double number) {
    return isUpTo(static_cast<double>(Fault::SolverFailed), number);
}
bool isValue(std::uint32_t, double number) {
    return isUpTo(std::numeric_limits<std::uint32_t>::max(), number);
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
    visit(memory, [&](const std::string& name, auto& value) {
        const bool isLater =
            name.starts_with("proxy_") || name.starts_with("governor_") || name == "unsolved_s";
        if (isLater && !table.has(name)) {
            return;  // from before there was a proxy, a governor or this fault
        }
        const double number = table.number(0, name);
        if (!isValue(value, number)) {
            throw InputError(path.string(), name, "expected a value as Asperity writes it");
        }
        value = static_cast<std::decay_t<decltype(value)>>(number);
    });
    return memory;
}

}  // namespace asperity
