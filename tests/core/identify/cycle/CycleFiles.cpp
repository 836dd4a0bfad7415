#include "tests/core/identify/cycle/CycleFiles.h"

#include "core/Random.h"
#include "tests/support/Places.h"
#include "tests/support/ReferenceTable.h"

#include <cmath>
#include <fstream>
#include <numeric>

namespace asperity::test {

namespace {

MeasuredCycle readCycle(const ReferenceTable& table) {
    MeasuredCycle cycle;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string kind = table.text(row, "segment").substr(2);
        CycleBranch& branch = kind == "approach"  ? cycle.approach
                              : kind == "retract" ? cycle.retract
                                                  : cycle.dwell;
        branch.time.push_back(table.number(row, "time_s"));
        branch.base.push_back(table.number(row, "base_m"));
        branch.force.push_back(table.number(row, "force_N"));
    }
    return cycle;
}

/// Mean of the forces [from, to).
double meanForce(const CycleBranch& branch, std::size_t from, std::size_t to) {
    const auto begin = branch.force.begin() + static_cast<std::ptrdiff_t>(from);
    const auto end = branch.force.begin() + static_cast<std::ptrdiff_t>(to);
    return std::accumulate(begin, end, 0.0) / static_cast<double>(to - from);
}

void takeOffLine(MeasuredCycle& cycle, std::size_t quiet) {
    const CycleBranch& branch = cycle.approach;
    const double force = meanForce(branch, 0, quiet);
    double base = 0.0;
    for (std::size_t i = 0; i < quiet; ++i) {
        base += branch.base[i] / static_cast<double>(quiet);
    }
    double product = 0.0;
    double square = 0.0;
    for (std::size_t i = 0; i < quiet; ++i) {
        product += (branch.base[i] - base) * (branch.force[i] - force);
        square += (branch.base[i] - base) * (branch.base[i] - base);
    }
    for (CycleBranch* part : {&cycle.approach, &cycle.dwell, &cycle.retract}) {
        for (std::size_t i = 0; i < part->size(); ++i) {
            part->force[i] -= force + (product / square * (part->base[i] - base));
        }
    }
}

}  // namespace

MeasuredCycle syntheticCycle(const std::string& name, double noise, std::uint64_t seed) {
    const std::filesystem::path path = referenceFolder() / "cycles" / (name + ".csv");
    MeasuredCycle cycle = readCycle(ReferenceTable(path));
    std::ifstream file(path);
    std::string word;
    while (file >> word && word != "lever") {
    }
    file >> cycle.stiffness;
    cycle.noise = noise * cycle.forceRange();
    Random random{seed};
    for (CycleBranch* branch : {&cycle.approach, &cycle.retract}) {
        for (double& force : branch->force) {
            force += cycle.noise * random.normal();
        }
    }
    return cycle;
}

MeasuredCycle sharedCycle(const std::string& name, double stiffness, double quiet) {
    MeasuredCycle cycle = readCycle(ReferenceTable(sharedData("curves/csv/" + name + ".csv")));
    cycle.stiffness = stiffness;
    const auto part = static_cast<std::size_t>(quiet * static_cast<double>(cycle.approach.size()));
    takeOffLine(cycle, part);
    double squares = 0.0;
    for (std::size_t i = 0; i < part; ++i) {
        squares += cycle.approach.force[i] * cycle.approach.force[i];
    }
    cycle.noise = std::sqrt(squares / static_cast<double>(part));
    const std::size_t end = cycle.retract.size();
    const double offset = meanForce(cycle.retract, end - (end / 4), end);
    for (double& force : cycle.retract.force) {
        force -= offset;
    }
    return cycle;
}

MeasuredCycle scaled(const MeasuredCycle& cycle, double factor) {
    MeasuredCycle large = cycle;
    for (CycleBranch* branch : {&large.approach, &large.dwell, &large.retract}) {
        for (std::size_t i = 0; i < branch->size(); ++i) {
            branch->base[i] *= factor;
            branch->force[i] *= factor * factor;
        }
    }
    large.stiffness *= factor;
    large.noise *= factor * factor;
    return large;
}

}  // namespace asperity::test
