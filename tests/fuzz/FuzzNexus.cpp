#include "core/Error.h"
#include "core/io/heightmap/nexus/NexusReader.h"
#include "tests/fuzz/WholeScan.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

// A NeXus scan in what the program that reads HDF5 hands over: whole channels, or an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto bytes = std::make_shared<asperity::OwnedBytes>(
        std::string(reinterpret_cast<const char*>(data), size), "content");
    const auto read = [&bytes](const std::vector<std::string>&) {
        return asperity::Hdf5Content(bytes, "fuzz");
    };
    try {
        asperity::requireWhole(asperity::readNexus("fuzz", read), *bytes);
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
