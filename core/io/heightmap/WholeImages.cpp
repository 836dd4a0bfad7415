#include "core/io/heightmap/WholeImages.h"

namespace asperity {

bool WholeImages::holds(const ByteSource& bytes, const SampleLayout& layout,
                        const std::string& owner, const std::string& name) {
    try {
        requireSamples(bytes, layout, owner);
        return true;
    } catch (const InputError& error) {
        leaveOut(name, error);
        return false;
    }
}

void WholeImages::leaveOut(const std::string& name, const InputError& why) {
    missing_.push_back(name);
    if (!refusal_) {
        refusal_ = why;
    }
}

void WholeImages::finish(StoredScan& scan) const {
    if (scan.channels.empty()) {
        requireAll();
    }
    if (missing_.empty()) {
        return;
    }
    std::string names;
    for (const std::string& name : missing_) {
        names += (names.empty() ? "'" : ", '") + name + "'";
    }
    scan.notes.push_back("the file is truncated: it does not hold all of " + names +
                         (missing_.size() == 1 ? ", which is left out" : ", which are left out"));
}

void WholeImages::requireAll() const {
    if (refusal_) {
        throw InputError(*refusal_);
    }
}

}  // namespace asperity
