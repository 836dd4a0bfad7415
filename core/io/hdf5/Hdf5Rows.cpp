#include "core/io/hdf5/Hdf5Rows.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace asperity {

namespace {

constexpr std::uint64_t kBlock = 8192;                        // rows, as they are stored together
constexpr std::uint32_t kMaxWidth = std::uint32_t{1} << 12U;  // of a text's cells [byte]

/// What a column's dataset holds; nothing where Asperity writes no such one.
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
    const std::string place = name_ + "/" + name;
    std::optional<Hdf5Column> column =
        dataset.shape.size() == 1 && dataset.place ? columnOf(dataset) : std::nullopt;
    if (!column) {
        file_.fail(place, "expected a column of numbers or words");
    }
    if (!columns_.empty() && dataset.count != rows_) {
        file_.fail(place, "expected " + std::to_string(rows_) +
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
