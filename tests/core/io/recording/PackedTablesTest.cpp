#include "core/io/recording/PackedTables.h"

#include "core/io/hdf5/Hdf5Output.h"
#include "core/io/hdf5/Hdf5TableWriter.h"
#include "core/io/recording/ColumnList.h"
#include "core/io/recording/RowChecks.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

namespace asperity::test {
namespace {

using testing::HasSubstr;

constexpr const char* kInput = "# in\ntime_s,device_z_m,alpha_rad,buttons\n"
                               "0,0.10000000000000001,-0,3\n"
                               "0.001,0.20000000000000001,nan,3\n"
                               "0.002,1e-300,inf,4\n";
constexpr const char* kLog = "# out\ntime_s,base_z_m,alpha_rad,est_fz_n,state\n"
                             "0,0.10000000000000001,-0,0.33333333333333331,free\n"
                             "0.001,0.20000000000000001,nan,nan,contact\n"
                             "0.002,1e-300,inf,-inf,\"a,b\"\n";

class PackedTables : public testing::Test {
protected:
    void pack(const char* log) {
        tables.input = scratch.write("tick_input.csv", kInput);
        tables.log = scratch.write("force_log.csv", log);
        packTables(tables, file);
    }

    ScratchFolder scratch;
    TextTables tables;
    std::filesystem::path file = scratch.file("recording.h5");
};

TEST_F(PackedTables, KeepAllDigitsOfTheInput) {
    pack(kLog);
    const std::string before = contentOf(tables.input);
    std::filesystem::remove(tables.input);
    unpackTables(file, tables);
    EXPECT_EQ(contentOf(tables.input), before);
}

TEST_F(PackedTables, OfTextWithFormerNamesHaveTheCurrentOnes) {
    const auto packed = [this](const char* device) {
        const std::string name = device;
        tables.input = scratch.write("tick_input.csv", "time_s," + name + "z_m\n0,1\n");
        tables.log = scratch.write("force_log.csv", "time_s," + name + "fz_n,flags\n0,2,-\n");
        packTables(tables, file);
        return contentOf(file);
    };
    EXPECT_EQ(packed("hand_"), packed("device_"));
}

TEST_F(PackedTables, KeepAllDigitsOfEnergies) {
    constexpr const char* kEnergy = "# e\ntime_s,energy_j\n0,0.10000000000000001\n";
    tables.energy = scratch.write("energy_log.csv", kEnergy);
    pack(kLog);
    std::filesystem::remove(tables.energy);
    unpackTables(file, tables);
    EXPECT_EQ(contentOf(tables.energy), kEnergy);
}

TEST_F(PackedTables, HoldTheLogInSinglePrecisionAndChecksOfAllDigits) {
    pack(kLog);
    const PackedLog log = readPackedLog(file);
    ASSERT_EQ(log.rows.rows(), 3U);
    EXPECT_EQ(log.rows.text(0, "est_fz_n"), "0.33333334");
    EXPECT_EQ(log.rows.text(1, "est_fz_n"), "nan");
    EXPECT_EQ(log.rows.text(2, "state"), "a,b");
    EXPECT_EQ(log.rows.text(2, "base_z_m"), "1e-300") << "an input, too";
    EXPECT_EQ(log.rows.text(2, "time_s"), "0.002");
    ASSERT_EQ(log.checks.size(), 1U);
    std::string other = kLog;
    other.replace(other.find("331,free"), 3, "332");
    pack(other.c_str());
    EXPECT_NE(readPackedLog(file).checks, log.checks);
    EXPECT_EQ(readPackedLog(file).rows.text(0, "est_fz_n"), "0.33333334");
}

TEST_F(PackedTables, ShareWhatLogAndInputBothHold) {
    pack(kLog);
    const Hdf5Input input(file, {"force_log"});
    asperity::Hdf5Rows rows(input, "force_log");
    EXPECT_EQ(rows.columns()[1].type, Hdf5Column::Type::Double);
    EXPECT_EQ(rows.columns()[2].type, Hdf5Column::Type::Double) << "nan and inf are alike, too";
    EXPECT_EQ(rows.columns()[3].type, Hdf5Column::Type::Single);
    std::string longer = kLog;
    longer += "0.003,0,0,0,free\n";
    pack(longer.c_str());
    EXPECT_EQ(readPackedLog(file).rows.rows(), 4U);
    EXPECT_EQ(readPackedInput(file).rows(), 3U);
}

TEST_F(PackedTables, RefuseOtherFiles) {
    pack(kLog);
    Hdf5Output(file).close();
    EXPECT_THAT(refusalOf([&] { (void)readPackedLog(file); }),
                HasSubstr("expected the tables of a recording"));
}

TEST(RowChecks, AreOfSoManyRowsEach) {
    RowChecks checks;
    for (std::size_t row = 0; row < RowChecks::kRows; ++row) {
        checks.add("1");
        checks.endRow();
    }
    EXPECT_EQ(checks.checks().size(), 1U);
    checks.add("123456789");
    checks.endRow();
    ASSERT_EQ(checks.checks().size(), 2U);
    boost::crc_32_type crc;
    crc.process_bytes("123456789,\n", 11);
    EXPECT_EQ(checks.checks()[1], crc.checksum());
}

TEST(ColumnUnit, IsWhatTheNameEndsIn) {
    EXPECT_EQ(unitOfColumn("base_z_m"), "m");
    EXPECT_EQ(unitOfColumn("est_sigma_fx_n"), "N");
    EXPECT_EQ(unitOfColumn("coupling_stiffness_n_m"), "N/m");
    EXPECT_EQ(unitOfColumn("coupling_damping_n_s_m"), "N s/m");
    EXPECT_EQ(unitOfColumn("max_device_speed_m_s"), "m/s");
    EXPECT_EQ(unitOfColumn("time_step_s"), "s");
    EXPECT_EQ(unitOfColumn("correction_hz"), "Hz");
    EXPECT_EQ(unitOfColumn("energy_j"), "J");
    EXPECT_EQ(unitOfColumn("theta_rad"), "rad");
    EXPECT_EQ(unitOfColumn("buttons"), "");
}

}  // namespace
}  // namespace asperity::test
