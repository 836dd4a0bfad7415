#pragma once

#include "core/io/heightmap/HeaderFields.h"
#include "core/io/heightmap/SampleRows.h"

#include <optional>
#include <string>

namespace asperity {

/// Scale of numbers along an axis: value = number × increment + offset [m].
struct X3pAxis {
    double increment = 0.0;
    double offset = 0.0;
};

/// A binary file in the archive and the MD5 that main.xml gives for it.
struct X3pLink {
    std::string entry;  ///< relative to main.xml's folder; empty: there is none
    std::string md5;    ///< lower case; empty: none given
};

/// Description of a surface in main.xml.
struct X3pDescription {
    std::string revision;
    X3pAxis x;
    X3pAxis y;
    X3pAxis z;
    ImageSize size;
    int layers = 1;
    std::optional<SampleType> type;  ///< of the stored numbers; a list needs none
    X3pLink points;
    X3pLink validPoints;
    std::optional<std::string> listed;  ///< doubles from a list in main.xml; NaN: no data
    bool isRotated = false;             ///< a rotation of the axes is given
    BoundedTexts texts;

    [[nodiscard]] std::uint64_t numbers() const {
        return size.pixels() * static_cast<std::uint64_t>(layers);
    }
};

/// Reads main.xml, whatever its namespace prefix.
/// @param xml is used up
/// @param file, entry for messages
/// @throw InputError when it describes no surface on a grid, or anything does not fit together
[[nodiscard]] X3pDescription describeX3p(std::string xml, const std::string& file,
                                         const std::string& entry);

}  // namespace asperity
