#include "core/io/hdf5/Hdf5Content.h"

#include "core/Error.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace asperity {

namespace {

/// Goes through the records of a content.
class ContentRecords {
public:
    ContentRecords(const ByteSource& content, const std::string& file)
        : content_(content), file_(file) {}

    std::vector<Hdf5Item> all() {
        if (!content_.startsWith(hdf5_content::kStart)) {
            fail();
        }
        offset_ = hdf5_content::kStart.size();
        std::vector<Hdf5Item> items;
        for (char record = take<char>(); record != hdf5_content::kEnd; record = take<char>()) {
            if (items.size() == hdf5_content::kMaxItems) {
                fail();
            }
            items.push_back(item(record));
        }
        if (take<std::uint64_t>() != items.size() || offset_ != content_.size()) {
            fail();
        }
        return items;
    }

private:
    template <class Number>
    Number take() {
        Number number{};
        requireThere(sizeof number);
        content_.read(offset_, {reinterpret_cast<char*>(&number), sizeof number});
        offset_ += sizeof number;
        return number;
    }

    std::string takePath() {
        const auto size = take<std::uint32_t>();
        pathBytes_ += size;
        if (size > hdf5_content::kMaxPath || pathBytes_ > hdf5_content::kMaxAllPaths) {
            fail();
        }
        requireThere(size);
        std::string path(size, '\0');
        content_.read(offset_, path);
        offset_ += size;
        return path;
    }

    Hdf5Item item(char record) {
        Hdf5Item item{.path = takePath(), .shape = {}};
        if (record == hdf5_content::kGroup) {
            return item;
        }
        if (record != hdf5_content::kDataset && record != hdf5_content::kAttribute) {
            fail();
        }
        item.kind =
            record == hdf5_content::kDataset ? Hdf5Item::Kind::Dataset : Hdf5Item::Kind::Attribute;
        takeValues(item);
        return item;
    }

    void takeValues(Hdf5Item& item) {
        item.type = static_cast<Hdf5Type>(take<char>());
        item.bytes = take<std::uint32_t>();
        const auto dimensions = take<std::uint8_t>();
        if (!isKnown(item.type, item.bytes) || dimensions > hdf5_content::kMaxDimensions) {
            fail();
        }
        item.count = 1;
        for (int i = 0; i < dimensions; ++i) {
            item.shape.push_back(take<std::uint64_t>());
            item.count = product(item.count, item.shape.back());
        }
        if (take<std::uint8_t>() != 0) {
            const std::uint64_t size = product(item.count, item.bytes);
            requireThere(size);
            item.offset = offset_;
            offset_ += size;
        }
    }

    static bool isKnown(Hdf5Type type, std::uint32_t bytes) {
        switch (type) {
        case Hdf5Type::Real:
            return bytes == sizeof(float) || bytes == sizeof(double);
        case Hdf5Type::Signed:
        case Hdf5Type::Unsigned:
            return bytes == 1 || bytes == 2 || bytes == 4 || bytes == 8;
        case Hdf5Type::Text:
            return bytes > 0;
        case Hdf5Type::Other:
            return true;
        }
        return false;
    }

    std::uint64_t product(std::uint64_t one, std::uint64_t other) const {
        if (other != 0 && one > std::numeric_limits<std::uint64_t>::max() / other) {
            fail();
        }
        return one * other;
    }

    void requireThere(std::uint64_t bytes) const {
        if (bytes > content_.size() - offset_) {
            fail();
        }
    }

    [[noreturn]] void fail() const {
        throw InputError(
            file_, "", "it is damaged: what the program that reads HDF5 makes of it is not whole");
    }

    const ByteSource& content_;
    const std::string& file_;
    std::uint64_t offset_ = 0;
    std::uint64_t pathBytes_ = 0;
};

template <class Number>
void convert(const ByteSource& content, std::uint64_t offset, std::span<double> numbers) {
    std::vector<Number> stored(numbers.size());
    content.read(offset, {reinterpret_cast<char*>(stored.data()), stored.size() * sizeof(Number)});
    std::ranges::transform(stored, numbers.begin(),
                           [](Number number) { return static_cast<double>(number); });
}

using Converter = void (*)(const ByteSource&, std::uint64_t, std::span<double>);

/// Null: these are no numbers.
Converter converterOf(Hdf5Type type, std::uint32_t bytes) {
    switch (type) {
    case Hdf5Type::Real:
        return bytes == sizeof(float) ? convert<float> : convert<double>;
    case Hdf5Type::Signed:
        return bytes == 1   ? convert<std::int8_t>
               : bytes == 2 ? convert<std::int16_t>
               : bytes == 4 ? convert<std::int32_t>
                            : convert<std::int64_t>;
    case Hdf5Type::Unsigned:
        return bytes == 1   ? convert<std::uint8_t>
               : bytes == 2 ? convert<std::uint16_t>
               : bytes == 4 ? convert<std::uint32_t>
                            : convert<std::uint64_t>;
    default:
        return nullptr;
    }
}

}  // namespace

Hdf5Content::Hdf5Content(std::shared_ptr<const ByteSource> content, std::string file)
    : content_(std::move(content))
    , file_(std::move(file))
    , items_(ContentRecords(*content_, file_).all())
    , byPath_(items_.size()) {
    std::iota(byPath_.begin(), byPath_.end(), std::size_t{0});
    std::ranges::stable_sort(byPath_, {},
                             [this](std::size_t i) -> std::string_view { return items_[i].path; });
}

const Hdf5Item* Hdf5Content::find(Hdf5Item::Kind kind, std::string_view path) const {
    const auto pathOf = [this](std::size_t i) -> std::string_view { return items_[i].path; };
    auto found = std::ranges::lower_bound(byPath_, path, {}, pathOf);
    while (found != byPath_.end() && pathOf(*found) == path && items_[*found].kind != kind) {
        ++found;
    }
    return found != byPath_.end() && pathOf(*found) == path ? &items_[*found] : nullptr;
}

void Hdf5Content::requireValues(const Hdf5Item& item, std::uint64_t first,
                                std::uint64_t count) const {
    if (!item.offset || first > item.count || count > item.count - first) {
        fail(item.path, "expected " + std::to_string(count) + " values from number " +
                            std::to_string(first) + " on");
    }
}

void Hdf5Content::read(const Hdf5Item& item, std::uint64_t first, std::span<double> numbers) const {
    const Converter converter = converterOf(item.type, item.bytes);
    if (converter == nullptr) {
        fail(item.path, "expected numbers");
    }
    requireValues(item, first, numbers.size());
    converter(*content_, *item.offset + first * item.bytes, numbers);
}

void Hdf5Content::read(const Hdf5Item& item, std::uint64_t first, std::span<char> texts) const {
    if (item.type != Hdf5Type::Text) {
        fail(item.path, "expected a text");
    }
    requireValues(item, first, texts.size() / item.bytes);
    content_->read(*item.offset + first * item.bytes, texts);
}

std::string Hdf5Content::text(Hdf5Item::Kind kind, std::string_view path) const {
    const Hdf5Item* const item = find(kind, path);
    if (item == nullptr || item->type != Hdf5Type::Text || !item->offset || item->count != 1) {
        return {};
    }
    std::string text(item->bytes, '\0');
    read(*item, 0, std::span<char>(text));
    text.resize(std::min(text.find('\0'), text.size()));
    return text;
}

void Hdf5Content::fail(const std::string& location, const std::string& what) const {
    throw InputError(file_, location, what);
}

}  // namespace asperity
