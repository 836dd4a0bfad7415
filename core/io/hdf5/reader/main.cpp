#include "core/io/hdf5/reader/Hdf5Walk.h"

#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

// The only program that reads HDF5: what a damaged file does to the library, it does to this alone.
// Usage: asperity_hdf5_reader FILE CONTENT [PATH...]: core/io/hdf5/Hdf5Program.h

namespace {

constexpr int kRefused = 3;

asperity::Hdf5Object opened(const char* file) {
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // it complains on the terminal
    H5PLset_loading_state(0);                     // no filter from somewhere else
    return {H5Fopen(file, H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose};
}

void read(const char* file, const char* content, std::vector<std::string> paths) {
    const asperity::Hdf5Object input = opened(file);
    if (!input.isOpen()) {
        throw std::runtime_error("expected a file in the HDF5 format");
    }
    asperity::ContentWriter writer(content);
    const std::uint64_t most = std::filesystem::file_size(file) * asperity::kMaxHdf5Expansion;
    asperity::Hdf5Walk(writer, most, std::move(paths)).add(input.id());
    writer.close();
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 3) {
        (void)std::puts("usage: asperity_hdf5_reader FILE CONTENT [PATH...]");
        return 2;
    }
    try {
        read(argv[1], argv[2], {argv + 3, argv + argc});
        return 0;
    } catch (const std::exception& error) {
        (void)std::puts(error.what());
        return kRefused;
    }
}
