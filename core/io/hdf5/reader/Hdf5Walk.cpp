#include "core/io/hdf5/reader/Hdf5Walk.h"

#include "core/io/hdf5/reader/Hdf5Values.h"

#include <algorithm>
#include <stdexcept>

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

}  // namespace

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

}  // namespace asperity
