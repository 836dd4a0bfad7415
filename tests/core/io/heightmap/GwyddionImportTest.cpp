#include "core/io/ByteReader.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/io/heightmap/gwyddion/Identification.h"
#include "tests/core/io/heightmap/SyntheticScans.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

// Files that no format of ours recognizes: read by a program that does what it is told in place of
// Gwyddion, and by Gwyddion where it is installed.

/// Skips the calling test where the program is not installed.
#define ASPERITY_NEEDS_GWYDDION()                                                                  \
    if (installedGwyddion().program.empty()) GTEST_SKIP() << "gwyddion is not installed"

namespace asperity::test {

namespace {

using namespace std::chrono_literals;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* kContent = "content that no format knows";
constexpr const char* kIdentified = "echo \"$2: Some data (.xyz) [somefile, 90]\"";

/// A folder with a program `gwyddion` that is a script.
class FakeGwyddion {
public:
    /// @param identify, convert what it does with each option; $2 is the file, $out the .gwy
    FakeGwyddion(const std::string& identify, const std::string& convert) {
        const std::filesystem::path program = folder_.write(
            "gwyddion", "#!/bin/sh\necho \"$HOME\" >\"$(dirname \"$0\")/home\"\ncase \"$1\" "
                        "in\n--version) echo 'Gwyddion 9.87 (2030-01-01)';;\n"
                        "--identify) " +
                            identify + ";;\n--convert-to-gwy=*) out=\"${1#--convert-to-gwy=}\"; " +
                            convert + ";;\n*) exit 9;;\nesac\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
    }

    [[nodiscard]] Gwyddion program(std::chrono::milliseconds timeout = 20s) const {
        Gwyddion found = gwyddionIn("/nowhere:" + folder_.path().string());
        found.timeout = timeout;
        return found;
    }
    [[nodiscard]] const ScratchFolder& folder() const { return folder_; }
    /// Returns whether the folder that the program worked in is gone.
    [[nodiscard]] bool leftNothing() const {
        const std::string home = contentOf(folder_.file("home"));
        return !home.empty() && !std::filesystem::exists(home.substr(0, home.find('\n')));
    }

private:
    ScratchFolder folder_;
};

/// Converts everything to this content.
class ConvertingGwyddion : public FakeGwyddion {
public:
    explicit ConvertingGwyddion(const std::string& gwy, const char* identified = kIdentified)
        : FakeGwyddion(identified, "cp \"$(dirname \"$0\")/result\" \"$out\"") {
        (void)folder().write("result", gwy);
    }
};

HeightMapFile readByGwyddion(const Gwyddion& gwyddion, const std::string& content = kContent) {
    return readHeightMapBytes(content, "some folder/scan.xyz", gwyddion);
}

std::string refusalOfImport(const Gwyddion& gwyddion, const std::string& content = kContent) {
    return refusalOf([&] { (void)readByGwyddion(gwyddion, content); });
}

std::string smallGwy() { return gwyFile(gwyComponent("/0/data", smallGwyField())); }

/// A file of 4 x 3 doubles; no format of ours reads NRRD.
std::string nrrd(const std::string& fields) {
    std::string bytes = "NRRD0004\ntype: double\ndimension: 2\nsizes: 4 3\nendian: little\n"
                        "encoding: raw\n" +
                        fields + "\n";
    for (int i = 0; i < 12; ++i) {
        appendLittleEndian(bytes, i * 1e-9);
    }
    return bytes;
}

constexpr const char* kNrrdMeters =
    "spacings: 1e-9 2e-9\nunits: \"m\" \"m\"\nsample units: \"m\"\n";

}  // namespace

TEST(GwyddionImport, ReadsWhatGwyddionConverts) {
    const ConvertingGwyddion fake(smallGwy());
    const HeightMapFile file = readByGwyddion(fake.program());
    EXPECT_EQ(file.format, "Some data (.xyz), through Gwyddion 9.87");
    ASSERT_EQ(file.channels.size(), 1U);
    EXPECT_EQ(file.channels[0].map.at(2, 0), 5e-9);
    ASSERT_FALSE(file.provenance.empty());
    EXPECT_EQ(file.provenance.back().value, "through Gwyddion 9.87, its module somefile");
    EXPECT_THAT(file.provenance.back().source, HasSubstr("90"));
}

TEST(GwyddionImport, NativeFormatsGoFirst) {
    const FakeGwyddion fake("touch \"$(dirname \"$0\")/asked\"", "exit 1");
    EXPECT_EQ(readByGwyddion(fake.program(), smallGwy()).format, "Gwyddion .gwy");
    EXPECT_THAT(refusalOfImport(fake.program(), "GWYP damaged"), Not(IsEmpty()));
    EXPECT_FALSE(std::filesystem::exists(fake.folder().file("asked")));
}

TEST(GwyddionImport, HeightsAreReadWhenTheFolderIsGone) {
    const ConvertingGwyddion fake(smallGwy());
    const ScratchFolder folder;
    const ScanFile file(folder.write("scan.xyz", kContent), {}, fake.program());
    EXPECT_TRUE(fake.leftNothing());
    EXPECT_EQ(file.readHeightChannel("").channel.map.at(0, 1), 2e-9);
}

TEST(GwyddionImport, WithoutTheProgramTheMessageNamesThePackage) {
    EXPECT_THAT(refusalOfImport({}),
                AllOf(StartsWith("some folder/scan.xyz: byte 0: this is no height map"),
                      HasSubstr("the Debian package gwyddion")));
}

TEST(GwyddionImport, NamesFormatsThatAreKnownButNotRead) {
    const std::string hdf5 = "\x89HDF\r\n\x1A\n";
    EXPECT_THAT(refusalOfImport({}, hdf5), HasSubstr("this is an HDF5 file of no known kind"));
    EXPECT_THAT(refusalOfImport({}, hdf5 + "position-pattern.grid.ulength"),
                HasSubstr("this is an HDF5 file of JPK (.h5-jpk)"));
    EXPECT_THAT(refusalOfImport({}, hdf5 + std::string(2 << 20, ' ') + "nsf_file_version_major"),
                HasSubstr("this is an HDF5 file of Nanosurf (.nhf)"));
    EXPECT_THAT(refusalOfImport({}, hdf5 + "_NCProperties NX_class"),
                HasSubstr("this is a netCDF 4 file"));
    EXPECT_THAT(refusalOfImport({}, hdf5 + "NX_class NXxas"),
                HasSubstr("this is a NeXus file of no NXafm"));
    EXPECT_THAT(refusalOfImport({}, "\x01\xB0\x93\xFF"), HasSubstr("this is an NT-MDT file"));
    EXPECT_THAT(refusalOfImport({}, "ISO/TC 201 SPM data transfer format\r\n"),
                HasSubstr("this is an ISO 28600 file"));
    // Refusals name Gwyddion only where it reads the file.
    EXPECT_THAT(refusalOfImport({}, "ISO/TC 201 SPM data transfer format\r\n"),
                HasSubstr("gwyddion it is read"));
    EXPECT_THAT(refusalOfImport({}, "\x89HDF\r\n\x1A\n"), Not(HasSubstr("package")));
    EXPECT_THAT(refusalOfImport({}, "\x1F\x8B packed"), Not(HasSubstr("package")));
    const FakeGwyddion fake("echo \"$2: Unknown\"; exit 1", "exit 1");
    EXPECT_THAT(refusalOfImport(fake.program(), "\x89HDF\r\n\x1A\n"),
                AllOf(HasSubstr("this is an HDF5 file"), HasSubstr("Gwyddion does not recognize")));
}

/// With Gwyddion they would be read as well as without: not at all.
TEST(GwyddionImport, PicturesAreRefusedAsSuchWithAndWithoutTheProgram) {
    for (const char* picture : {"\xFF\xD8\xFF\xE0 JFIF", "GIF89a", "%PDF-1.4\n"}) {
        EXPECT_THAT(refusalOfImport({}, picture),
                    AllOf(HasSubstr("byte 0: this is a picture"), HasSubstr("no heights"),
                          Not(HasSubstr("package"))));
    }
}

TEST(GwyddionImport, RefusesWhatGwyddionDoesNotKnowOrGuesses) {
    const FakeGwyddion unknown("echo \"$2: Unknown\"; exit 1", "exit 1");
    EXPECT_THAT(refusalOfImport(unknown.program()), HasSubstr("Gwyddion does not recognize it"));
    const FakeGwyddion silent("exit 1", "exit 1");
    EXPECT_THAT(refusalOfImport(silent.program()), HasSubstr("Gwyddion does not recognize it"));
    const FakeGwyddion guess("echo \"$2: Thermo Fisher SPC files [spcfile, 49]\"", "exit 1");
    EXPECT_THAT(refusalOfImport(guess.program()),
                AllOf(HasSubstr("Gwyddion only guesses"), HasSubstr("Thermo Fisher SPC files"),
                      HasSubstr("49 of 100")));
    const FakeGwyddion picture("echo \"$2: Windows or OS2 Bitmap (.bmp) [bmp, 70]\"", "exit 1");
    EXPECT_THAT(refusalOfImport(picture.program()), HasSubstr("this is a picture"));
}

TEST(GwyddionImport, QuotesWhyGwyddionFails) {
    const FakeGwyddion fails(kIdentified,
                             "echo warning; echo \"$2: Data are compressed.\"; exit 1");
    EXPECT_THAT(
        refusalOfImport(fails.program()),
        AllOf(HasSubstr("module somefile"), HasSubstr("cannot read it: Data are compressed.")));
    const FakeGwyddion crashes(kIdentified, "kill -SEGV $$");
    EXPECT_THAT(refusalOfImport(crashes.program()), HasSubstr("it crashed"));
    const FakeGwyddion forgets(kIdentified, "exit 0");
    EXPECT_THAT(refusalOfImport(forgets.program()), HasSubstr("cannot read it"));
}

TEST(GwyddionImport, EndsAProgramThatHangsOrPrintsWithoutEnd) {
    const FakeGwyddion hangs(kIdentified, "sleep 100");
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_THAT(refusalOfImport(hangs.program(300ms)), HasSubstr("did not end within 0.3 s"));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 90s);
    const FakeGwyddion talks("yes", "exit 1");
    EXPECT_THAT(refusalOfImport(talks.program()), HasSubstr("printed messages without end"));
    EXPECT_TRUE(hangs.leftNothing());
    EXPECT_TRUE(talks.leftNothing());
}

TEST(GwyddionImport, RefusesAGwyThatIsNone) {
    EXPECT_THAT(refusalOfImport(ConvertingGwyddion("text").program()), HasSubstr("no .gwy file"));
    EXPECT_THAT(refusalOfImport(ConvertingGwyddion("").program()),
                AllOf(StartsWith("some folder/scan.xyz: "), HasSubstr("empty")));
    EXPECT_THAT(refusalOfImport(ConvertingGwyddion(smallGwy().substr(0, 100)).program()),
                AllOf(StartsWith("some folder/scan.xyz: as Gwyddion converts it: byte "),
                      HasSubstr("truncated")));
    EXPECT_THAT(refusalOfImport(ConvertingGwyddion(gwyFile("")).program()), HasSubstr("no image"));
    EXPECT_THAT(refusalOfImport(FakeGwyddion(kIdentified, "mkdir \"$out\"").program()),
                HasSubstr("this is a folder"));
    EXPECT_THAT(refusalOfImport(FakeGwyddion(kIdentified, "mkfifo \"$out\"").program()),
                HasSubstr("not a regular file"));
}

TEST(GwyddionImport, GivesTheContentUnderAPlainNameWithItsEnding) {
    const FakeGwyddion fake("cp \"$2\" \"$(dirname \"$0\")/seen\"; basename \"$2\" >\"$(dirname "
                            "\"$0\")/name\"; exit 1",
                            "exit 1");
    (void)refusalOf(
        [&] { (void)readHeightMapBytes(kContent, "/a/-x \n\xFFy'.TF0", fake.program()); });
    EXPECT_EQ(contentOf(fake.folder().file("seen")), kContent);
    EXPECT_EQ(contentOf(fake.folder().file("name")), "-x___y_.TF0\n");
}

TEST(GwyddionImport, UnitOfTheFilesOwnMetadataWins) {
    const auto imported = [](const std::string& title, const std::string& key,
                             const std::string& unit) {
        const std::string meta = gwyObjectBytes("GwyContainer", gwyText(key, unit));
        const ConvertingGwyddion gwyddion(gwyFile(gwyComponent("/0/data", smallGwyField()) +
                                                  gwyText("/0/data/title", title) +
                                                  gwyComponent("/0/meta", meta)));
        return readByGwyddion(gwyddion.program()).channels.at(0);
    };
    const ScanChannel current = imported("Channel 2", "Z units", "pA");
    EXPECT_EQ(current.unit, "A");
    EXPECT_DOUBLE_EQ(current.map.at(0, 0), 1e-9);
    EXPECT_THAT(current.notes, testing::Contains(HasSubstr("metadata")));
    EXPECT_EQ(imported("Forward", "Channel::DataUnit", "A").unit, "A");
    EXPECT_EQ(imported("Topography", "Z units", "A").unit, "m");  // ångström
    EXPECT_EQ(imported("Height", "Z units", "nm").unit, "m");
    EXPECT_EQ(imported("Height", "Comment", "A").unit, "m");
    EXPECT_EQ(imported("Height", "Z units", "parsec").unit, "m");
    const ScanChannel voltage = imported("Channel 3", "ZUnits", "Volt");
    EXPECT_EQ(voltage.unit, "V");
    EXPECT_THAT(voltage.notes, testing::Contains(HasSubstr("name 'Volt'")));
}

/// Without a unit Gwyddion keeps the numbers of the file.
TEST(GwyddionImport, UnitOfTheFilesOwnMetadataScalesNumbersWithoutOne) {
    const auto imported = [](const std::string& title, const std::string& unit,
                             const std::string& own) {
        const std::string field = gwyObjectBytes(
            "GwyDataField", gwyInteger("xres", 2) + gwyInteger("yres", 1) +
                                gwyNumber("xreal", 4e-9) + gwyNumber("yreal", 2e-9) +
                                gwyUnit("si_unit_xy", "m") + gwyUnit("si_unit_z", unit) +
                                gwyNumbers("data", {5.0, 7.0}));
        const std::string meta = gwyObjectBytes("GwyContainer", gwyText("Unit", own));
        const ConvertingGwyddion gwyddion(gwyFile(gwyComponent("/0/data", field) +
                                                  gwyText("/0/data/title", title) +
                                                  gwyComponent("/0/meta", meta)));
        return readByGwyddion(gwyddion.program()).channels.at(0);
    };
    const ScanChannel height = imported("Height", "", "nm");
    EXPECT_EQ(height.unit, "m");
    EXPECT_DOUBLE_EQ(height.map.at(0, 1), 7e-9);
    EXPECT_THAT(height.notes, testing::Contains(HasSubstr("no unit, but the file's metadata name "
                                                          "'nm'")));
    EXPECT_EQ(std::ranges::count(height.provenance, "scale", &Provenance::what), 1);
    EXPECT_DOUBLE_EQ(imported("Height", "", "A").map.at(0, 0), 5e-10);  // ångström
    EXPECT_DOUBLE_EQ(imported("Topography", "A", "A").map.at(0, 0), 5e-10);
    EXPECT_EQ(imported("Topography", "A", "A").unit, "m");
    EXPECT_DOUBLE_EQ(imported("Channel 3", "", "mV").map.at(0, 0), 5e-3);
    EXPECT_EQ(imported("Height", "", "parsec").unit, "");
}

TEST(GwyddionImport, PhaseOfMetroProIsTheHeightMap) {
    const std::string gwy =
        gwyFile(gwyComponent("/0/data", smallGwyField()) + gwyText("/0/data/title", "Phase"));
    const ConvertingGwyddion metroPro(gwy, "echo \"$2: MetroPro files (.dat) [metropro, 100]\"");
    const HeightMapFile file = readByGwyddion(metroPro.program());
    EXPECT_NO_THROW((void)heightChannel(file, "scan.dat", ""));
    EXPECT_THAT(heightChannels(file), testing::ElementsAre("Phase"));
    const ConvertingGwyddion other(gwy);
    EXPECT_THROW((void)heightChannel(readByGwyddion(other.program()), "scan.dat", ""), InputError);
}

TEST(GwyddionImport, CurvesAreNamedAsSuch) {
    const std::string graph = gwyObjectBytes("GwyGraphModel", "");
    const ConvertingGwyddion gwyddion(gwyFile(gwyComponent("/0/graph/graph/1", graph)));
    EXPECT_THAT(refusalOfImport(gwyddion.program()), HasSubstr("force curves"));
}

TEST(GwyddionImport, ASizeOfOneIsWhatGwyddionInvents) {
    const std::string image = gwyObjectBytes(
        "GwyDataField", gwyInteger("xres", 2) + gwyInteger("yres", 1) + gwyNumber("xreal", 1.0) +
                            gwyNumber("yreal", 1.0) + gwyUnit("si_unit_xy", "m") +
                            gwyUnit("si_unit_z", "m") + gwyNumbers("data", {1e-9, 2e-9}));
    const HeightMapFile file =
        readByGwyddion(ConvertingGwyddion(gwyFile(gwyComponent("/0/data", image))).program());
    EXPECT_FALSE(file.channels.at(0).hasSize());
    EXPECT_THAT(file.channels.at(0).notes.at(0), HasSubstr("taken as unknown"));
}

/// 49 times a 49th of 1 is not exactly 1.
TEST(GwyddionImport, AnInventedSizeIsKnownWhateverTheNumberOfPixels) {
    const std::string image =
        gwyObjectBytes("GwyDataField", gwyInteger("xres", 49) + gwyInteger("yres", 1) +
                                           gwyNumber("xreal", 1.0) + gwyNumber("yreal", 1.0) +
                                           gwyUnit("si_unit_xy", "m") + gwyUnit("si_unit_z", "m") +
                                           gwyNumbers("data", std::vector<double>(49, 1e-9)));
    const HeightMapFile file =
        readByGwyddion(ConvertingGwyddion(gwyFile(gwyComponent("/0/data", image))).program());
    EXPECT_FALSE(file.channels.at(0).hasSize());
    for (const Provenance& entry : file.channels.at(0).provenance) {
        EXPECT_NE(entry.what, "lateral size");
    }
}

TEST(GwyddionImport, TheProgramIsTheFirstOfThePath) {
    const FakeGwyddion fake("exit 1", "exit 1");
    const ScratchFolder other;
    (void)other.write("gwyddion", "not executable");
    const std::string folder = fake.folder().path().string();
    EXPECT_EQ(gwyddionIn("relative::" + other.path().string() + ":" + folder + ":/usr/bin").program,
              fake.folder().file("gwyddion"));
    EXPECT_TRUE(gwyddionIn("").program.empty());
    EXPECT_TRUE(gwyddionIn(other.path().string()).program.empty());
}

TEST(GwyddionIdentification, IsReadFromTheLineOfTheFile) {
    const auto found = identificationIn(
        "(process:1): Module-WARNING: x [y, 1]\n\n/t/a.x: Files [old] of X (.x) [xfile, 100]\n",
        "/t/a.x");
    ASSERT_TRUE(found);
    EXPECT_EQ(found->name, "Files [old] of X (.x)");
    EXPECT_EQ(found->module, "xfile");
    EXPECT_EQ(found->score, 100);
    for (const char* output : {"", "\n", "/t/a.x: Unknown\n", "/t/a.x: [", "/t/a.x: a, b]",
                               "/t/a.x: X [x, y]", "/t/a.x: X [x, -1]", "/t/b.x: X [x, 100]"}) {
        EXPECT_FALSE(identificationIn(output, "/t/a.x")) << output;
    }
    EXPECT_EQ(versionIn("Gwyddion 2.62 (2022-11-03)\n"), "2.62");
    EXPECT_EQ(versionIn("none"), "");
}

TEST(GwyddionImport, TheInstalledProgramReadsNrrd) {
    ASPERITY_NEEDS_GWYDDION();
    const HeightMapFile file = readByGwyddion(installedGwyddion(), nrrd(kNrrdMeters));
    EXPECT_THAT(file.format, AllOf(HasSubstr("NRRD"), HasSubstr("through Gwyddion 2.")));
    EXPECT_THAT(file.provenance.back().value, HasSubstr("its module nrrdfile"));
    const ScanChannel& channel = heightChannel(file, "scan.xyz", "");
    EXPECT_EQ(channel.map.columns, 4);
    EXPECT_EQ(channel.map.rows, 3);
    EXPECT_NEAR(channel.map.pitchX, 1e-9, 1e-18);
    EXPECT_NEAR(channel.map.pitchY, 2e-9, 1e-18);
    EXPECT_DOUBLE_EQ(channel.map.at(2, 1), 9e-9);
}

TEST(GwyddionImport, TheInstalledProgramRefusesInWords) {
    ASPERITY_NEEDS_GWYDDION();
    EXPECT_THAT(refusalOfImport(installedGwyddion()), HasSubstr("Gwyddion does not recognize it"));
    EXPECT_THAT(refusalOfImport(installedGwyddion(), nrrd(kNrrdMeters).substr(0, 200)),
                AllOf(HasSubstr("module nrrdfile"), HasSubstr("cannot read it: ")));
    const std::string gray = "P5\n8 8\n255\n" + std::string(64, 'x');
    EXPECT_THAT(refusalOfImport(installedGwyddion(), gray), HasSubstr("this is a picture"));
}

}  // namespace asperity::test
