#include "core/Error.h"
#include "core/io/FormerKeys.h"
#include "core/io/recording/TickLog.h"
#include "core/io/tables/CsvTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>

namespace asperity {
namespace {

TickMemory someMemory() {
    TickMemory memory;
    memory.model.points[0] = {.guess = {.x = 1.0 / 3.0, .y = 2e-7 / 3.0, .valid = true},
                              .contact = {ContactBranch::Bonded, 0.1 + 0.2},
                              .friction = 1.1e-9};
    memory.model.points[1].guess = {.x = 2.0 / 3.0, .y = -1e-7 / 3.0, .valid = true};
    memory.model.pointCount = 2;
    memory.model.deflection = {1e-9 / 3.0, -2e-9, 3e-9};
    memory.model.tip = {1e-7 / 3.0, -2e-8, 3e-9};
    memory.model.mayLackPoint = true;
    memory.compensation = {1e-9 / 7.0, 0.0, -2e-9};
    memory.control = PositionControl::Tip;
    memory.base = {0.1, 0.2, 0.3};
    memory.correction = {1e-10, 2e-10, -3e-10};
    memory.innovation = {.normalDefect = -1.0 / 3.0,
                         .frictionDefect = 17.0 / 3.0,
                         .normalVariance = 0.1,
                         .frictionVariance = 0.2 / 3.0,
                         .bendingNoise = 1.1,
                         .torsionNoise = 1.6 / 0.9,
                         .age = 0.02 / 3.0,
                         .contradicted = true,
                         .frictionWrong = true,
                         .noisy = true};
    memory.mapping = {.device = {7.0, 8.0, 9.0}, .follows = true};
    memory.proxy = {.stretch = {1e-3 / 3.0, 0.0, -2e-3},
                    .load = {1e-9, -2e-9, 1e-8 / 7.0},
                    .normal = {0.6, 0.0, 0.8},
                    .friction = 1e-9 / 3.0,
                    .gains = {.stiffness = 400.0 / 3.0, .damping = 0.1, .proxyDamping = 0.3},
                    .forceGain = 1e8 / 3.0};
    memory.guide = {.fixture = {.kind = FixtureKind::Plane,
                                .point = {1e-9 / 3.0, 2e-9, 3e-9},
                                .axis = {0.6, 0.0, 0.8},
                                .stiffness = 200.0 / 3.0,
                                .damping = 0.5,
                                .forceLimit = 1.1},
                    .positionGain = 1e-6 / 3.0,
                    .share = 0.7,
                    .velocity = {1e-3, 2e-3 / 3.0, -3e-3}};
    memory.governor = {
        .share = 1.0 / 3.0,
        .edgeShare = 2.0 / 3.0,
        .starts = 5,
        .speed = {.from = {0.1 / 3.0, 0.2, -0.3}, .time = 1e-3, .started = true, .speed = 0.7}};
    memory.asperity = {.flags = 1U << 25U, .holdFor = 5};
    memory.started = true;
    memory.unsolved = 0.031;
    memory.fault = Fault::DeviceLost;
    memory.rearms = 4;
    return memory;
}

TEST(TickMemoryFile, ReadsBackToTheSameBits) {
    const test::ScratchFolder folder;
    const TickMemory written = someMemory();
    writeTickMemory(folder.path() / "memory.csv", written);
    const TickMemory read = readTickMemory(folder.path() / "memory.csv");
    EXPECT_EQ(read.model.pointCount, written.model.pointCount);
    for (std::size_t i = 0; i < written.model.points.size(); ++i) {
        const ClosestPointMemory& closest = written.model.points[i];
        EXPECT_EQ(read.model.points[i].guess.x, closest.guess.x);
        EXPECT_EQ(read.model.points[i].guess.y, closest.guess.y);
        EXPECT_EQ(read.model.points[i].guess.valid, closest.guess.valid);
        EXPECT_EQ(read.model.points[i].contact.branch, closest.contact.branch);
        EXPECT_EQ(read.model.points[i].contact.coordinate, closest.contact.coordinate);
        EXPECT_EQ(read.model.points[i].friction, closest.friction);
    }
    EXPECT_EQ(read.model.deflection, written.model.deflection);
    EXPECT_EQ(read.model.tip, written.model.tip);
    EXPECT_EQ(read.model.mayLackPoint, written.model.mayLackPoint);
    EXPECT_EQ(read.compensation, written.compensation);
    EXPECT_EQ(read.control, written.control);
    EXPECT_EQ(read.base, written.base);
    EXPECT_EQ(read.correction, written.correction);
    EXPECT_EQ(read.innovation, written.innovation);
    EXPECT_EQ(read.mapping.device, written.mapping.device);
    EXPECT_EQ(read.mapping.follows, written.mapping.follows);
    EXPECT_EQ(read.proxy.stretch, written.proxy.stretch);
    EXPECT_EQ(read.proxy.load, written.proxy.load);
    EXPECT_EQ(read.proxy.normal, written.proxy.normal);
    EXPECT_EQ(read.proxy.friction, written.proxy.friction);
    EXPECT_EQ(read.proxy.gains, written.proxy.gains);
    EXPECT_EQ(read.proxy.forceGain, written.proxy.forceGain);
    EXPECT_EQ(read.guide.fixture, written.guide.fixture);
    EXPECT_EQ(read.guide.positionGain, written.guide.positionGain);
    EXPECT_EQ(read.guide.share, written.guide.share);
    EXPECT_EQ(read.guide.velocity, written.guide.velocity);
    EXPECT_EQ(read.governor.share, written.governor.share);
    EXPECT_EQ(read.governor.edgeShare, written.governor.edgeShare);
    EXPECT_EQ(read.governor.starts, written.governor.starts);
    EXPECT_EQ(read.governor.speed.from, written.governor.speed.from);
    EXPECT_EQ(read.governor.speed.time, written.governor.speed.time);
    EXPECT_EQ(read.governor.speed.started, written.governor.speed.started);
    EXPECT_EQ(read.governor.speed.speed, written.governor.speed.speed);
    EXPECT_EQ(read.asperity, written.asperity);
    EXPECT_EQ(read.started, written.started);
    EXPECT_EQ(read.unsolved, written.unsolved);
    EXPECT_EQ(read.fault, written.fault);
    EXPECT_EQ(read.rearms, written.rearms);
}

/// Returns the memory of an earlier program's file, which had no columns that begin so.
TickMemory readWithout(const std::string& beginning) {
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "memory.csv";
    writeTickMemory(file, someMemory());
    const CsvTable table = readCsv(file);
    std::string columns;
    std::string row;
    for (const std::string& column : table.columns()) {
        if (!column.starts_with(beginning)) {
            columns += (columns.empty() ? "" : ",") + column;
            row += (row.empty() ? "" : ",") + table.text(0, column);
        }
    }
    std::ofstream(file) << columns << '\n' << row << '\n';
    return readTickMemory(file);
}

/// Memories from before there was an innovation monitor start it afresh.
TEST(TickMemoryFile, ReadsAMemoryWithoutInnovations) {
    const TickMemory read = readWithout("innovation_");
    EXPECT_EQ(read.innovation, InnovationMemory{});
    EXPECT_EQ(read.base, someMemory().base);
}

/// Earlier files have hand_x_m for device_x_m and foot0_x_m for contact_point0_x_m.
TEST(TickMemoryFile, ReadsColumnsByTheirFormerNames) {
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.file("memory.csv");
    writeTickMemory(file, someMemory());
    const CsvTable table = readCsv(file);
    std::string columns;
    std::string row;
    std::size_t renamed = 0;
    for (const std::string& column : table.columns()) {
        const auto* const former = std::ranges::find(kFormerKeys, column, &FormerKey::current);
        const bool isRenamed = former != kFormerKeys.end();
        renamed += isRenamed ? 1 : 0;
        columns += (columns.empty() ? "" : ",");
        columns += isRenamed ? former->former : column;
        row += (row.empty() ? "" : ",") + table.text(0, column);
    }
    EXPECT_EQ(renamed, 1U + 4U * 6U + 3U);
    std::ofstream(file) << columns << '\n' << row << '\n';
    const std::filesystem::path again = folder.file("again.csv");
    const std::filesystem::path current = folder.file("current.csv");
    writeTickMemory(again, readTickMemory(file));
    writeTickMemory(current, someMemory());
    EXPECT_EQ(test::contentOf(again), test::contentOf(current));
}

TEST(TickMemoryFile, AMemoryOfBeforeLacksNoNeck) {
    EXPECT_FALSE(readWithout("may_lack_point").model.mayLackPoint);
}

TEST(TickMemoryFile, ReadsAMemoryWithoutThePositionOfTheTip) {
    const TickMemory read = readWithout("tip_");
    EXPECT_EQ(read.model.tip, read.base + read.model.deflection);
}

TEST(TickMemoryFile, RefusesWhatIsNoMemory) {
    const test::ScratchFolder folder;
    std::ofstream(folder.path() / "memory.csv") << "contact_point0_x_m\n1\n2\n";
    EXPECT_THROW((void)readTickMemory(folder.path() / "memory.csv"), InputError);
}

TEST(TickMemoryFile, RefusesValuesThatNoMemoryHas) {
    const test::ScratchFolder folder;
    const std::filesystem::path file = folder.path() / "memory.csv";
    TickMemory memory = someMemory();
    memory.fault = static_cast<Fault>(9);
    writeTickMemory(file, memory);
    EXPECT_THROW((void)readTickMemory(file), InputError);
    memory = someMemory();
    memory.governor.share = 5.0;  // would give five times the force
    writeTickMemory(file, memory);
    EXPECT_THROW((void)readTickMemory(file), InputError);
    memory = someMemory();
    memory.innovation.normalVariance = -1.0;
    writeTickMemory(file, memory);
    EXPECT_THROW((void)readTickMemory(file), InputError);
    memory = someMemory();
    memory.base.x() = std::numeric_limits<double>::quiet_NaN();
    writeTickMemory(file, memory);
    EXPECT_THROW((void)readTickMemory(file), InputError);
}

}  // namespace
}  // namespace asperity
