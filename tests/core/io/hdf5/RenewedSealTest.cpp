#include "core/io/hdf5/Hdf5Program.h"
#include "core/io/hdf5/Hdf5TableWriter.h"
#include "tests/support/Refusal.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <random>

// A seal is no proof of who made a file: whoever damages it can renew the seal. The HDF5 library
// crashes on such files, frees what it never had, or does not come back. ASPERITY_DAMAGES says how
// many (40).

namespace asperity::test {
namespace {

class RenewedSeal : public testing::Test {
protected:
    void SetUp() override {
        Hdf5Output output(file);
        output.setAttribute("format", "asperity recording");
        Hdf5TableWriter writer(output, "log",
                               {.columns = {{.name = "z_m", .unit = "m", .sameAs = {}},
                                            {.name = "state",
                                             .unit = {},
                                             .type = Hdf5Column::Type::Text,
                                             .width = 7,
                                             .sameAs = {}}},
                                .comments = {"one"},
                                .rows = 300});
        for (int row = 0; row < 300; ++row) {
            writer.add(row / 3.0);
            writer.add(std::string_view("free"));
            writer.endRow();
        }
        writer.close();
        output.close();
        whole = contentOf(file);
    }

    /// @return whether it was read
    [[nodiscard]] bool isRead(const std::string& damaged) {
        std::ofstream(file, std::ios::binary) << damaged;
        sealHdf5(file);
        const std::string refusal = refusalOf([&] {
            const Hdf5Input input(file, {"log"});
            asperity::Hdf5Rows rows(input, "log");
            (void)input.attribute("format");
            (void)rows.comments();
            while (rows.next()) {
                (void)rows.columns();
            }
        });
        EXPECT_TRUE(refusal.empty() || refusal.starts_with(file.string() + ": ")) << refusal;
        return refusal.empty();
    }

    static int damages() {
        const char* const wanted = std::getenv("ASPERITY_DAMAGES");
        return wanted != nullptr ? std::atoi(wanted) : 40;
    }

    ScratchFolder scratch;
    std::filesystem::path file = scratch.file("a.h5");
    std::string whole;
    std::mt19937_64 random{20261129};
};

TEST_F(RenewedSeal, IsNoProofAndItsFileEndsThisProgramNever) {
    int read = 0;
    for (int i = 0; i < damages(); ++i) {
        std::string damaged = whole;
        const std::size_t offset = kSealBytes + random() % (whole.size() - kSealBytes);
        const std::size_t length = std::min<std::size_t>(1 + random() % 8, whole.size() - offset);
        for (std::size_t k = 0; k < length; ++k) {
            damaged[offset + k] = static_cast<char>(random());
        }
        read += isRead(damaged) ? 1 : 0;
    }
    std::printf("%d of %d damaged files were read\n", read, damages());
    EXPECT_TRUE(isRead(whole));
}

}  // namespace
}  // namespace asperity::test
