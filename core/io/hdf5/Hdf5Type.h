#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>

namespace asperity {

/// What values are, in what the program asperity_hdf5_reader hands over; its bytes in that file.
enum class Hdf5Type : char {
    Real = 'f',
    Signed = 'i',
    Unsigned = 'u',
    Text = 't',   ///< of a fixed number of bytes, filled up with zeros
    Other = 'o',  ///< nothing that is handed over
};

/// How that file is made: kStart, then records. Numbers have the byte order of the machine.
///
/// kGroup     path
/// kDataset   path, values
/// kAttribute path, '@' and name, values
/// kEnd       uint64: how many records went before; then the file ends
///
/// A path is a uint32, its bytes, and as many characters. Values are their type (Hdf5Type), uint32
/// bytes of one, uint8 number of dimensions, a uint64 for each, uint8 whether they are there, and
/// then they themselves, the last dimension running fastest.
namespace hdf5_content {
inline constexpr std::string_view kStart = "asperity hdf5 content 1\n";
inline constexpr char kGroup = 'g';
inline constexpr char kDataset = 'd';
inline constexpr char kAttribute = 'a';
inline constexpr char kEnd = 'z';
inline constexpr std::size_t kMaxDimensions = 8;
inline constexpr std::size_t kMaxPath = 4096;  // [byte]
inline constexpr std::size_t kMaxItems = 100'000;
/// Largest size of all paths together, which are kept in memory.
inline constexpr std::size_t kMaxAllPaths = std::size_t{1} << 25U;  // [byte]
}  // namespace hdf5_content

/// No byte of a compressed chunk makes more bytes.
inline constexpr std::uint64_t kMaxHdf5Expansion = 1032;

}  // namespace asperity
