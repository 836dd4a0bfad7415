#include "core/io/recording/TickLog.h"

#include "core/Error.h"
#include "core/io/scene/DevicePathFile.h"
#include "core/io/tables/CsvTable.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <limits>

namespace asperity {
namespace {

TickSample sampleOf(double time) {
    TickSample sample;
    sample.time = time;
    sample.input.timeStep = 1.0 / 3.0e3;
    sample.input.device = {.position = {1.0 / 3.0, -2e-9 / 7.0, 5e-324},
                           .buttons = 5,
                           .maxForce = 8.5 / 3.0,
                           .streams = true,
                           .age = 1e-3 / 3.0};
    sample.input.starts = 2;
    sample.input.measurement = {{0.1 + 0.2, -1e-300}, 0.02};
    sample.input.settings = {
        .positionGain = 1e-6 / 3.0,
        .forceGain = 1e8 / 7.0,
        .correctionBandwidth = 20.0,
        .coupling = {.stiffness = 1e3 / 3.0, .damping = 0.1 + 0.2, .proxyDamping = 3.0},
        .governor = {.maxForce = 1.0 / 3.0,
                     .engageTime = 0.7,
                     .maxDeviceSpeed = 1.1,
                     .deadManButton = 31},
        .deviceTurn = {0.1 / 3.0, -0.2, 2.5},
        .workspace = {.center = {0.1, -0.2, 0.3},
                      .radius = 0.1 / 3.0,
                      .freeShare = 0.7,
                      .stiffness = 2e2 / 3.0,
                      .forceLimit = 1.7},
        .clutched = true,
        .clutchButton = 4,
        .trialButton = 5,
        .guide = {.kind = FixtureKind::Line,
                  .point = {1e-9, 2e-9 / 3.0, -3e-9},
                  .axis = Vector3(1.0, 2.0, -3.0).normalized(),
                  .stiffness = 2e2 / 7.0,
                  .damping = 0.1 + 0.2,
                  .forceLimit = 1.1},
        .forcesOn = false,
        .rearms = 3};
    sample.output.model.contact = {.force = -3e-9, .indentation = 1e-9, .contactRadius = 2e-9};
    sample.output.model.contact.branch = ContactBranch::Bonded;
    sample.output.estimate.covariance(1, 1) = 4e-18;
    sample.output.flags.set(Validity::OutsideScan, true);
    return sample;
}

TEST(TickLog, InputsReadBackToTheSameBits) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "tick_input.csv";
    const TickSample written = sampleOf(1.0 / 7.0);
    TickInputWriter writer(path);
    writer.take(written);
    writer.take(sampleOf(0.5));
    writer.close();
    const std::vector<TickSample> read = readTickInputs(path);
    ASSERT_EQ(read.size(), 2U);
    const auto bits = [](double value) { return std::bit_cast<std::uint64_t>(value); };
    EXPECT_EQ(bits(read[0].time), bits(written.time));
    EXPECT_EQ(bits(read[0].input.timeStep), bits(written.input.timeStep));
    EXPECT_EQ(read[0].input.device.position, written.input.device.position);
    EXPECT_EQ(read[0].input.device.buttons, 5U);
    EXPECT_EQ(bits(read[0].input.measurement.signals.bending),
              bits(written.input.measurement.signals.bending));
    EXPECT_EQ(read[0].input.measurement.signals.torsion, -1e-300);
    EXPECT_EQ(read[0].input.settings, written.input.settings);
    EXPECT_EQ(bits(read[0].input.device.maxForce), bits(written.input.device.maxForce));
    EXPECT_TRUE(read[0].input.device.streams);
    EXPECT_EQ(bits(read[0].input.device.age), bits(written.input.device.age));
    EXPECT_EQ(read[0].input.starts, 2U);
}

/// Other programs read these tables by name.
TEST(TickLog, ColumnsKeepNamesAndOrder) {
    const test::ScratchFolder scratch;
    const auto columnsOf = [&]<class Writer>(const char* name) {
        const auto path = scratch.path() / name;
        Writer(path).close();
        const CsvTable table = readCsv(path);
        std::string joined;
        for (const std::string& column : table.columns()) {
            joined += (joined.empty() ? "" : ",") + column;
        }
        return joined;
    };
    EXPECT_EQ(columnsOf.operator()<ForceLogWriter>("force_log.csv"),
              "time_s,base_x_m,base_y_m,base_z_m,tip_x_m,tip_y_m,tip_z_m,est_fx_n,est_fy_n,"
              "est_fz_n,est_sigma_fx_n,est_sigma_fy_n,est_sigma_fz_n,model_fx_n,model_fy_n,"
              "model_fz_n,device_fx_n,device_fy_n,device_fz_n,alpha_rad,theta_rad,gap_m,"
              "contact_radius_m,state,flags,indentation_m,branch");
    EXPECT_EQ(columnsOf.operator()<TickInputWriter>("tick_input.csv"),
              "time_s,time_step_s,device_x_m,device_y_m,device_z_m,buttons,connected,alpha_rad,"
              "theta_rad,age_s,starts,device_max_force_n,device_streams,device_age_s,"
              "instrument_connected,instrument_extrapolated,instrument_aside,instrument_ended,"
              "position_gain,force_gain,correction_hz,tip_control,forces_on,"
              "rearms,coupling_stiffness_n_m,coupling_damping_n_s_m,proxy_damping_n_s_m,"
              "max_force_n,engage_s,max_device_speed_m_s,dead_man_button,clutched,clutch_button,"
              "trial_button,"
              "device_turn_x_rad,device_turn_y_rad,device_turn_z_rad,workspace_x_m,workspace_y_m,"
              "workspace_z_m,workspace_radius_m,workspace_free_share,edge_stiffness_n_m,"
              "edge_force_limit_n,guide,guide_x_m,guide_y_m,guide_z_m,guide_axis_x,guide_axis_y,"
              "guide_axis_z,guide_stiffness_n_m,guide_damping_n_s_m,guide_force_limit_n,"
              "guide_capture_m");
}

TEST(TickLog, ReadsInputsFromBeforeThereWasAGovernor) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "tick_input.csv";
    std::ofstream(path) << "time_s,time_step_s,device_x_m,device_y_m,device_z_m,buttons,connected,"
                           "alpha_rad,theta_rad,age_s,position_gain,force_gain,correction_hz,"
                           "tip_control,forces_on,rearms\n"
                           "0,0.001,1,2,3,0,1,0,0,0,1,1,20,0,1,0\n";
    const TickInput input = readTickInputs(path).at(0).input;
    EXPECT_FALSE(input.device.rendersForce());
    EXPECT_EQ(input.settings, Settings{});
}

TEST(TickLog, ReadsInputsByTheirFormerNames) {
    const test::ScratchFolder scratch;
    const auto path = scratch.write(
        "tick_input.csv",
        "time_s,time_step_s,hand_x_m,hand_y_m,hand_z_m,buttons,connected,alpha_rad,theta_rad,age_s,"
        "hand_max_force_n,hand_streams,hand_age_s,position_gain,force_gain,correction_hz,"
        "tip_control,forces_on,rearms,max_hand_speed_m_s,hand_turn_x_rad,hand_turn_y_rad,"
        "hand_turn_z_rad\n"
        "0,0.001,1,2,3,0,1,0,0,0,4,1,0.25,1,1,20,0,1,0,1.25,0.5,0.75,0.125\n");
    const TickInput input = readTickInputs(path).at(0).input;
    EXPECT_EQ(input.device.position, Vector3(1.0, 2.0, 3.0));
    EXPECT_EQ(input.device.maxForce, 4.0);
    EXPECT_TRUE(input.device.streams);
    EXPECT_EQ(input.device.age, 0.25);
    EXPECT_EQ(input.settings.governor.maxDeviceSpeed, 1.25);
    EXPECT_EQ(input.settings.deviceTurn, Vector3(0.5, 0.75, 0.125));
}

TEST(TickLog, RefusesADeadManSwitchThatIsNoButton) {
    for (const int button : {-2, 32}) {
        const test::ScratchFolder scratch;
        const auto path = scratch.path() / "tick_input.csv";
        TickSample sample = sampleOf(0.0);
        sample.input.settings.governor.deadManButton = button;
        TickInputWriter writer(path);
        writer.take(sample);
        writer.close();
        EXPECT_THROW((void)readTickInputs(path), InputError) << button;
    }
}

TEST(TickLog, ForceLogSaysGapStateAndFlagsInWords) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "force_log.csv";
    ForceLogWriter writer(path);
    writer.take(sampleOf(0.0));
    writer.close();
    const CsvTable table = readCsv(path);
    EXPECT_EQ(table.number(0, "gap_m"), -1e-9);
    EXPECT_EQ(table.number(0, "contact_radius_m"), 2e-9);
    EXPECT_EQ(table.number(0, "est_sigma_fy_n"), 2e-9);
    EXPECT_EQ(table.text(0, "state"), "contact");
    EXPECT_EQ(table.text(0, "flags"), "outside_scan");
    EXPECT_EQ(table.number(0, "indentation_m"), 1e-9);
}

TEST(TickLog, ForceLogSaysApproachAndRetract) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "force_log.csv";
    ForceLogWriter writer(path);
    for (const double height : {3e-9, 1e-9, 1e-9, 2e-9, 2e-9, 1.5e-9}) {
        TickSample sample;
        sample.output.base.position.z() = height;
        writer.take(sample);
    }
    writer.close();
    const CsvTable table = readCsv(path);
    std::string branches;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        branches += table.text(row, "branch") + ' ';
    }
    EXPECT_EQ(branches, "approach approach approach retract retract approach ");
}

TEST(TickLog, RefusesDamagedInputsWithTheirLine) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "tick_input.csv";
    TickInputWriter writer(path);
    writer.take(sampleOf(0.0));
    writer.close();
    std::ifstream in(path);
    std::string text((std::istreambuf_iterator<char>(in)), {});
    for (const char* bad : {"nan", "inf", "x"}) {
        std::string damaged = text;
        const std::size_t row = damaged.rfind('\n', damaged.size() - 2) + 1;
        damaged.replace(row, damaged.find(',', row) - row, bad);
        std::ofstream(path) << damaged;
        EXPECT_THROW((void)readTickInputs(path), InputError) << bad;
    }
}

TEST(TickLog, RefusesCellsThatStandForNothing) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "tick_input.csv";
    const std::string names =
        "time_s,time_step_s,device_x_m,device_y_m,device_z_m,buttons,connected,alpha_rad,theta_rad,"
        "age_s,"
        "position_gain,force_gain,correction_hz,tip_control,forces_on,rearms,device_max_force_n,"
        "device_streams,device_age_s,starts,edge_stiffness_n_m\n";
    const auto isRead = [&](const std::string& buttons, const std::string& connected,
                            const std::string& starts, const std::string& edge) {
        std::ofstream(path) << names << "0,0.001,1,2,3," << buttons << ',' << connected
                            << ",0,0,0,1,1,20,0,1,0,5,1,0," << starts << ',' << edge << '\n';
        try {
            return readTickInputs(path).size() == 1;
        } catch (const InputError&) {
            return false;
        }
    };
    EXPECT_TRUE(isRead("3", "1", "2", "200"));
    for (const char* bad : {"-1", "1e20", "1.5"}) {
        EXPECT_FALSE(isRead(bad, "1", "2", "200")) << bad;
        EXPECT_FALSE(isRead("3", "1", bad, "200")) << bad;
    }
    EXPECT_FALSE(isRead("3", "7", "2", "200"));
    EXPECT_FALSE(isRead("3", "1", "2", "-200"));
}

TEST(TickLog, KeepsANanOfTheDeviceWhichIsAFault) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "tick_input.csv";
    TickSample sample = sampleOf(0.0);
    sample.input.device.position.y() = std::numeric_limits<double>::quiet_NaN();
    sample.input.device.age = std::numeric_limits<double>::infinity();
    TickInputWriter writer(path);
    writer.take(sample);
    writer.close();
    const TickInput read = readTickInputs(path).front().input;
    EXPECT_TRUE(std::isnan(read.device.position.y()));
    EXPECT_EQ(read.device.position.x(), sample.input.device.position.x());
    EXPECT_EQ(read.device.age, sample.input.device.age);
}

TEST(TickLog, HoldsWhatWasFlushedAndReadsUpToTheLastWholeLine) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "tick_input.csv";
    TickInputWriter writer(path);
    writer.take(sampleOf(0.0));
    EXPECT_EQ(readTickInputs(path).size(), 0U);
    writer.flush();
    EXPECT_EQ(readTickInputs(path).size(), 1U);
    writer.take(sampleOf(0.001));
    writer.flush();
    writer.sync();
    for (const std::string& end :
         {std::string("0.002,0.0"), std::string("0.002"), std::string("\0\0\0\n\0", 5)}) {
        const std::string whole = test::contentOf(path);
        std::ofstream(path, std::ios::binary) << whole << end;
        EXPECT_EQ(readTickInputs(readUnfinishedCsv(path)).size(), 2U);
        std::ofstream(path, std::ios::binary) << whole;
    }
}

TEST(DevicePathFile, ReadsPositionsAndRefusesTimeThatStandsStill) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "path.csv";
    std::ofstream(path) << "# a path\ntime_s,x_m,y_m,z_m\n0,1e-9,2e-9,3e-9\n1,0,0,-1e-9\n";
    const DevicePath device = readDevicePath(path);
    ASSERT_EQ(device.size(), 2U);
    EXPECT_EQ(device[1].position.z(), -1e-9);
    for (const char* rows :
         {"0,0,0,0\n0,1,1,1\n", "-1,0,0,0\n", "0,nan,0,0\n", "inf,0,0,0\n", ""}) {
        std::ofstream(path) << "time_s,x_m,y_m,z_m\n" << rows;
        EXPECT_THROW((void)readDevicePath(path), InputError) << rows;
    }
    std::ofstream(path) << "time_s,x_m,y_m\n0,0,0\n";
    EXPECT_THROW((void)readDevicePath(path), InputError) << "z_m is missing";
}

}  // namespace
}  // namespace asperity
