#include "vtkplugins/io/StlWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "vtkplugins/io/HeightMesh.h"

#include <vtkByteSwap.h>
#include <vtkErrorCode.h>
#include <vtkNew.h>
#include <vtkSTLWriter.h>

#include <algorithm>
#include <cstdint>
#include <fstream>

namespace asperity {

namespace {

constexpr int kStripRows = 16;          // of squares between pixels
constexpr std::streamoff kHeader = 80;  // a text [bytes]; the number of triangles follows it

/// Rows of the map from one counted from below upwards; `map` must outlive them.
HeightRows stripOf(const HeightRows& map, int rowsBelow) {
    HeightRows strip = map;
    strip.rows = std::min(kStripRows + 1, map.rows - rowsBelow);
    const int top = map.rows - rowsBelow - strip.rows;
    strip.readRow = [&map, top](int row, double* heights) { map.readRow(top + row, heights); };
    return strip;
}

/// One STL file out of those of strips.
class JoinedStl {
public:
    explicit JoinedStl(const std::filesystem::path& target)
        : stream_(target, std::ios::binary), strip_(target) {
        writer_->SetFileTypeToBinary();
        writer_->SetHeader("Asperity height map; one unit is one meter");
        writer_->SetFileName(strip_.path().c_str());
    }

    void add(vtkPolyData* mesh) {
        writer_->SetInputData(mesh);
        requireWritten(writer_->Write() != 0 && writer_->GetErrorCode() == vtkErrorCode::NoError);
        std::ifstream strip(strip_.path(), std::ios::binary);
        if (triangles_ > 0) {
            strip.seekg(kHeader + static_cast<std::streamoff>(sizeof triangles_));
        }
        stream_ << strip.rdbuf();
        requireWritten(stream_.good());
        triangles_ += static_cast<std::uint32_t>(mesh->GetNumberOfPolys());
    }

    void close() {
        std::uint32_t count = triangles_;
        vtkByteSwap::Swap4LE(&count);
        stream_.seekp(kHeader);
        stream_.write(reinterpret_cast<const char*>(&count), sizeof count);
        stream_.close();
        requireWritten(stream_.good());
    }

    [[nodiscard]] bool isEmpty() const { return triangles_ == 0; }

private:
    std::ofstream stream_;
    TemporaryFile strip_;
    vtkNew<vtkSTLWriter> writer_;
    std::uint32_t triangles_ = 0;
};

}  // namespace

void writeStl(const std::filesystem::path& target, const HeightRows& map, Progress* progress) {
    JoinedStl joined(target);
    for (int rowsBelow = 0; rowsBelow + 1 < map.rows; rowsBelow += kStripRows) {
        const HeightRows strip = stripOf(map, rowsBelow);
        const auto heights = heightArray(strip, nullptr);
        const auto mesh = meshOf(strip, heights, rowsBelow, nullptr);
        if (mesh->GetNumberOfPolys() > 0) {
            joined.add(mesh);
        }
        reportTo(progress, static_cast<double>(rowsBelow + strip.rows) / map.rows);
    }
    if (joined.isEmpty()) {
        throw Error(kNoTriangles);
    }
    joined.close();
    reportTo(progress, 1.0);
}

}  // namespace asperity
