#include "app/recording/Bundle.h"
#include "core/Error.h"
#include "core/TemporaryFile.h"
#include "tests/core/io/heightmap/ZipFiles.h"

#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

// A bundle, or its directory alone: in the archive, a CRC stops what a fuzzer changes in it. Files
// in its folder, or an InputError.

namespace {

std::string bundleOf(std::string_view bytes) {
    if (bytes.starts_with("PK")) {
        return std::string(bytes);
    }
    return asperity::test::zipFile({{"bundle.json", std::string(bytes)},
                                    {"summary.json", "hello"},
                                    {"force_log.csv", "", false},
                                    {"scan/a.gsf", "hello", false}});
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): the name that libFuzzer calls
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const asperity::PrivateFolder scratch;
    const std::filesystem::path bundle = scratch.path() / "bundle.zip";
    const std::filesystem::path folder = scratch.path() / "run";
    std::ofstream(bundle, std::ios::binary)
        << bundleOf({reinterpret_cast<const char*>(data), size});
    std::filesystem::create_directory(folder);
    try {
        asperity::unpackBundle(bundle, folder);
    } catch (const asperity::InputError&) {
    }
    std::filesystem::remove_all(folder);
    std::filesystem::remove(bundle);
    if (!std::filesystem::is_empty(scratch.path())) {
        std::abort();  // a file beside its folder
    }
    return 0;
}
