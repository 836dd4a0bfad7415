
#include "core/io/hdf5/Hdf5TableWriter.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace asperity::test {
namespace {

using testing::HasSubstr;

constexpr int kManyRows = 20'000;  // more than a block

class Hdf5Rows : public testing::Test {
protected:
    void write(int rows) const {
        Hdf5Output output(file);
        Hdf5TableWriter writer(
            output, "log",
            {.columns =
                 {{.name = "z_m", .unit = "m", .sameAs = {}},
                  {.name = "force_n", .unit = "N", .type = Hdf5Column::Type::Single, .sameAs = {}},
                  {.name = "state",
                   .unit = {},
                   .type = Hdf5Column::Type::Text,
                   .width = 7,
                   .sameAs = {}},
                  {.name = "a_m", .unit = {}, .sameAs = "/log/z_m"}},
             .comments = {"one", "two, too"},
             .rows = static_cast<unsigned long long>(rows)});
        for (int row = 0; row < rows; ++row) {
            writer.add(row / 3.0);
            writer.add(1.0 / (row + 1.0));
            writer.add(row % 2 == 0 ? std::string_view("free") : std::string_view("contact"));
            writer.add(0.0);
            writer.endRow();
        }
        writer.close();
        output.close();
    }

    [[nodiscard]] std::string refusal(const std::string& table = "log") const {
        return refusalOf([&] {
            const Hdf5Input input(file, {table});
            asperity::Hdf5Rows rows(input, table);
            while (rows.next()) {
            }
        });
    }

    ScratchFolder scratch;
    std::filesystem::path file = scratch.file("a.h5");
};

TEST_F(Hdf5Rows, ReadBackWhatWasWritten) {
    write(kManyRows);
    const Hdf5Input input(file, {"log"});
    asperity::Hdf5Rows rows(input, "log");
    ASSERT_EQ(rows.columns().size(), 4U);
    EXPECT_EQ(rows.columns()[0].name, "z_m") << "columns keep their order";
    EXPECT_EQ(rows.columns()[3].name, "a_m");
    EXPECT_EQ(rows.comments(), (std::vector<std::string>{"one", "two, too"}));
    for (int row = 0; row < kManyRows; ++row) {
        ASSERT_TRUE(rows.next());
        ASSERT_EQ(rows.number(0), row / 3.0);
        ASSERT_EQ(rows.number(1), static_cast<double>(static_cast<float>(1.0 / (row + 1.0))));
        ASSERT_EQ(rows.text(2), row % 2 == 0 ? "free" : "contact");
        ASSERT_EQ(rows.number(3), rows.number(0));
    }
    EXPECT_FALSE(rows.next());
}

TEST_F(Hdf5Rows, MayBeNone) {
    write(0);
    const Hdf5Input input(file, {"log"});
    asperity::Hdf5Rows rows(input, "log");
    EXPECT_EQ(rows.columns().size(), 4U);
    EXPECT_FALSE(rows.next());
}

TEST_F(Hdf5Rows, AreTheSameBytesEachTime) {
    write(100);
    const std::string first = contentOf(file);
    write(100);
    EXPECT_EQ(contentOf(file), first);
}

TEST_F(Hdf5Rows, AreRefusedWithFileAndLocation) {
    EXPECT_THAT(refusal(), HasSubstr("a.h5"));
    std::ofstream(file) << "time_s,z_m\n";
    EXPECT_THAT(refusal(), HasSubstr("expected a file in the HDF5 format"));
    write(3);
    EXPECT_THAT(refusal("input"), HasSubstr("input: there is no such table"));
    EXPECT_THAT(refusal("log/z_m"), HasSubstr("there is no such table"));
}

/// The library itself would crash on many of these.
TEST_F(Hdf5Rows, RefuseEveryByteOfDamage) {
    write(40);
    const std::string whole = contentOf(file);
    for (std::size_t offset = 0; offset < whole.size(); offset += 7) {
        std::string damaged = whole;
        damaged[offset] = static_cast<char>(damaged[offset] ^ 0x41);
        std::ofstream(file, std::ios::binary) << damaged;
        EXPECT_FALSE(refusal().empty()) << "byte " << offset;
        std::ofstream(file, std::ios::binary) << whole.substr(0, offset);
        EXPECT_FALSE(refusal().empty()) << "cut after " << offset;
    }
}

TEST_F(Hdf5Rows, AreNotThoseOfAnotherProgram) {
    write(3);
    std::ofstream(scratch.file("b.h5"), std::ios::binary) << contentOf(file).substr(512);
    file = scratch.file("b.h5");
    EXPECT_THAT(refusal(), HasSubstr("this file is another program's"));
}

}  // namespace
}  // namespace asperity::test
