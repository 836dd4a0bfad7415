#include "core/io/hdf5/Hdf5Seal.h"

#include "core/Error.h"
#include "core/FormattedText.h"
#include "core/io/FileBytes.h"

#include <algorithm>
#include <boost/crc.hpp>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

namespace {

constexpr std::string_view kMark = "Asperity, HDF5 behind this block";
constexpr std::string_view kHdf5 = "\x89HDF";          // how a file without a block begins
constexpr std::size_t kPiece = std::size_t{1} << 18U;  // [byte]

std::string sealOf(const ByteSource& file) {
    boost::crc_32_type crc;
    std::vector<char> piece;
    for (std::uint64_t place = kSealBytes; place < file.size(); place += piece.size()) {
        piece.resize(
            static_cast<std::size_t>(std::min<std::uint64_t>(kPiece, file.size() - place)));
        file.read(place, piece);
        crc.process_bytes(piece.data(), piece.size());
    }
    std::string seal = std::string(kMark) + formatted(": %llu bytes, CRC-32 %08x\n",
                                                      static_cast<unsigned long long>(file.size()),
                                                      crc.checksum());
    seal.resize(kSealBytes, '\0');
    return seal;
}

}  // namespace

void sealHdf5(const std::filesystem::path& path) {
    const std::string seal = sealOf(FileBytes(path));
    std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
    file.write(seal.data(), static_cast<std::streamsize>(seal.size()));
    file.close();
    if (!file) {
        throw Error(path.string() + ": not all of it could be written");
    }
}

void requireSeal(const ByteSource& file) {
    if (!file.startsWith(kMark)) {
        throw InputError(file.name(), "",
                         file.startsWith(kHdf5)
                             ? "expected a recording in the HDF5 format: this file is another "
                               "program's, it has no check sum of Asperity's"
                             : "expected a file in the HDF5 format");
    }
    if (!file.startsWith(sealOf(file))) {
        throw InputError(file.name(), "",
                         "it is damaged, or another program has changed it: its check sum differs");
    }
}

}  // namespace asperity
