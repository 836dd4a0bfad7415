#include "core/io/hdf5/Hdf5TableWriter.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace asperity {

namespace {

using Kind = Hdf5Item::Kind;

Hdf5Content sealedContent(const FileBytes& file, std::vector<std::string> wanted) {
    requireSeal(file);
    std::ranges::for_each(wanted, [](std::string& name) { name.insert(0, "/"); });
    return readHdf5(file, wanted);
}

constexpr unsigned long long kChunk = 8192;  // rows
constexpr unsigned kDeflate = 9;

Hdf5Object storedType(const Hdf5Column& column) {
    switch (column.type) {
    case Hdf5Column::Type::Double:
        return {H5Tcopy(H5T_IEEE_F64LE), H5Tclose};
    case Hdf5Column::Type::Single:
        return {H5Tcopy(H5T_IEEE_F32LE), H5Tclose};
    case Hdf5Column::Type::Text:
        break;
    }
    return textType(column.width);
}

Hdf5Object writtenType(const Hdf5Column& column) {
    switch (column.type) {
    case Hdf5Column::Type::Double:
        return {H5Tcopy(H5T_NATIVE_DOUBLE), H5Tclose};
    case Hdf5Column::Type::Single:
        return {H5Tcopy(H5T_NATIVE_FLOAT), H5Tclose};
    case Hdf5Column::Type::Text:
        break;
    }
    return textType(column.width);
}

/// Keeps the order of its links.
Hdf5Object orderedGroup(hid_t file, const std::string& name) {
    const Hdf5Object properties(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
    H5Pset_link_creation_order(properties.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
    H5Pset_obj_track_times(properties.id(), 0);  // the same run, the same bytes
    return {H5Gcreate2(file, name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT), H5Gclose};
}

template <typename Number>
void append(std::vector<char>& bytes, Number number) {
    const auto* const begin = reinterpret_cast<const char*>(&number);
    bytes.insert(bytes.end(), begin, begin + sizeof(Number));
}

constexpr std::uint64_t kBlock = 8192;                        // rows, as they are stored together
constexpr std::uint32_t kMaxWidth = std::uint32_t{1} << 12U;  // of a text's cells [byte]

/// Returns a dataset's column; nothing where Asperity writes no such one.
std::optional<Hdf5Column> columnOf(const Hdf5Item& dataset) {
    Hdf5Column column;
    if (dataset.type == Hdf5Type::Text && dataset.bytes <= kMaxWidth) {
        column.type = Hdf5Column::Type::Text;
        column.width = dataset.bytes;
        return column;
    }
    if (dataset.type != Hdf5Type::Real) {
        return std::nullopt;
    }
    column.type =
        dataset.bytes == sizeof(double) ? Hdf5Column::Type::Double : Hdf5Column::Type::Single;
    return column;
}

}  // namespace

Hdf5Input::Hdf5Input(const std::filesystem::path& path, const std::vector<std::string>& wanted)
    : content_(sealedContent(FileBytes(path), wanted)) {}

bool Hdf5Input::has(const std::string& what) const {
    return content_.find(Kind::Group, "/" + what) != nullptr ||
           content_.find(Kind::Dataset, "/" + what) != nullptr;
}

std::string Hdf5Input::attribute(const std::string& attribute) const {
    return content_.text(Kind::Attribute, "/@" + attribute);
}

std::vector<std::uint32_t> Hdf5Input::list(const std::string& list) const {
    const Hdf5Item* const item = content_.find(Kind::Dataset, "/" + list);
    if (item == nullptr || item->shape.size() != 1 || item->type != Hdf5Type::Unsigned ||
        item->bytes != sizeof(std::uint32_t) || !item->offset) {
        fail(list, "expected a list of numbers");
    }
    std::vector<double> numbers(item->count);
    content_.read(*item, 0, numbers);
    return {numbers.begin(), numbers.end()};
}

Hdf5TableWriter::Hdf5TableWriter(const Hdf5Output& file, const std::string& name,
                                 const Hdf5Table& table)
    : name_(file.name()), rows_(table.rows) {
    const Hdf5Object group = orderedGroup(file.id(), name);
    std::string lines;
    for (const std::string& comment : table.comments) {
        lines.append(comment).append("\n");
    }
    if (!group.isOpen() || !setText(group.id(), "comments", lines)) {
        fail();
    }
    for (const Hdf5Column& column : table.columns) {
        addColumn(file, group.id(), column);
    }
}

/// Bytes of a column that are alike lie together (shuffle), which is what makes them small.
Hdf5Object Hdf5TableWriter::layout() const {
    Hdf5Object properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(properties.id(), 0);  // the same run, the same bytes
    if (rows_ > 0) {
        const hsize_t chunk = std::min(rows_, kChunk);
        H5Pset_chunk(properties.id(), 1, &chunk);
        H5Pset_shuffle(properties.id());
        H5Pset_deflate(properties.id(), kDeflate);
    }
    return properties;
}

void Hdf5TableWriter::addColumn(const Hdf5Output& file, hid_t group, const Hdf5Column& column) {
    if (!column.sameAs.empty()) {
        if (H5Lcreate_hard(file.id(), column.sameAs.c_str(), group, column.name.c_str(),
                           H5P_DEFAULT, H5P_DEFAULT) < 0) {
            fail();
        }
        stored_.push_back({column, Hdf5Object(-1, H5Dclose), Hdf5Object(-1, H5Tclose), {}});
        return;
    }
    const hsize_t rows = rows_;
    const Hdf5Object space(H5Screate_simple(1, &rows, nullptr), H5Sclose);
    Hdf5Object dataset(H5Dcreate2(group, column.name.c_str(), storedType(column).id(), space.id(),
                                  H5P_DEFAULT, layout().id(), H5P_DEFAULT),
                       H5Dclose);
    if (!dataset.isOpen() ||
        (!column.unit.empty() && !setWord(dataset.id(), "unit", column.unit))) {
        fail();
    }
    stored_.push_back({column, std::move(dataset), writtenType(column), {}});
}

void Hdf5TableWriter::add(double number) {
    Stored& stored = stored_.at(cell_++);
    if (!stored.dataset.isOpen()) {
        return;
    }
    if (stored.column.type == Hdf5Column::Type::Single) {
        append(stored.waits, static_cast<float>(number));
    } else {
        append(stored.waits, number);
    }
}

void Hdf5TableWriter::add(std::string_view text) {
    Stored& stored = stored_.at(cell_++);
    if (stored.dataset.isOpen()) {
        const std::size_t width = std::max<std::size_t>(stored.column.width, 1);
        const std::string_view kept = text.substr(0, width);
        stored.waits.insert(stored.waits.end(), kept.begin(), kept.end());
        stored.waits.resize(stored.waits.size() + width - kept.size(), '\0');
    }
}

void Hdf5TableWriter::endRow() {
    cell_ = 0;
    if (++waiting_ == kChunk) {
        flush();
    }
}

void Hdf5TableWriter::close() {
    flush();
    stored_.clear();
}

void Hdf5TableWriter::flush() {
    if (waiting_ == 0) {
        return;
    }
    for (Stored& stored : stored_) {
        if (stored.dataset.isOpen()) {
            write(stored);
        }
    }
    written_ += waiting_;
    waiting_ = 0;
}

void Hdf5TableWriter::write(Stored& stored) {
    const hsize_t begin = written_;
    const hsize_t count = waiting_;
    const Hdf5Object memory(H5Screate_simple(1, &count, nullptr), H5Sclose);
    const Hdf5Object space(H5Dget_space(stored.dataset.id()), H5Sclose);
    H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr);
    if (H5Dwrite(stored.dataset.id(), stored.type.id(), memory.id(), space.id(), H5P_DEFAULT,
                 stored.waits.data()) < 0) {
        fail();
    }
    stored.waits.clear();
}

void Hdf5TableWriter::fail() const { throw Error(name_ + ": not all of it could be written"); }

Hdf5Rows::Hdf5Rows(const Hdf5Input& file, std::string name) : file_(file), name_(std::move(name)) {
    const std::string folder = "/" + name_ + "/";
    if (file.content().find(Hdf5Item::Kind::Group, "/" + name_) == nullptr) {
        file_.fail(name_, "there is no such table");
    }
    for (const Hdf5Item& item : file.content().items()) {
        if (item.kind != Hdf5Item::Kind::Attribute && item.path.starts_with(folder)) {
            addColumn(item, item.path.substr(folder.size()));
        }
    }
    if (columns_.empty()) {
        file_.fail(name_, "the table has no column");
    }
    blocks_.resize(columns_.size());
}

void Hdf5Rows::addColumn(const Hdf5Item& dataset, const std::string& name) {
    const std::string location = name_ + "/" + name;
    std::optional<Hdf5Column> column =
        dataset.shape.size() == 1 && dataset.offset ? columnOf(dataset) : std::nullopt;
    if (!column) {
        file_.fail(location, "expected a column of numbers or words");
    }
    if (!columns_.empty() && dataset.count != rows_) {
        file_.fail(location, "expected " + std::to_string(rows_) +
                                 " rows as in the columns before, found " +
                                 std::to_string(dataset.count));
    }
    rows_ = dataset.count;
    column->name = name;
    columns_.push_back(std::move(*column));
    datasets_.push_back(&dataset);
}

std::vector<std::string> Hdf5Rows::comments() const {
    std::vector<std::string> lines;
    std::string text = file_.content().text(Hdf5Item::Kind::Attribute, "/" + name_ + "@comments");
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
    const auto count = static_cast<std::size_t>(std::min(kBlock, rows_ - begin_));
    for (std::size_t c = 0; c < columns_.size(); ++c) {
        if (columns_[c].type == Hdf5Column::Type::Text) {
            blocks_[c].texts.resize(count * columns_[c].width);
            file_.content().read(*datasets_[c], begin_, std::span(blocks_[c].texts));
        } else {
            blocks_[c].numbers.resize(count);
            file_.content().read(*datasets_[c], begin_, std::span(blocks_[c].numbers));
        }
    }
    read_ = begin_ + count;
}

double Hdf5Rows::number(std::size_t column) const {
    return blocks_[column].numbers[next_ - 1 - begin_];
}

std::string_view Hdf5Rows::text(std::size_t column) const {
    const std::size_t width = columns_[column].width;
    const std::string_view whole(blocks_[column].texts.data() + (next_ - 1 - begin_) * width,
                                 width);
    return whole.substr(0, whole.find('\0'));
}

}  // namespace asperity
