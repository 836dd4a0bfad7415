#include "core/io/hdf5/Hdf5Input.h"

#include "core/io/FileBytes.h"
#include "core/io/hdf5/Hdf5Seal.h"

#include <algorithm>

namespace asperity {

namespace {

using Kind = Hdf5Item::Kind;

Hdf5Content sealedContent(const FileBytes& file, std::vector<std::string> wanted) {
    requireSeal(file);
    std::ranges::for_each(wanted, [](std::string& name) { name.insert(0, "/"); });
    return readHdf5(file, wanted);
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
        item->bytes != sizeof(std::uint32_t) || !item->place) {
        fail(list, "expected a list of numbers");
    }
    std::vector<double> numbers(item->count);
    content_.read(*item, 0, numbers);
    return {numbers.begin(), numbers.end()};
}

}  // namespace asperity
