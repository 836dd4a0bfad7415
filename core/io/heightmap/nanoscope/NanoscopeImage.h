#pragma once

#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// Scale of an image as a NanoScope before version 4.3 states it.
struct OldScale {
    double fullScale = 1.0;  ///< value of all counts, 256 to the power of the bytes a pixel
    std::string unit;        ///< SI base unit
    std::string source;      ///< entries of the header that it comes from
};

/// List of a header that holds a parameter: that of the scanner, the scan or the controller.
enum class NanoscopeList : std::uint8_t { Scanner, Scan, Controller };
/// The text of a parameter; null when there is none.
using FindInList = std::function<const std::string*(NanoscopeList list, const std::string& key)>;

/// The scale by `Z scale: 440 nm (...)` (version 4.2), or, without it, by the parameters that the
/// kind of the image names, `Z scale height`, `Z max` and `Z sensitivity` of a height.
/// @param image the image's list
/// @return empty when neither is there, or a number of them is missing
[[nodiscard]] std::optional<OldScale> oldNanoscopeScale(const NanoscopeSection& image,
                                                        const FindInList& findInList);

/// Conversion of the samples of one NanoScope image to physical values.
struct NanoscopeScale {
    double factor = 1.0;  ///< physical value of one count
    std::string unit;     ///< "m" for lengths; others may keep a prefix ("mV")
    std::string source;   ///< entries of the header that it comes from
};

/// Position of an image in the file, and its size.
struct NanoscopeLayout {
    ImageSize size;            ///< pixels that the file stores
    int plannedRows = 0;       ///< of the scan; more than stored when it was stopped early
    bool isOfScan = false;     ///< the size is that of the scan list: the image's does not fit
    std::uint64_t offset = 0;  ///< of the first sample [bytes]
    int sampleBytes = 2;
    double sizeX = 0.0;  ///< of the stored image [m]; 0: unknown
    double sizeY = 0.0;  ///< [m]
};

/// A position in the instrument's frame [m].
struct NanoscopePosition {
    double x = 0.0;
    double y = 0.0;
};

/// Sections of a NanoScope header about one image.
class NanoscopeImage {
public:
    /// @param sections all of the header; must outlive this
    /// @param image    the "Ciao image list" among them
    /// @param list     its name, for messages
    NanoscopeImage(const std::vector<NanoscopeSection>& sections, const NanoscopeSection& image,
                   std::string file, std::string list);

    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string direction() const;
    /// @throw InputError when sizes are missing, wrong, or do not fit together
    [[nodiscard]] NanoscopeLayout layout() const;
    /// The same of an image whose samples are written as text: their number replaces the length
    /// of the data. @throw InputError the same
    [[nodiscard]] NanoscopeLayout layoutOf(std::uint64_t values) const;
    /// @throw InputError when the scale or its sensitivity cannot be read
    [[nodiscard]] NanoscopeScale scale() const;
    /// A parameter of the header's file list; empty: it has none.
    [[nodiscard]] std::string ofFile(const std::string& key) const;
    /// Returns notes for a user: an early stop, pixels that are not square, earlier leveling.
    [[nodiscard]] std::vector<std::string> notes() const;
    [[nodiscard]] int bytesPerPixel() const;  ///< as the header says, 2 when it says nothing
    /// The center of the stored image, which lies at the bottom of a scan that was stopped early;
    /// empty: the header does not give it.
    [[nodiscard]] std::optional<NanoscopePosition> center(const NanoscopeLayout& layout) const;
    [[nodiscard]] double rotation() const;  ///< of the scan [deg]
    /// A note where the image is smaller than its scan: which part of it, the header does not say.
    /// Empty: it is the scan, or the header gives no center either.
    [[nodiscard]] std::string partNote() const;

private:
    struct ScanSize {
        double x = 0.0;  ///< [m]
        double y = 0.0;  ///< [m]; as x where there is one number
    };
    /// Entries of the scan list for all images.
    struct ScanGrid {
        long long columns = 0;  ///< 0: it does not say
        long long rows = 0;     ///< the same
        bool hasAspect = false;
    };

    [[nodiscard]] const std::string& require(const std::string& key) const;
    [[nodiscard]] long long integer(const std::string& key) const;
    [[nodiscard]] ImageSize ownSize() const;
    [[nodiscard]] ScanGrid scanGrid() const;
    /// @param text one or two numbers and their unit, "84.8 84.8 ~m" or "2000 nm"; null: none
    [[nodiscard]] static std::optional<ScanSize> scanSizeIn(const std::string* text);
    /// Decides between the image's own size and that of the scan list by the length of the data.
    /// @return whether one of them fits it
    [[nodiscard]] static bool fitSize(NanoscopeLayout& layout, ImageSize own, const ScanGrid& grid,
                                      long long length);
    [[nodiscard]] const std::string* findIn(std::span<const std::string_view> sections,
                                            const std::string& key) const;
    [[nodiscard]] const std::string* findIn(NanoscopeList list, const std::string& key) const;
    [[nodiscard]] std::optional<double> scanLength(const std::string& key) const;
    [[nodiscard]] int storedSampleBytes() const;
    void readScanSize(NanoscopeLayout& layout, ImageSize own, const ScanGrid& grid) const;
    [[nodiscard]] NanoscopeScale oldScale() const;
    [[nodiscard]] NanoscopeScale sensitivity(const std::string& softScale,
                                             const std::string& hardUnit) const;
    [[noreturn]] void fail(const std::string& what) const;

    const std::vector<NanoscopeSection>* sections_;
    const NanoscopeSection* image_;
    std::string file_;
    std::string list_;
};

}  // namespace asperity
