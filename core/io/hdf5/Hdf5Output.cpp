#include "core/io/hdf5/Hdf5Output.h"

#include "core/Error.h"
#include "core/io/hdf5/Hdf5Program.h"

#include <algorithm>

namespace asperity {

namespace {

/// The library prints by itself what went wrong, on the terminal, for each thread that does not ask
/// it to be silent.
void beSilent() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

/// Opens without locks: that of a TemporaryFile is ours, and some file systems have none.
Hdf5Object access() {
    beSilent();
    Hdf5Object properties(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
    H5Pset_file_locking(properties.id(), false, true);
    return properties;
}

/// Creates a file of HDF5 1.10: before, an empty column took two kilobytes.
Hdf5Object created(const std::filesystem::path& path) {
    const Hdf5Object properties = access();
    H5Pset_libver_bounds(properties.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    const Hdf5Object creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation.id(), false);  // the same run, the same bytes
    H5Pset_userblock(creation.id(), kSealBytes);
    return {H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), properties.id()), H5Fclose};
}

Hdf5Object newAttribute(hid_t object, const char* attribute, const Hdf5Object& type) {
    const Hdf5Object space(H5Screate(H5S_SCALAR), H5Sclose);
    return {H5Acreate2(object, attribute, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT),
            H5Aclose};
}

}  // namespace

Hdf5Object textType(std::size_t bytes) {
    Hdf5Object type(H5Tcopy(H5T_C_S1), H5Tclose);
    H5Tset_size(type.id(), std::max<std::size_t>(bytes, 1));
    H5Tset_cset(type.id(), H5T_CSET_UTF8);
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    return type;
}

bool setText(hid_t object, const char* attribute, const std::string& text) {
    const Hdf5Object type = textType(text.size());
    const Hdf5Object made = newAttribute(object, attribute, type);
    return made.isOpen() && H5Awrite(made.id(), type.id(), text.c_str()) >= 0;
}

bool setWord(hid_t object, const char* attribute, const std::string& word) {
    const Hdf5Object type = textType(H5T_VARIABLE);
    const Hdf5Object made = newAttribute(object, attribute, type);
    const char* const text = word.c_str();
    return made.isOpen() && H5Awrite(made.id(), type.id(), &text) >= 0;
}

Hdf5Output::Hdf5Output(const std::filesystem::path& path)
    : name_(path.string()), file_(created(path)) {
    if (!file_.isOpen()) {
        throw Error(name_ + ": cannot be written");
    }
}

void Hdf5Output::setAttribute(const char* attribute, const std::string& text) {
    if (!setText(id(), attribute, text)) {
        throw Error(name_ + ": not all of it could be written");
    }
}

void Hdf5Output::addList(const char* list, std::span<const std::uint32_t> numbers) {
    const hsize_t size = numbers.size();
    const Hdf5Object space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    const Hdf5Object properties(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(properties.id(), false);
    const Hdf5Object made(H5Dcreate2(id(), list, H5T_STD_U32LE, space.id(), H5P_DEFAULT,
                                     properties.id(), H5P_DEFAULT),
                          H5Dclose);
    if (!made.isOpen() ||
        H5Dwrite(made.id(), H5T_NATIVE_UINT32, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()) < 0) {
        throw Error(name_ + ": not all of it could be written");
    }
}

void Hdf5Output::close() {
    const bool isWritten = H5Fflush(id(), H5F_SCOPE_LOCAL) >= 0;
    file_ = Hdf5Object(-1, H5Fclose);
    if (!isWritten) {
        throw Error(name_ + ": not all of it could be written");
    }
    sealHdf5(name_);
}

}  // namespace asperity
