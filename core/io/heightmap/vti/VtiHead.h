#pragma once

#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/SampleRows.h"

#include <functional>
#include <map>
#include <string>
#include <vector>

namespace asperity {

/// A rectangle of an image whose values are contiguous.
struct VtiPiece {
    int firstColumn = 0;  ///< of the image
    int firstRow = 0;     ///< from the bottom
    SampleLayout layout;  ///< in the file, or in what is decoded
    /// Returns the samples; empty: they lie in the file as they are.
    std::function<std::string()> decode;
};

/// Numbers at the points of an image.
struct VtiArray {
    std::string name;
    SampleType type = SampleType::Float32;
    std::vector<VtiPiece> pieces;  ///< that fill the image
};

/// Reads the rows of an array. @param bytes must outlive the result
[[nodiscard]] ReadRow rowsOf(const ByteSource& bytes, const VtiArray& array, int rows);

/// XML of a VTK image.
struct VtiHead {
    ImageSize size;
    double pitchX = 0.0;  ///< of a number without a unit
    double pitchY = 0.0;
    std::vector<VtiArray> arrays;
    std::string scalars;  ///< name of the array that the file marks as the one to show; empty: none
    /// Texts by their names; only those of one number a tuple and of one text.
    BoundedTexts texts{kHeaderQuota};
    std::map<std::string, std::vector<double>> numbers;  ///< as texts
    std::vector<std::string> notes;                      ///< on arrays that were left out
    std::string version;                                 ///< of the file format
};

/// Returns whether the content is an XML file of VTK, whatever it holds.
[[nodiscard]] bool isVtkXml(const ByteSource& bytes);

/// Reads the XML and checks that the arrays lie within the file.
/// @throw InputError when anything is missing or does not fit together, or when the file holds no
///        flat image with numbers at its points or cells
[[nodiscard]] VtiHead readVtiHead(const ByteSource& bytes);

}  // namespace asperity
