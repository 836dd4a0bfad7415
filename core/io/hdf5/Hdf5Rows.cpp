#include "core/io/hdf5/Hdf5Rows.h"

#include "core/Error.h"

#include <algorithm>
#include <cstring>
#include <optional>

namespace asperity {

namespace {

constexpr long long kBlock = 8192;                        // rows, as they are stored together
constexpr std::size_t kMaxWidth = std::size_t{1} << 12U;  // of a text's cells [byte]

/// What a column's dataset holds; nothing where Asperity writes no such one.
std::optional<Hdf5Column> columnOf(hid_t dataset) {
    const Hdf5Object type(H5Dget_type(dataset), H5Tclose);
    const Hdf5Object properties(H5Dget_create_plist(dataset), H5Pclose);
    if (!type.isOpen() || !properties.isOpen() || H5Pget_external_count(properties.id()) != 0) {
        return std::nullopt;
    }
    Hdf5Column column;
    const std::size_t size = H5Tget_size(type.id());
    if (H5Tget_class(type.id()) == H5T_STRING && H5Tis_variable_str(type.id()) == 0 && size > 0 &&
        size <= kMaxWidth) {
        column.type = Hdf5Column::Type::Text;
        column.width = size;
        return column;
    }
    if (H5Tget_class(type.id()) != H5T_FLOAT || size > sizeof(double)) {
        return std::nullopt;
    }
    column.type = size == sizeof(double) ? Hdf5Column::Type::Double : Hdf5Column::Type::Single;
    return column;
}

/// Rows of a column's dataset; negative: it is no column.
long long lengthOf(hid_t dataset) {
    const Hdf5Object space(H5Dget_space(dataset), H5Sclose);
    const bool isColumn = space.isOpen() && H5Sget_simple_extent_ndims(space.id()) == 1;
    return isColumn ? H5Sget_simple_extent_npoints(space.id()) : -1;
}

Hdf5Object readType(const Hdf5Column& column) {
    return column.type == Hdf5Column::Type::Text ? textType(column.width)
                                                 : Hdf5Object(H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose);
}

std::size_t cellBytes(const Hdf5Column& column) {
    return column.type == Hdf5Column::Type::Text ? column.width : sizeof(double);
}

/// Of a cell in the file.
std::size_t storedBytes(const Hdf5Column& column) {
    return column.type == Hdf5Column::Type::Single ? sizeof(float) : cellBytes(column);
}

std::vector<std::string> linksOf(hid_t group) {
    std::vector<std::string> names;
    const auto take = [](hid_t /*group*/, const char* name, const H5L_info_t* /*info*/,
                         void* taken) -> herr_t {
        static_cast<std::vector<std::string>*>(taken)->emplace_back(name);
        return 0;
    };
    if (H5Literate(group, H5_INDEX_CRT_ORDER, H5_ITER_INC, nullptr, take, &names) < 0) {
        names.clear();
        H5Literate(group, H5_INDEX_NAME, H5_ITER_INC, nullptr, take, &names);
    }
    return names;
}

}  // namespace

Hdf5Rows::Hdf5Rows(const Hdf5Input& file, std::string name)
    : file_(file)
    , name_(std::move(name))
    , group_(file.has(name_) ? H5Gopen2(file.id(), name_.c_str(), H5P_DEFAULT) : -1, H5Gclose) {
    if (!group_.isOpen()) {
        file_.fail(name_, "there is no such table");
    }
    for (const std::string& column : linksOf(group_.id())) {
        addColumn(column);
    }
    if (columns_.empty()) {
        file_.fail(name_, "the table has no column");
    }
    std::uint64_t bytesOfRow = 1;
    for (const Hdf5Column& column : columns_) {
        bytesOfRow += storedBytes(column);
    }
    if (static_cast<std::uint64_t>(rows_) > file_.mostBytes() / bytesOfRow) {
        file_.fail(name_, "it promises more rows than its file can hold");
    }
    block_.resize(columns_.size());
}

void Hdf5Rows::addColumn(const std::string& name) {
    Hdf5Object dataset(H5Dopen2(group_.id(), name.c_str(), H5P_DEFAULT), H5Dclose);
    std::optional<Hdf5Column> column =
        dataset.isOpen() ? columnOf(dataset.id()) : std::optional<Hdf5Column>();
    const long long length = column ? lengthOf(dataset.id()) : -1;
    const std::string place = name_ + "/" + name;
    if (length < 0) {
        file_.fail(place, "expected a column of numbers or words");
    }
    if (!columns_.empty() && length != rows_) {
        file_.fail(place, "expected " + std::to_string(rows_) +
                              " rows as in the columns before, found " + std::to_string(length));
    }
    rows_ = length;
    column->name = name;
    columns_.push_back(std::move(*column));
    datasets_.push_back(std::move(dataset));
}

std::vector<std::string> Hdf5Rows::comments() const {
    std::vector<std::string> lines;
    std::string text = textOf(group_.id(), "comments");
    for (std::size_t end = 0; (end = text.find('\n')) != std::string::npos;
         text.erase(0, end + 1)) {
        lines.push_back(text.substr(0, end));
    }
    return lines;
}

bool Hdf5Rows::next() {
    if (next_ == rows_) {
        return false;
    }
    if (next_ == read_) {
        read();
    }
    ++next_;
    return true;
}

void Hdf5Rows::read() {
    begin_ = read_;
    const auto begin = static_cast<hsize_t>(begin_);
    const auto count = static_cast<hsize_t>(std::min(kBlock, rows_ - begin_));
    const Hdf5Object memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        block_[c].resize(count * cellBytes(columns_[c]));
        const Hdf5Object place(H5Dget_space(datasets_[c].id()), H5Sclose);
        H5Sselect_hyperslab(place.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr);
        if (H5Dread(datasets_[c].id(), readType(columns_[c]).id(), memory.id(), place.id(),
                    H5P_DEFAULT, block_[c].data()) < 0) {
            file_.fail(name_ + "/" + columns_[c].name, "its cells cannot be read");
        }
    }
    read_ = begin_ + static_cast<long long>(count);
}

const char* Hdf5Rows::cell(std::size_t column) const {
    return block_[column].data() +
           static_cast<std::size_t>(next_ - 1 - begin_) * cellBytes(columns_[column]);
}

double Hdf5Rows::number(std::size_t column) const {
    double number = 0.0;
    std::memcpy(&number, cell(column), sizeof(number));
    return number;
}

std::string_view Hdf5Rows::text(std::size_t column) const {
    const std::string_view whole(cell(column), columns_[column].width);
    return whole.substr(0, whole.find('\0'));
}

}  // namespace asperity
