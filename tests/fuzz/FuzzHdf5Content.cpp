#include "core/Error.h"
#include "core/io/hdf5/Hdf5Content.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

// Output of the program that reads HDF5, had it gone astray: its values, or an InputError.

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    try {
        const asperity::Hdf5Content content(
            std::make_shared<asperity::OwnedBytes>(bytes, "content"), "fuzz");
        for (const asperity::Hdf5Item& item : content.items()) {
            (void)content.text(item.kind, item.path);
            if (item.offset && item.type != asperity::Hdf5Type::Text) {
                std::vector<double> numbers(std::min<std::uint64_t>(item.count, 1000));
                content.read(item, 0, numbers);
            }
        }
    } catch (const asperity::InputError&) {
        return 0;
    }
    return 0;
}
