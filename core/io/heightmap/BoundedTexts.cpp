#include "core/io/heightmap/BoundedTexts.h"

#include <algorithm>
#include <utility>

namespace asperity {

TextQuota TextQuota::ofEach(std::size_t images) {
    constexpr TextQuota kOne;
    const std::size_t shares = std::max(images, kFullShares);
    return {.count = kOne.count * kFullShares / shares, .bytes = kOne.bytes * kFullShares / shares};
}

void BoundedTexts::add(std::string name, std::string text) {
    if (texts_.contains(name)) {
        return;
    }
    const std::size_t bytes = name.size() + text.size();
    if (texts_.size() == quota_.count || bytes > quota_.bytes - bytes_) {
        isCut_ = true;
        return;
    }
    bytes_ += bytes;
    texts_.emplace(std::move(name), std::move(text));
}

void BoundedTexts::set(std::string name, std::string text) {
    const auto old = texts_.find(name);
    if (old == texts_.end()) {
        add(std::move(name), std::move(text));
        return;
    }
    const std::size_t others = bytes_ - old->second.size();
    if (text.size() > quota_.bytes - others) {
        isCut_ = true;
        return;
    }
    bytes_ = others + text.size();
    old->second = std::move(text);
}

void BoundedTexts::remove(const std::string& name) {
    if (const auto text = texts_.find(name); text != texts_.end()) {
        bytes_ -= text->first.size() + text->second.size();
        texts_.erase(text);
    }
}

void BoundedTexts::add(const std::map<std::string, std::string>& texts) {
    for (const auto& [name, text] : texts) {
        add(name, text);
    }
}

void BoundedTexts::add(const BoundedTexts& texts) {
    add(texts.all());
    isCut_ = isCut_ || texts.isCut_;
}

}  // namespace asperity
