#pragma once

#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"
#include "core/io/heightmap/nanoscope/OldScale.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace asperity {

/// How the samples of one NanoScope image become physical values.
struct NanoscopeScale {
    double factor = 1.0;  ///< physical value of one count
    std::string unit;     ///< "m" for lengths; others may keep a prefix ("mV")
    std::string source;   ///< entries of the header that it comes from
};

/// Where an image lies in the file and how large it is.
struct NanoscopeLayout {
    ImageSize size;            ///< pixels that the file stores
    int plannedRows = 0;       ///< of the scan; more than stored when it was stopped early
    bool isOfScan = false;     ///< the size is that of the scan list: the image's does not fit
    std::uint64_t offset = 0;  ///< of the first sample [bytes]
    int sampleBytes = 2;
    double sizeX = 0.0;  ///< of the stored image [m]; 0: unknown
    double sizeY = 0.0;  ///< [m]
};

/// A place in the instrument's frame [m].
struct NanoscopePlace {
    double x = 0.0;
    double y = 0.0;
};

/// What the sections of a NanoScope header say about one image.
class NanoscopeImage {
public:
    /// @param sections all of the header; must outlive this
    /// @param image    the "Ciao image list" among them
    /// @param place    of that list, for messages
    NanoscopeImage(const std::vector<NanoscopeSection>& sections, const NanoscopeSection& image,
                   std::string file, std::string place);

    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string direction() const;
    /// @throw InputError when sizes are missing, wrong, or do not fit together
    [[nodiscard]] NanoscopeLayout layout() const;
    /// The same of an image whose samples stand as text: their number takes the place of the length
    /// of the data. @throw InputError likewise
    [[nodiscard]] NanoscopeLayout layoutOf(std::uint64_t values) const;
    /// @throw InputError when the scale or its sensitivity cannot be read
    [[nodiscard]] NanoscopeScale scale() const;
    /// A parameter of the header's file list; empty: it has none.
    [[nodiscard]] std::string ofFile(const std::string& key) const;
    /// What a user should know: an early stop, pixels that are not square, earlier leveling.
    [[nodiscard]] std::vector<std::string> notes() const;
    [[nodiscard]] int bytesPerPixel() const;  ///< as the header says, 2 when it says nothing
    /// The center of the stored image, which lies at the bottom of a scan that was stopped early;
    /// empty: the header does not give it.
    [[nodiscard]] std::optional<NanoscopePlace> center(const NanoscopeLayout& layout) const;
    [[nodiscard]] double rotation() const;  ///< of the scan [deg]
    /// A note where the image is smaller than its scan: which part of it, the header does not say.
    /// Empty: it is the scan, or the header gives no center either.
    [[nodiscard]] std::string partNote() const;

private:
    struct ScanSize {
        double x = 0.0;  ///< [m]
        double y = 0.0;  ///< [m]; as x where there is one number
    };
    /// What the scan list says of all images.
    struct ScanGrid {
        long long columns = 0;  ///< 0: it does not say
        long long rows = 0;     ///< likewise
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
    std::string place_;
};

}  // namespace asperity
