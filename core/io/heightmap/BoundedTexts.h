#pragma once

#include <cstddef>
#include <map>
#include <string>

namespace asperity {

/// Limits of the texts that one image may carry.
struct TextQuota {
    /// Files of instruments have up to 1000 an image.
    std::size_t count = std::size_t{1} << 14U;
    std::size_t bytes = std::size_t{1} << 20U;  ///< of names and texts

    /// All images of a file together may carry this many quotas: enough for 512 images with 1000
    /// texts, 40 kB, each.
    static constexpr std::size_t kFullShares = 32;
    /// Returns the quota of each image where a file has so many of them.
    [[nodiscard]] static TextQuota ofEach(std::size_t images);
};

/// Limits of a header's texts while a reader looks for scale and other values in them. No image
/// carries so many.
inline constexpr TextQuota kHeaderQuota{.count = std::size_t{1} << 18U,
                                        .bytes = std::size_t{1} << 22U};

/// Texts of a file by their names, as many as an image may carry: a small file can hold so many
/// short ones that they take many times its size of memory. What is beyond is left out.
class BoundedTexts {
public:
    BoundedTexts() = default;
    explicit BoundedTexts(const TextQuota& quota) : quota_(quota) {}

    /// Adds a text; of several with the same name the first one counts.
    void add(std::string name, std::string text);
    /// Adds a text; of several with the same name the last one that is not left out counts.
    void set(std::string name, std::string text);
    void remove(const std::string& name);
    /// Adds all of these.
    void add(const std::map<std::string, std::string>& texts);
    /// Likewise; it is cut where these are.
    void add(const BoundedTexts& texts);

    [[nodiscard]] const std::map<std::string, std::string>& all() const { return texts_; }
    /// Whether texts were left out.
    [[nodiscard]] bool isCut() const { return isCut_; }

private:
    TextQuota quota_;
    std::map<std::string, std::string> texts_;
    std::size_t bytes_ = 0;
    bool isCut_ = false;
};

}  // namespace asperity
