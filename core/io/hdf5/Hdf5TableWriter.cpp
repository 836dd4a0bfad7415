#include "core/io/hdf5/Hdf5TableWriter.h"

#include "core/Error.h"

#include <algorithm>
#include <cstring>

namespace asperity {

namespace {

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

}  // namespace

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
    const Hdf5Object place(H5Dget_space(stored.dataset.id()), H5Sclose);
    H5Sselect_hyperslab(place.id(), H5S_SELECT_SET, &begin, nullptr, &count, nullptr);
    if (H5Dwrite(stored.dataset.id(), stored.type.id(), memory.id(), place.id(), H5P_DEFAULT,
                 stored.waits.data()) < 0) {
        fail();
    }
    stored.waits.clear();
}

void Hdf5TableWriter::fail() const { throw Error(name_ + ": not all of it could be written"); }

}  // namespace asperity
