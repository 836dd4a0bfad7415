#include "core/io/hdf5/reader/Hdf5Values.h"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <sys/resource.h>
#include <unistd.h>

namespace asperity {

namespace {

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
constexpr std::uint64_t kUsualBlock = kMiB;
/// Of an array that is decompressed at once.
constexpr std::uint64_t kMostBlock = 256 * kMiB;
/// Largest chunk that may exceed its array: to read one value, the library needs twice its bytes.
constexpr std::uint64_t kMostSpareChunk = 64 * kMiB;
/// Largest size of all texts of variable length: the library copies each, although many may be the
/// same bytes of the file.
constexpr std::uint64_t kMostTexts = 64 * kMiB;
constexpr std::uint64_t kMostTextBytes = std::uint64_t{1} << 16U;  // of one, and how many
/// Values that are handed over though nobody named them.
constexpr std::uint64_t kShort = 1024;

[[noreturn]] void fail(const std::string& path, const std::string& what) {
    throw std::runtime_error(path + ": " + what);
}

std::vector<std::uint64_t> dimensionsOf(hid_t space) {
    const H5S_class_t kind = H5Sget_simple_extent_type(space);
    if (kind == H5S_NULL) {
        return {0};
    }
    const int rank = kind == H5S_SIMPLE ? H5Sget_simple_extent_ndims(space) : 0;
    if (rank < 0 || rank > static_cast<int>(hdf5_content::kMaxDimensions)) {
        throw std::runtime_error("an array of too many dimensions");
    }
    std::vector<hsize_t> sizes(static_cast<std::size_t>(rank));
    if (rank > 0 && H5Sget_simple_extent_dims(space, sizes.data(), nullptr) != rank) {
        throw std::runtime_error("an array without a size");
    }
    return {sizes.begin(), sizes.end()};
}

hid_t realType(std::size_t bytes) {
    return bytes <= sizeof(float) ? H5T_NATIVE_FLOAT : H5T_NATIVE_DOUBLE;
}

hid_t integerType(std::size_t bytes, bool isSigned) {
    switch (bytes) {
    case 1:
        return isSigned ? H5T_NATIVE_INT8 : H5T_NATIVE_UINT8;
    case 2:
        return isSigned ? H5T_NATIVE_INT16 : H5T_NATIVE_UINT16;
    case 3:
    case 4:
        return isSigned ? H5T_NATIVE_INT32 : H5T_NATIVE_UINT32;
    default:
        return isSigned ? H5T_NATIVE_INT64 : H5T_NATIVE_UINT64;
    }
}

void setNumbers(Hdf5Values& values, Hdf5Type type, hid_t memory) {
    values.shape.type = type;
    values.memory = Hdf5Object(H5Tcopy(memory), H5Tclose);
    values.shape.bytes = static_cast<std::uint32_t>(H5Tget_size(values.memory.id()));
}

void setText(Hdf5Values& values, hid_t type) {
    values.hasPointers = H5Tis_variable_str(type) > 0;
    const std::size_t bytes = values.hasPointers ? 1 : H5Tget_size(type);
    if (bytes == 0 || bytes > kMostTextBytes) {
        return;
    }
    values.shape.type = Hdf5Type::Text;
    values.shape.bytes = static_cast<std::uint32_t>(bytes);
    values.memory = Hdf5Object(H5Tcopy(type), H5Tclose);
    H5Tset_strpad(values.memory.id(), values.hasPointers ? H5T_STR_NULLTERM : H5T_STR_NULLPAD);
}

Hdf5Values valuesOf(hid_t type, hid_t space) {
    Hdf5Values values;
    values.shape.dimensions = dimensionsOf(space);
    const std::size_t bytes = H5Tget_size(type);
    switch (H5Tget_class(type)) {
    case H5T_FLOAT:
        if (bytes <= sizeof(double)) {
            setNumbers(values, Hdf5Type::Real, realType(bytes));
        }
        break;
    case H5T_INTEGER:
        if (bytes > 0 && bytes <= sizeof(std::uint64_t)) {
            const bool isSigned = H5Tget_sign(type) != H5T_SGN_NONE;
            setNumbers(values, isSigned ? Hdf5Type::Signed : Hdf5Type::Unsigned,
                       integerType(bytes, isSigned));
        }
        break;
    case H5T_STRING:
        setText(values, type);
        break;
    default:
        break;
    }
    return values;
}

/// As long as it lives, no more memory than this can be had.
class MemoryBudget {
public:
    explicit MemoryBudget(std::uint64_t bytes) {
        std::uint64_t pages = 0;
        std::ifstream("/proc/self/statm") >> pages;
        getrlimit(RLIMIT_AS, &before_);
        rlimit limit = before_;
        const rlim_t wanted = pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) + bytes;
        limit.rlim_cur = std::min(limit.rlim_cur, wanted);
        setrlimit(RLIMIT_AS, &limit);
    }
    MemoryBudget(const MemoryBudget&) = delete;
    MemoryBudget& operator=(const MemoryBudget&) = delete;
    ~MemoryBudget() { setrlimit(RLIMIT_AS, &before_); }

private:
    rlimit before_{};
};

/// Texts of any length, side by side: sets the bytes of each.
/// @param read (room for pointers) -> whether they are there now
template <class Read>
std::vector<char> readTexts(Hdf5Values& values, hid_t space, const std::string& path,
                            const Read& read) {
    const std::uint64_t count = values.shape.count();
    std::vector<char*> texts(count, nullptr);
    const auto isRead = [&] {
        const MemoryBudget budget(kMostTexts);
        return read(texts.data());
    };
    if (!isRead()) {
        fail(path, "its texts cannot be read, or have more than " +
                       std::to_string(kMostTexts / kMiB) + " MiB");
    }
    std::size_t width = 1;
    for (const char* const text : texts) {
        width = std::max(width, text == nullptr ? 0 : std::strlen(text));
    }
    if (width > kMostTextBytes || width * count > kMostTexts) {
        fail(path, "a text of " + std::to_string(width) + " bytes is too long");
    }
    std::vector<char> bytes(width * count, '\0');
    for (std::size_t i = 0; i < texts.size(); ++i) {
        if (texts[i] != nullptr) {
            std::copy_n(texts[i], std::strlen(texts[i]), bytes.data() + i * width);
        }
    }
    H5Dvlen_reclaim(values.memory.id(), space, H5P_DEFAULT, texts.data());
    values.shape.bytes = static_cast<std::uint32_t>(width);
    return bytes;
}

/// Whether a dataset lies in its own file, as one of another file would let that be read.
bool liesInFile(hid_t properties) {
    const H5D_layout_t layout = H5Pget_layout(properties);
    return (layout == H5D_COMPACT || layout == H5D_CONTIGUOUS || layout == H5D_CHUNKED) &&
           H5Pget_external_count(properties) == 0;
}

/// Rows that are stored together. @throw std::runtime_error where they are too large
std::uint64_t rowsOfBlock(hid_t properties, const ValueShape& shape, std::uint64_t rowBytes,
                          const std::string& path) {
    std::uint64_t rows =
        std::max<std::uint64_t>(kUsualBlock / std::max<std::uint64_t>(rowBytes, 1), 1);
    if (H5Pget_layout(properties) == H5D_CHUNKED) {
        std::vector<hsize_t> chunk(shape.dimensions.size());
        if (H5Pget_chunk(properties, static_cast<int>(chunk.size()), chunk.data()) !=
            static_cast<int>(chunk.size())) {
            fail(path, "its chunks have no size");
        }
        const ValueShape stored{shape.type, shape.bytes, {chunk.begin(), chunk.end()}};
        if (stored.count() > kMostBlock / shape.bytes) {
            fail(path, "a chunk of it has more than " + std::to_string(kMostBlock) + " bytes");
        }
        const std::uint64_t chunkBytes = stored.count() * shape.bytes;
        if (chunkBytes > kMostSpareChunk && stored.count() > shape.count()) {
            fail(path, "a chunk of it has " + std::to_string(chunkBytes) +
                           " bytes, more than all of its values");
        }
        rows = std::min<std::uint64_t>(chunk.front(), shape.dimensions.front());
    }
    if (rows > kMostBlock / std::max<std::uint64_t>(rowBytes, 1)) {
        fail(path, "rows of it have more than " + std::to_string(kMostBlock) + " bytes");
    }
    return std::max<std::uint64_t>(rows, 1);
}

class DatasetBlocks {
public:
    DatasetBlocks(ContentWriter& writer, const std::string& path, hid_t dataset, hid_t space,
                  const Hdf5Values& values)
        : writer_(writer), path_(path), dataset_(dataset), space_(space), values_(values) {}

    void add(hid_t properties) {
        const std::vector<std::uint64_t>& sizes = values_.shape.dimensions;
        if (sizes.empty()) {
            addBlock(H5S_ALL, H5S_ALL, values_.shape.bytes);
            return;
        }
        const std::uint64_t rowBytes = values_.shape.bytes * valuesOfRow();
        const std::uint64_t step = rowsOfBlock(properties, values_.shape, rowBytes, path_);
        std::vector<hsize_t> begin(sizes.size(), 0);
        std::vector<hsize_t> count(sizes.begin(), sizes.end());
        for (std::uint64_t row = 0; row < sizes.front() && rowBytes > 0; row += step) {
            begin.front() = row;
            count.front() = std::min(step, sizes.front() - row);
            const Hdf5Object memory(
                H5Screate_simple(static_cast<int>(count.size()), count.data(), nullptr), H5Sclose);
            H5Sselect_hyperslab(space_, H5S_SELECT_SET, begin.data(), nullptr, count.data(),
                                nullptr);
            addBlock(memory.id(), space_, count.front() * rowBytes);
        }
    }

private:
    [[nodiscard]] std::uint64_t valuesOfRow() const {
        std::uint64_t values = 1;
        for (std::size_t i = 1; i < values_.shape.dimensions.size(); ++i) {
            values *= values_.shape.dimensions[i];  // no more than all, which were counted
        }
        return values;
    }

    void addBlock(hid_t memory, hid_t file, std::uint64_t bytes) {
        block_.resize(bytes);
        if (H5Dread(dataset_, values_.memory.id(), memory, file, H5P_DEFAULT, block_.data()) < 0) {
            fail(path_, "its values cannot be read");
        }
        writer_.add(block_);
    }

    ContentWriter& writer_;
    const std::string& path_;
    hid_t dataset_;
    hid_t space_;
    const Hdf5Values& values_;
    std::vector<char> block_;
};

bool areMany(const ValueShape& shape, std::uint64_t most) {
    return shape.count() > most / std::max<std::uint32_t>(shape.bytes, 1);
}

}  // namespace

void addDataset(ContentWriter& writer, const std::string& path, hid_t dataset, std::uint64_t most,
                bool isWanted) {
    const Hdf5Object type(H5Dget_type(dataset), H5Tclose);
    const Hdf5Object space(H5Dget_space(dataset), H5Sclose);
    const Hdf5Object properties(H5Dget_create_plist(dataset), H5Pclose);
    if (!type.isOpen() || !space.isOpen() || !properties.isOpen()) {
        fail(path, "it is no dataset that can be read");
    }
    Hdf5Values values = valuesOf(type.id(), space.id());
    const bool isReadable = values.shape.type != Hdf5Type::Other && liesInFile(properties.id()) &&
                            (!values.hasPointers || !areMany(values.shape, kMostTextBytes));
    if (isReadable && isWanted && areMany(values.shape, most)) {
        fail(path, "it promises more values than its file can hold");
    }
    if (!isReadable || (!isWanted && areMany(values.shape, kShort))) {
        writer.addDataset(path, values.shape, false);
        return;
    }
    if (values.hasPointers) {
        const std::vector<char> texts = readTexts(values, space.id(), path, [&](char** room) {
            return H5Dread(dataset, values.memory.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, room) >= 0;
        });
        writer.addDataset(path, values.shape, true);
        writer.add(texts);
        return;
    }
    writer.addDataset(path, values.shape, true);
    DatasetBlocks(writer, path, dataset, space.id(), values).add(properties.id());
}

void addAttribute(ContentWriter& writer, const std::string& path, hid_t attribute) {
    const Hdf5Object type(H5Aget_type(attribute), H5Tclose);
    const Hdf5Object space(H5Aget_space(attribute), H5Sclose);
    if (!type.isOpen() || !space.isOpen()) {
        fail(path, "it is no attribute that can be read");
    }
    Hdf5Values values = valuesOf(type.id(), space.id());
    if (values.shape.type == Hdf5Type::Other || areMany(values.shape, kMostTextBytes)) {
        writer.addAttribute(path, values.shape, false);
        return;
    }
    const auto read = [&](void* room) { return H5Aread(attribute, values.memory.id(), room) >= 0; };
    std::vector<char> bytes;
    if (values.hasPointers) {
        bytes = readTexts(values, space.id(), path, read);
    } else {
        bytes.resize(values.shape.count() * values.shape.bytes);
        if (!bytes.empty() && !read(bytes.data())) {
            fail(path, "it cannot be read");
        }
    }
    writer.addAttribute(path, values.shape, true);
    writer.add(bytes);
}

}  // namespace asperity
