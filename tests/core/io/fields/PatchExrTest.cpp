#include "core/io/fields/PatchExr.h"

#include "core/Error.h"
#include "tests/support/ScratchFolder.h"

#include <gtest/gtest.h>

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <vector>

namespace asperity {
namespace {

/// 3 x 2 points, 2 nm apart; the upper row is drawn up by 0.5 nm.
SurfacePatch smallPatch() {
    SurfacePatch patch{.columns = 3, .rows = 2};
    for (int row = 0; row < 2; ++row) {
        for (int column = 0; column < 3; ++column) {
            const Vector3 rest(10e-9 + column * 2e-9, 20e-9 + row * 2e-9, column * 1e-9);
            patch.rest.push_back(rest);
            patch.points.emplace_back(rest + Vector3(0.0, 0.0, row * 0.5e-9));
            patch.normals.emplace_back(Vector3::UnitZ());
        }
    }
    return patch;
}

std::vector<float> plane(Imf::InputFile& file, const char* name) {
    std::vector<float> values(6);
    Imf::FrameBuffer frame;
    frame.insert(name, Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(values.data()), sizeof(float),
                                  3 * sizeof(float)));
    file.setFrameBuffer(frame);
    file.readPixels(0, 1);
    return values;
}

TEST(PatchExr, HoldsHeightDisplacementAndNormalTopRowFirst) {
    const test::ScratchFolder scratch;
    const auto path = scratch.path() / "patch.exr";
    writePatchExr(path, smallPatch());
    Imf::InputFile file(path.c_str());
    EXPECT_EQ(plane(file, "displacement.z"),
              (std::vector<float>{0.5e-9F, 0.5e-9F, 0.5e-9F, 0.0F, 0.0F, 0.0F}));
    EXPECT_FLOAT_EQ(plane(file, "height")[2], 2.5e-9F);
    EXPECT_FLOAT_EQ(plane(file, "rest.height")[2], 2e-9F);
    EXPECT_EQ(plane(file, "normal.z")[0], 1.0F);
    const Imf::Header& header = file.header();
    EXPECT_EQ(header.channels().findChannel("height")->type, Imf::FLOAT);
    EXPECT_DOUBLE_EQ(header.typedAttribute<Imf::DoubleAttribute>("originX").value(), 10e-9);
    EXPECT_DOUBLE_EQ(header.typedAttribute<Imf::DoubleAttribute>("sizeX").value(), 4e-9);
    EXPECT_DOUBLE_EQ(header.typedAttribute<Imf::DoubleAttribute>("sizeY").value(), 2e-9);
}

TEST(PatchExr, LeavesNothingWhereItCannotWrite) {
    EXPECT_THROW(writePatchExr("/nonexistent/patch.exr", smallPatch()), Error);
}

}  // namespace
}  // namespace asperity
