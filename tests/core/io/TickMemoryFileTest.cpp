#include "core/io/TickMemoryFile.h"

#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <fstream>
#include <limits>

namespace asperity {
namespace {

TickMemory someMemory() {
    TickMemory memory;
    memory.model = {.foot = {.x = 1.0 / 3.0, .y = 2e-7 / 3.0, .valid = true},
                    .branch = ContactBranch::Bonded,
                    .deflection = {1e-9 / 3.0, -2e-9, 3e-9},
                    .friction = 1.1e-9};
    memory.base = {0.1, 0.2, 0.3};
    memory.correction = {1e-10, 2e-10, -3e-10};
    memory.hand = {7.0, 8.0, 9.0};
    memory.started = true;
    memory.fault = Fault::DeviceLost;
    memory.rearms = 4;
    return memory;
}

TEST(TickMemoryFile, ReadsBackToTheSameBits) {
    const test::ScratchFolder folder;
    const TickMemory written = someMemory();
    writeTickMemory(folder.path() / "memory.csv", written);
    const TickMemory read = readTickMemory(folder.path() / "memory.csv");
    EXPECT_EQ(read.model.foot.x, written.model.foot.x);
    EXPECT_EQ(read.model.foot.y, written.model.foot.y);
    EXPECT_EQ(read.model.foot.valid, written.model.foot.valid);
    EXPECT_EQ(read.model.branch, written.model.branch);
    EXPECT_EQ(read.model.deflection, written.model.deflection);
    EXPECT_EQ(read.model.friction, written.model.friction);
    EXPECT_EQ(read.base, written.base);
    EXPECT_EQ(read.correction, written.correction);
    EXPECT_EQ(read.hand, written.hand);
    EXPECT_EQ(read.started, written.started);
    EXPECT_EQ(read.fault, written.fault);
    EXPECT_EQ(read.rearms, written.rearms);
}

TEST(TickMemoryFile, RefusesWhatIsNoMemory) {
    const test::ScratchFolder folder;
    std::ofstream(folder.path() / "memory.csv") << "foot_x_m\n1\n2\n";
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
    memory.base.x() = std::numeric_limits<double>::quiet_NaN();
    writeTickMemory(file, memory);
    EXPECT_THROW((void)readTickMemory(file), InputError);
}

}  // namespace
}  // namespace asperity
