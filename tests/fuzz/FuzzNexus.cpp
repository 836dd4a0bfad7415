#include "core/Error.h"
#include "core/io/heightmap/nexus/NexusReader.h"
#include "tests/fuzz/WholeScan.h"

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// A NeXus scan in the output of the program that reads HDF5: whole channels, or an InputError. It
// is asked several times, and a damaged file may lead it astray: its later output may be
// another content, that behind the mark.

namespace {

std::shared_ptr<const asperity::ByteSource> owned(std::string_view content) {
    return std::make_shared<asperity::OwnedBytes>(std::string(content), "content");
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    constexpr std::string_view kMark = "<<later>>";
    const std::string_view whole(reinterpret_cast<const char*>(data), size);
    const std::size_t mark = whole.find(kMark);
    const auto first = owned(whole.substr(0, mark));
    const auto later =
        mark == std::string_view::npos ? first : owned(whole.substr(mark + kMark.size()));
    bool isFirst = true;
    const auto read = [&](const std::vector<std::string>&) {
        return asperity::Hdf5Content(std::exchange(isFirst, false) ? first : later, "fuzz");
    };
    try {
        asperity::requireWhole(asperity::readNexus("fuzz", read), *first);
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
