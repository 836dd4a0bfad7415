#include "core/io/heightmap/HeightMapFile.h"
#include "tests/support/ScratchFolder.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkIdTypeArray.h>
#include <vtkImageData.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkRTAnalyticSource.h>
#include <vtkShortArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <tuple>
#include <vector>

// Images that VTK writes in each way that it can, read by our reader, which knows no VTK.

namespace asperity::test {

namespace {

constexpr int kColumns = 37;
constexpr int kRows = 23;

template <class Array>
vtkSmartPointer<Array> wavesOf(const char* name, int columns, int rows) {
    const vtkNew<Array> array;
    array->SetName(name);
    for (int i = 0; i < columns * rows; ++i) {
        array->InsertNextTuple1(std::floor(60.0 + 50.0 * std::sin(0.37 * i)));
    }
    return array;
}

/// An image whose extent does not begin at 0, with arrays of four types.
vtkSmartPointer<vtkImageData> wavyImage() {
    const vtkNew<vtkImageData> image;
    image->SetExtent(-3, kColumns - 4, 5, kRows + 4, 2, 2);
    image->SetSpacing(2e-9, 3e-9, 1.0);
    image->GetPointData()->AddArray(wavesOf<vtkFloatArray>("z", kColumns, kRows));
    image->GetPointData()->AddArray(wavesOf<vtkShortArray>("count", kColumns, kRows));
    image->GetPointData()->AddArray(wavesOf<vtkUnsignedCharArray>("byte", kColumns, kRows));
    image->GetPointData()->AddArray(wavesOf<vtkLongLongArray>("long", kColumns, kRows));
    return image;
}

std::vector<double> topFirst(vtkDataArray& values, int columns, int rows) {
    std::vector<double> heights;
    for (int row = rows - 1; row >= 0; --row) {
        for (int column = 0; column < columns; ++column) {
            heights.push_back(values.GetTuple1(row * columns + column));
        }
    }
    return heights;
}

void expectSame(const HeightMapFile& file, vtkDataSetAttributes& arrays, int columns, int rows) {
    ASSERT_EQ(file.channels.size(), static_cast<std::size_t>(arrays.GetNumberOfArrays()));
    for (int i = 0; i < arrays.GetNumberOfArrays(); ++i) {
        const ScanChannel& channel = file.channels[static_cast<std::size_t>(i)];
        EXPECT_EQ(channel.name, arrays.GetArray(i)->GetName());
        EXPECT_EQ(channel.map.columns, columns);
        EXPECT_EQ(channel.map.heights, topFirst(*arrays.GetArray(i), columns, rows));
    }
}

enum class Encoding : std::uint8_t { Text, Inline, AppendedBase64, AppendedRaw };

using Written = std::tuple<Encoding, int, int, int, int>;

}  // namespace

/// Encoding, compressor, bytes of a head's number, order of bytes, pieces.
class VtiOfVtk : public testing::TestWithParam<Written> {};

TEST_P(VtiOfVtk, HasTheSamePixels) {
    const auto [encoding, compressor, headBytes, order, pieces] = GetParam();
    const ScratchFolder folder;
    const vtkSmartPointer<vtkImageData> image = wavyImage();
    const vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(folder.file("image.vti").c_str());
    writer->SetInputData(image);
    writer->SetDataMode(encoding == Encoding::Text     ? vtkXMLWriter::Ascii
                        : encoding == Encoding::Inline ? vtkXMLWriter::Binary
                                                       : vtkXMLWriter::Appended);
    writer->SetEncodeAppendedData(encoding == Encoding::AppendedBase64);
    writer->SetCompressorType(compressor);
    writer->SetBlockSize(512);
    writer->SetHeaderType(headBytes);
    writer->SetByteOrder(order);
    writer->SetNumberOfPieces(pieces);
    ASSERT_EQ(writer->Write(), 1);
    const HeightMapFile file = readHeightMapFile(folder.file("image.vti"));
    expectSame(file, *image->GetPointData(), kColumns, kRows);
    EXPECT_TRUE(file.notes.empty());
}

INSTANTIATE_TEST_SUITE_P(
    Each, VtiOfVtk,
    testing::Combine(testing::Values(Encoding::Text, Encoding::Inline, Encoding::AppendedBase64,
                                     Encoding::AppendedRaw),
                     testing::Values(vtkXMLWriter::NONE, vtkXMLWriter::ZLIB, vtkXMLWriter::LZ4,
                                     vtkXMLWriter::LZMA),
                     testing::Values(vtkXMLWriter::UInt32, vtkXMLWriter::UInt64),
                     testing::Values(vtkXMLWriter::LittleEndian, vtkXMLWriter::BigEndian),
                     testing::Values(1, 4)));

TEST(VtiOfVtkPieces, AreOneImage) {
    const ScratchFolder folder;
    const vtkNew<vtkRTAnalyticSource> source;
    source->SetWholeExtent(-11, 20, -8, 9, 0, 0);
    const vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(folder.file("image.vti").c_str());
    writer->SetInputConnection(source->GetOutputPort());
    writer->SetNumberOfPieces(7);
    ASSERT_EQ(writer->Write(), 1);
    source->UpdateWholeExtent();
    expectSame(readHeightMapFile(folder.file("image.vti")), *source->GetOutput()->GetPointData(),
               32, 18);
}

TEST(VtiOfVtkCells, AreReadWhereThePointsHaveNoValues) {
    const ScratchFolder folder;
    const vtkSmartPointer<vtkImageData> image = wavyImage();
    image->GetPointData()->Initialize();
    image->GetCellData()->AddArray(wavesOf<vtkFloatArray>("z", kColumns - 1, kRows - 1));
    const vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(folder.file("image.vti").c_str());
    writer->SetInputData(image);
    writer->SetNumberOfPieces(3);
    ASSERT_EQ(writer->Write(), 1);
    expectSame(readHeightMapFile(folder.file("image.vti")), *image->GetCellData(), kColumns - 1,
               kRows - 1);
}

TEST(VtiOfVtkIds, AreNoHeights) {
    const ScratchFolder folder;
    const vtkSmartPointer<vtkImageData> image = wavyImage();
    image->GetPointData()->AddArray(wavesOf<vtkIdTypeArray>("numbers", kColumns, kRows));
    const vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetFileName(folder.file("image.vti").c_str());
    writer->SetInputData(image);
    ASSERT_EQ(writer->Write(), 1);
    const HeightMapFile file = readHeightMapFile(folder.file("image.vti"));
    EXPECT_EQ(file.channels.size(), 4U);
    ASSERT_EQ(file.notes.size(), 1U);
    EXPECT_NE(file.notes[0].find("'numbers' holds ids"), std::string::npos) << file.notes[0];
}

TEST(VtiOfVtkFields, AreReadInEachEncoding) {
    const vtkSmartPointer<vtkImageData> image = wavyImage();
    image->GetPointData()->RemoveArray("count");
    image->GetPointData()->RemoveArray("byte");
    image->GetPointData()->RemoveArray("long");
    const vtkNew<vtkStringArray> unit;
    unit->SetName("unit");
    unit->InsertNextValue("nm");
    image->GetFieldData()->AddArray(unit);
    for (const int mode : {vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended}) {
        const ScratchFolder folder;
        const vtkNew<vtkXMLImageDataWriter> writer;
        writer->SetFileName(folder.file("image.vti").c_str());
        writer->SetInputData(image);
        writer->SetDataMode(mode);
        ASSERT_EQ(writer->Write(), 1);
        const HeightMapFile file = readHeightMapFile(folder.file("image.vti"));
        ASSERT_EQ(file.channels.size(), 1U) << mode;
        EXPECT_EQ(file.channels[0].unit, "m") << mode;
    }
}

}  // namespace asperity::test
