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
    number("foot_x_m", memory.model.foot.x);
    number("foot_y_m", memory.model.foot.y);
    number("foot_valid", memory.model.foot.valid);
    number("branch", memory.model.branch);
    vector("deflection", memory.model.deflection, "m");
    number("friction_n", memory.model.friction);
    vector("base", memory.base, "m");
    vector("correction", memory.correction, "n");
    vector("hand", memory.hand, "m");
    number("started", memory.started);
    number("fault", memory.fault);
    number("rearms", memory.rearms);
}

bool isUpTo(double largest, double number) {
    return number >= 0.0 && number <= largest && number == std::floor(number);
}
bool isValue(double, double number) { return std::isfinite(number); }
bool isValue(bool, double number) { return isUpTo(1.0, number); }
bool isValue(ContactBranch, double number) {
    return isUpTo(static_cast<double>(ContactBranch::Bonded), number);
}
bool isValue(Fault, double number) {
    return isUpTo(static_cast<double>(Fault::DeviceLost), number);
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
        const double number = table.number(0, name);
        if (!isValue(value, number)) {
            throw InputError(path.string(), name, "expected a value as Asperity writes it");
        }
        value = static_cast<std::decay_t<decltype(value)>>(number);
    });
    return memory;
}

}  // namespace asperity
