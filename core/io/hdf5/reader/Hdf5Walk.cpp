#include "core/io/hdf5/reader/Hdf5Walk.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <sys/resource.h>
#include <system_error>
#include <unistd.h>

namespace asperity {

namespace {

template <class Info>
herr_t takeName(hid_t /*object*/, const char* name, const Info* /*info*/, void* taken) noexcept {
    try {
        auto& names = *static_cast<std::vector<std::string>*>(taken);
        names.emplace_back(name);
        return names.size() > hdf5_content::kMaxItems ? -1 : 0;
    } catch (...) {
        return -1;
    }
}

/// In the order in which they were made, where the file has it.
std::vector<std::string> linksOf(hid_t group) {
    std::vector<std::string> names;
    if (H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, takeName<H5L_info_t>, &names) <
        0) {
        names.clear();
        H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, takeName<H5L_info_t>, &names);
    }
    return names;
}

std::vector<std::string> attributesOf(hid_t object) {
    std::vector<std::string> names;
    H5Aiterate2(object, H5_INDEX_NAME, H5_ITER_INC, nullptr, takeName<H5A_info_t>, &names);
    return names;
}

bool isBelow(const std::string& path, const std::string& above) {
    return path == above || above == "/" || (path.starts_with(above) && path[above.size()] == '/');
}

/// A link to another file is not followed, whatever it is part of.
herr_t refuseOtherFile(const char* /*file*/, const char* /*group*/, const char* /*other*/,
                       const char* /*object*/, unsigned* /*access*/, hid_t /*properties*/,
                       void* /*data*/) noexcept {
    return -1;
}

Hdf5Object opened(hid_t group, const std::string& name) {
    const Hdf5Object access(H5Pcreate(H5P_LINK_ACCESS), H5Pclose);
    H5Pset_elink_cb(access.id(), refuseOtherFile, nullptr);
    return {H5Oopen(group, name.c_str(), access.id()), H5Oclose};
}

constexpr std::uint64_t kMiB = std::uint64_t{1} << 20U;
constexpr std::uint64_t kUsualBlock = kMiB;
/// Size of an array that is decompressed at once.
constexpr std::uint64_t kMaxBlock = 256 * kMiB;
/// Largest chunk that may exceed its array: to read one value, the library needs twice its bytes.
constexpr std::uint64_t kMaxSpareChunk = 64 * kMiB;
/// Largest size of all texts of variable length: the library copies each, although many may be the
/// same bytes of the file.
constexpr std::uint64_t kMaxTexts = 64 * kMiB;
constexpr std::uint64_t kMaxTextBytes = std::uint64_t{1} << 16U;  // of one, and how many
/// Values that are written though nobody named them.
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
    if (bytes == 0 || bytes > kMaxTextBytes) {
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

/// Limits the memory as long as it lives.
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
        const MemoryBudget budget(kMaxTexts);
        return read(texts.data());
    };
    if (!isRead()) {
        fail(path, "its texts cannot be read, or have more than " +
                       std::to_string(kMaxTexts / kMiB) + " MiB");
    }
    std::size_t width = 1;
    for (const char* const text : texts) {
        width = std::max(width, text == nullptr ? 0 : std::strlen(text));
    }
    if (width > kMaxTextBytes || width * count > kMaxTexts) {
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

/// Returns whether a dataset lies in its own file, as one of another file would let that be read.
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
        if (stored.count() > kMaxBlock / shape.bytes) {
            fail(path, "a chunk of it has more than " + std::to_string(kMaxBlock) + " bytes");
        }
        const std::uint64_t chunkBytes = stored.count() * shape.bytes;
        if (chunkBytes > kMaxSpareChunk && stored.count() > shape.count()) {
            fail(path, "a chunk of it has " + std::to_string(chunkBytes) +
                           " bytes, more than all of its values");
        }
        rows = std::min<std::uint64_t>(chunk.front(), shape.dimensions.front());
    }
    if (rows > kMaxBlock / std::max<std::uint64_t>(rowBytes, 1)) {
        fail(path, "rows of it have more than " + std::to_string(kMaxBlock) + " bytes");
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

std::uint64_t ValueShape::count() const {
    std::uint64_t count = 1;
    for (const std::uint64_t size : dimensions) {
        if (size != 0 && count > std::numeric_limits<std::uint64_t>::max() / size) {
            throw std::length_error("it promises more values than there are numbers");
        }
        count *= size;
    }
    return count;
}

ContentWriter::ContentWriter(const std::filesystem::path& path) : stream_(path, std::ios::binary) {
    requireWritten();
    stream_ << hdf5_content::kStart;
}

void ContentWriter::addGroup(const std::string& path) { begin(hdf5_content::kGroup, path); }

void ContentWriter::addDataset(const std::string& path, const ValueShape& shape, bool hasValues) {
    begin(hdf5_content::kDataset, path);
    addShape(shape, hasValues);
}

void ContentWriter::addAttribute(const std::string& path, const ValueShape& shape, bool hasValues) {
    begin(hdf5_content::kAttribute, path);
    addShape(shape, hasValues);
}

void ContentWriter::add(std::span<const char> values) {
    stream_.write(values.data(), static_cast<std::streamsize>(values.size()));
    requireWritten();
}

void ContentWriter::close() {
    put(hdf5_content::kEnd);
    put(items_);
    stream_.close();
    requireWritten();
}

void ContentWriter::requireWritten() const {
    if (!stream_) {
        throw std::runtime_error("what it holds cannot be written for a moment: " +
                                 std::generic_category().message(errno));
    }
}

template <class Number>
void ContentWriter::put(Number number) {
    add({reinterpret_cast<const char*>(&number), sizeof number});
}

void ContentWriter::begin(char record, const std::string& path) {
    if (path.size() > hdf5_content::kMaxPath) {
        throw std::runtime_error("a name of more than " + std::to_string(hdf5_content::kMaxPath) +
                                 " bytes");
    }
    if (++items_ > hdf5_content::kMaxItems) {
        throw std::runtime_error("more than " + std::to_string(hdf5_content::kMaxItems) +
                                 " groups, datasets and attributes");
    }
    pathBytes_ += path.size();
    if (pathBytes_ > hdf5_content::kMaxAllPaths) {
        throw std::runtime_error("names of more than " +
                                 std::to_string(hdf5_content::kMaxAllPaths) + " bytes in all");
    }
    put(record);
    put(static_cast<std::uint32_t>(path.size()));
    add(path);
}

void ContentWriter::addShape(const ValueShape& shape, bool hasValues) {
    put(shape.type);
    put(shape.bytes);
    put(static_cast<std::uint8_t>(shape.dimensions.size()));
    for (const std::uint64_t size : shape.dimensions) {
        put(size);
    }
    put(static_cast<std::uint8_t>(hasValues ? 1 : 0));
}

void Hdf5Walk::add(hid_t file) {
    const Hdf5Object root(H5Gopen2(file, "/", H5P_DEFAULT), H5Gclose);
    if (!root.isOpen()) {
        throw std::runtime_error("it has no root group");
    }
    addGroup(root.id(), "/");
}

bool Hdf5Walk::isWanted(const std::string& path) const {
    return std::ranges::any_of(paths_,
                               [&](const std::string& wanted) { return isBelow(path, wanted); });
}

bool Hdf5Walk::leadsToWanted(const std::string& path) const {
    return paths_.empty() || isWanted(path) ||
           std::ranges::any_of(paths_,
                               [&](const std::string& wanted) { return isBelow(wanted, path); });
}

void Hdf5Walk::addGroup(hid_t group, const std::string& path) {
    H5O_info_t info{};
    if (H5Oget_info(group, &info) < 0) {
        throw std::runtime_error(path + ": it is no group that can be read");
    }
    writer_.addGroup(path);
    addAttributes(group, path);
    if (!groups_.insert(info.addr).second) {
        return;
    }
    for (const std::string& name : linksOf(group)) {
        const std::string below = (path == "/" ? "" : path) + "/" + name;
        if (leadsToWanted(below)) {
            addLink(group, name, below);
        }
    }
}

void Hdf5Walk::addLink(hid_t group, const std::string& name, const std::string& path) {
    H5L_info_t link{};
    if (H5Lget_info(group, name.c_str(), &link, H5P_DEFAULT) < 0) {
        throw std::runtime_error(path + ": it cannot be read");
    }
    if (link.type != H5L_TYPE_HARD && link.type != H5L_TYPE_SOFT) {
        return;
    }
    const Hdf5Object object = opened(group, name);
    if (!object.isOpen()) {
        if (link.type == H5L_TYPE_SOFT) {
            return;  // it leads nowhere
        }
        throw std::runtime_error(path + ": it cannot be read");
    }
    switch (H5Iget_type(object.id())) {
    case H5I_GROUP:
        if (link.type == H5L_TYPE_HARD) {
            addGroup(object.id(), path);
        }
        break;
    case H5I_DATASET:
        addDataset(writer_, path, object.id(), most_, isWanted(path));
        addAttributes(object.id(), path);
        break;
    default:
        break;
    }
}

void Hdf5Walk::addAttributes(hid_t object, const std::string& path) {
    for (const std::string& name : attributesOf(object)) {
        const Hdf5Object attribute(H5Aopen(object, name.c_str(), H5P_DEFAULT), H5Aclose);
        addAttribute(writer_, path + "@" + name, attribute.id());
    }
}

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
                            (!values.hasPointers || !areMany(values.shape, kMaxTextBytes));
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
    if (values.shape.type == Hdf5Type::Other || areMany(values.shape, kMaxTextBytes)) {
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
