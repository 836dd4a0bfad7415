#pragma once

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFile.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"
#include "core/io/heightmap/ScanImage.h"
#include "core/surface/GivenScale.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Scale that an image of numbers states; formats of pictures leave most of it open.
struct ImageScale {
    std::string title;    ///< empty: none given
    std::string unit;     ///< of the values, without prefix; empty: they are numbers
    double factor = 1.0;  ///< value = factor * sample + offset
    double offset = 0.0;
    std::optional<double> noData;  ///< the sample of pixels without data
    std::string lateralUnit;       ///< without prefix
    double sizeX = 0.0;            ///< 0: not given
    double sizeY = 0.0;
    std::string sizeSource;  ///< location of the size
    double originX = 0.0;
    double originY = 0.0;
    std::vector<std::string> notes;
    std::vector<Provenance> provenance;
};

/// Texts by their keys: "Gwy::XReal" is "1e-06".
using ImageTexts = std::map<std::string, std::string>;

/// Returns the scale in Gwyddion's keys, which it writes into pictures: XReal, YReal, XOffset,
/// YOffset, XYUnit, ZUnit, Title, each with "Gwy::" before it; for integers ZMin and ZMax, for
/// floats ZScale. Our own files have kNoDataKey as well.
/// Source: docs/formats.md 9.
/// @param type   of the samples; ZMin and ZMax are those of the smallest and the largest one
/// @param source of the texts, for provenance: "PNG text"
/// @throw InputError when a number is none
[[nodiscard]] ImageScale gwyScale(const ImageTexts& texts, SampleType type, const std::string& file,
                                  const std::string& source);

/// Takes ends of the scale: the value of the smallest and of the largest sample that the type has.
/// For integers. @param source for provenance
void setEnds(ImageScale& scale, SampleType type, double lowest, double highest,
             const std::string& source);

/// The same image with the smallest and the largest sample exchanged, as where white is zero.
/// Floats stay as they are.
void invert(ImageScale& scale, SampleType type);

/// A channel of this scale.
/// @param name where the scale has no title
/// @throw InputError when its factor or offset is no finite number
[[nodiscard]] StoredChannel scaledChannel(const ImageScale& scale, ImageSize size, ReadRow rows,
                                          const std::string& name, const std::string& file);

/// Gives the channel the values factor * number + offset of the numbers that its rows are now.
/// @throw InputError when one of the two is no number of a measurement: not finite, or beyond 1e100
void setScale(StoredChannel& stored, double factor, double offset, const std::string& file);

/// Puts a size in place of a file's, and heights in place of the numbers without unit of its
/// channels; other units stay. Notes and provenance of each channel say so.
/// @param file for messages
/// @throw InputError when heights are given and all channels have a unit: one of both is wrong
void applyScale(StoredScan& scan, const GivenScale& given, const std::string& file);

/// A channel is no height map until the user says its scale.
class MissingScale : public InputError {
public:
    /// @param path as the user gave it
    /// @param gap  something is missing
    MissingScale(const std::filesystem::path& path, const ScaleGap& gap);

    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    [[nodiscard]] const ScaleGap& gap() const { return gap_; }

private:
    std::filesystem::path path_;
    ScaleGap gap_;
};

/// @throw MissingScale when size or unit of the channel are unknown; a unit that is no length is
///        none that is missing
void requireScale(const ScanChannel& channel, const std::filesystem::path& path);

}  // namespace asperity
