#include "app/maps/MapPart.h"

#include "app/maps/MapFiles.h"
#include "core/Error.h"
#include "core/io/ByteReader.h"

#include <algorithm>
#include <bit>
#include <fcntl.h>
#include <limits>
#include <span>
#include <string_view>
#include <utility>

// A line of text, then records: the row's number (uint32), a check of the values (uint64), the
// values (double) of one quantity after the other; numbers in the byte order of the machine, which
// the check would not survive on another.

namespace asperity {

namespace {

constexpr std::uint64_t kRecordHead = sizeof(std::uint32_t) + sizeof(std::uint64_t);

/// FNV-1a: detects a record that a power cut left half written.
std::uint64_t checkOf(std::uint32_t row, std::string_view values) {
    constexpr std::uint64_t kStart = 14695981039346656037U;
    constexpr std::uint64_t kPrime = 1099511628211U;
    std::uint64_t check = (kStart ^ row) * kPrime;
    for (const char byte : values) {
        check = (check ^ static_cast<unsigned char>(byte)) * kPrime;
    }
    return check;
}

std::string_view bytesOf(std::span<const double> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

template <class Number>
void append(std::string& bytes, Number number) {
    const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);
    bytes.append(raw.data(), raw.size());
}

/// Returns whether all of it was read.
bool readAt(int file, std::uint64_t offset, std::span<char> bytes) {
    while (!bytes.empty()) {
        const ssize_t got = ::pread(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (got <= 0) {
            return false;
        }
        bytes = bytes.subspan(static_cast<std::size_t>(got));
        offset += static_cast<std::uint64_t>(got);
    }
    return true;
}

FileDescriptor opened(const std::filesystem::path& path) {
    return FileDescriptor(::open(path.c_str(), O_RDONLY | O_NOFOLLOW | O_CLOEXEC));
}

}  // namespace

void requireNoPart(const std::filesystem::path& path) {
    std::error_code none;
    if (std::filesystem::exists(path, none)) {
        throw Error(path.string() + ": contains rows of an unfinished map; --resume continues it, "
                                    "--force starts again");
    }
}

MapPart::MapPart(std::filesystem::path path, const MapPlan& plan, const std::string& key,
                 PartUse use)
    : path_(std::move(path))
    , columns_(static_cast<std::size_t>(plan.grid.columns))
    , quantities_(plan.quantities.size())
    , starts_(static_cast<std::size_t>(plan.grid.rows), kNone) {
    open("asperity map part 1 " + key + "\n", use);
    reading_ = opened(path_);
}

void MapPart::open(const std::string& head, PartUse use) {
    std::error_code ignored;
    const bool isThere = std::filesystem::exists(path_, ignored);
    if (use == PartUse::New) {
        requireNoPart(path_);
    }
    if (isThere && use == PartUse::Replace && isGrowing(path_)) {
        throw Error(path_.string() + ": another process is writing it");
    }
    if (isThere && use == PartUse::Resume) {
        size_ = takeRecords(head);
        file_.emplace(path_, size_);
    } else {
        std::filesystem::remove(path_, ignored);
        file_.emplace(path_);
    }
    if (size_ == 0) {
        file_->append(head);
        size_ = head.size();
    }
}

std::uint64_t MapPart::takeRecords(const std::string& head) {
    const FileDescriptor file = opened(path_);
    std::error_code ignored;  // what has no size is read in vain, too
    std::string found(
        std::min<std::uintmax_t>(head.size(), std::filesystem::file_size(path_, ignored)), '\0');
    if (!readAt(file.get(), 0, found) || !head.starts_with(found)) {
        throw Error(path_.string() + ": holds rows of another map: scene, scan, options or version "
                                     "of the program differ");
    }
    if (found.size() < head.size()) {
        return 0;  // the program was killed before it had written this much
    }
    std::uint64_t offset = head.size();
    std::string record(recordBytes(), '\0');
    while (readAt(file.get(), offset, record)) {
        std::uint32_t row = 0;
        std::uint64_t check = 0;
        std::copy_n(record.data(), sizeof row, reinterpret_cast<char*>(&row));
        std::copy_n(record.data() + sizeof row, sizeof check, reinterpret_cast<char*>(&check));
        const auto values = std::string_view(record).substr(kRecordHead);
        if (row < starts_.size() && check == checkOf(row, values)) {
            starts_[row] = offset + kRecordHead;
        }  // else it is damaged, and is computed again
        offset += recordBytes();
    }
    return offset;
}

std::uint64_t MapPart::recordBytes() const {
    return kRecordHead + (sizeof(double) * columns_ * quantities_);
}

int MapPart::count() const {
    return static_cast<int>(starts_.size()) - static_cast<int>(std::ranges::count(starts_, kNone));
}

void MapPart::keep(int row, const std::vector<double>& values) {
    const auto number = static_cast<std::uint32_t>(row);
    const std::string_view bytes = bytesOf(values);
    std::string record;
    record.reserve(recordBytes());
    append(record, number);
    append(record, checkOf(number, bytes));
    record += bytes;
    const std::scoped_lock lock(mutex_);
    file_->append(record);
    starts_[index(row)] = size_ + kRecordHead;
    size_ += record.size();
}

void MapPart::read(int row, std::size_t quantity, double* values) const {
    if (!has(row)) {
        std::fill_n(values, columns_, std::numeric_limits<double>::quiet_NaN());
        return;
    }
    const std::uint64_t bytes = sizeof(double) * columns_;
    if (!readAt(reading_.get(), starts_[index(row)] + (quantity * bytes),
                {reinterpret_cast<char*>(values), bytes})) {
        throw Error(path_.string() + ": cannot be read again");
    }
}

void MapPart::remove() const {
    std::error_code ignored;
    std::filesystem::remove(path_, ignored);
}

HeldMap::HeldMap(LoadedScene loaded, const MapPlan& plan)
    : loaded_(std::move(loaded))
    , plan_(plan)
    , part_(folder_.path() / "map.part", plan_, mapKey(loaded_, plan_), PartUse::New) {}

RegionField HeldMap::field(MapQuantity quantity) const {
    const auto index = static_cast<std::size_t>(std::ranges::find(plan_.quantities, quantity) -
                                                plan_.quantities.begin());
    std::vector<double> row(static_cast<std::size_t>(plan_.grid.columns));
    std::vector<float> values;
    values.reserve(row.size() * static_cast<std::size_t>(plan_.grid.rows));
    for (int i = 0; i < plan_.grid.rows; ++i) {
        part_.read(i, index, row.data());
        std::ranges::transform(row, std::back_inserter(values),
                               [](double value) { return static_cast<float>(value); });
    }
    const MapRegion& region = plan_.region;
    return {{region.left, region.bottom, region.right - region.left, region.top - region.bottom},
            plan_.grid.columns,
            plan_.grid.rows,
            std::move(values),
            rowOf(quantity)->unit};
}

MapValues HeldMap::valuesAt(int row, int column) const {
    std::vector<double> line(static_cast<std::size_t>(plan_.grid.columns));
    MapValues values;
    for (std::size_t i = 0; i < plan_.quantities.size(); ++i) {
        part_.read(row, i, line.data());
        values[plan_.quantities[i]] = line.at(static_cast<std::size_t>(column));
    }
    return values;
}

}  // namespace asperity
