#include "core/io/hdf5/reader/ContentWriter.h"

#include <cerrno>
#include <limits>
#include <stdexcept>
#include <system_error>

namespace asperity {

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

}  // namespace asperity
