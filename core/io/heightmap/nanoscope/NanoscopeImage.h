#pragma once

#include "core/io/heightmap/ScanImage.h"
#include "core/io/heightmap/nanoscope/NanoscopeHeader.h"

#include <cstdint>
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
    std::uint64_t offset = 0;  ///< of the first sample [bytes]
    int sampleBytes = 2;
    double sizeX = 0.0;  ///< of the stored image [m]; 0: unknown
    double sizeY = 0.0;  ///< [m]
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
    /// @throw InputError when the scale or its sensitivity cannot be read
    [[nodiscard]] NanoscopeScale scale() const;
    /// As the header's file list gives it, "0x09700000"; empty: it does not.
    [[nodiscard]] std::string version() const;
    /// What a user should know: an early stop, an odd aspect ratio, earlier leveling.
    [[nodiscard]] std::vector<std::string> notes() const;
    [[nodiscard]] int bytesPerPixel() const;  ///< as the header says, 2 when it says nothing
    /// A length of the scan list, "X Offset" or "Y Offset"; 0 when it is not there [m]
    [[nodiscard]] double scanLength(const std::string& key) const;

private:
    [[nodiscard]] const std::string& require(const std::string& key) const;
    [[nodiscard]] long long integer(const std::string& key) const;
    [[nodiscard]] const std::string* findIn(const std::string& section,
                                            const std::string& key) const;
    [[nodiscard]] int storedSampleBytes() const;
    void readScanSize(NanoscopeLayout& layout) const;
    [[nodiscard]] NanoscopeScale sensitivity(const std::string& softScale,
                                             const std::string& hardUnit) const;
    [[noreturn]] void fail(const std::string& what) const;

    const std::vector<NanoscopeSection>* sections_;
    const NanoscopeSection* image_;
    std::string file_;
    std::string place_;
};

}  // namespace asperity
