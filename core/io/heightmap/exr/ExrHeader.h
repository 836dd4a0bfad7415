#pragma once

#include "core/io/heightmap/ImageScale.h"

namespace asperity {

/// What the first header of an OpenEXR file says.
struct ExrHeader {
    ImageSize size;                    ///< of the data window
    BoundedTexts texts{kHeaderQuota};  ///< attributes that are texts or numbers
    bool isMultiPart = false;
};

[[nodiscard]] bool isExr(const ByteSource& bytes);

/// Walks through the attributes of all headers, so that the OpenEXR library, which believes their
/// sizes, sees none that the file does not hold. Source: "OpenEXR File Layout", openexr.com.
/// @throw InputError when one is not within the file, or the image has no possible size
[[nodiscard]] ExrHeader readExrHeader(const ByteSource& bytes);

}  // namespace asperity
