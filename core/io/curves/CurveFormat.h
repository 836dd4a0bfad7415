#pragma once

#include "core/io/ByteReader.h"
#include "core/io/curves/StoredCurves.h"

#include <array>
#include <memory>
#include <string_view>

namespace asperity {

/// A file type of force curves. A further one is a folder of its own that defines such a constant,
/// and its lines at the end of this table.
struct CurveFormat {
    std::string_view name;  ///< for people
    /// Returns whether the content is of this type, damaged or not, by a look at few bytes.
    bool (*recognizes)(const ByteSource& bytes);
    /// Finds the curves, but leaves their samples where they are; texts are read whole.
    /// @param bytes must outlive the result
    /// @throw InputError when anything is missing or does not fit together
    std::unique_ptr<StoredCurves> (*open)(const ByteSource& bytes, const CurveReadOptions& options);
};

extern const CurveFormat kJpkCurveFormat;
extern const CurveFormat kIgorCurveFormat;
extern const CurveFormat kNanoscopeCurveFormat;
extern const CurveFormat kNanosurfCurveFormat;
extern const CurveFormat kZippedTextCurveFormat;
extern const CurveFormat kChiaroCurveFormat;
extern const CurveFormat kAfmWorkshopCurveFormat;
extern const CurveFormat kNtMdtTextCurveFormat;
extern const CurveFormat kTextCurveFormat;

/// The most specific beginnings first.
inline constexpr std::array kCurveFormats{
    &kJpkCurveFormat,        &kIgorCurveFormat,   &kNanoscopeCurveFormat,
    &kNanosurfCurveFormat,   &kChiaroCurveFormat, &kAfmWorkshopCurveFormat,
    &kZippedTextCurveFormat, &kTextCurveFormat,   &kNtMdtTextCurveFormat};

}  // namespace asperity
