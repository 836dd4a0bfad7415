#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace asperity {

/// Java properties, as JPK's headers are: `key=value` lines, `#` comments, backslash escapes.
/// `KEY.WORD.*=N` inserts all `WORD.N.` entries of the shared header at KEY. Source:
/// docs/formats.md 21.
class JpkProperties {
public:
    /// @param text ISO-8859-1
    /// @param shared header that references are to; null: there is none; must outlive this
    explicit JpkProperties(std::string text, const JpkProperties* shared = nullptr);
    JpkProperties(const JpkProperties&) = delete;  // its entries are views of its text
    JpkProperties& operator=(const JpkProperties&) = delete;
    ~JpkProperties() = default;

    /// The value of a key, its own or one that a reference inserts; empty: there is none.
    [[nodiscard]] std::optional<std::string_view> find(std::string_view key) const {
        return find(key, kMaxReferences);
    }
    /// The same; an empty text where there is none.
    [[nodiscard]] std::string_view text(std::string_view key) const {
        return find(key).value_or(std::string_view());
    }
    /// Empty: there is none, or it is no finite number.
    [[nodiscard]] std::optional<double> number(std::string_view key) const;

private:
    static constexpr int kMaxReferences = 4;  ///< one after the other; they could form a circle

    /// "channel.height.lcd-info.*=3"
    struct Reference {
        std::string_view base;   ///< "channel.height."
        std::string_view word;   ///< "lcd-info"
        std::string_view index;  ///< "3"
    };

    void add(std::string_view line);
    [[nodiscard]] std::string_view unescaped(std::string_view text);
    [[nodiscard]] const std::string_view* own(std::string_view key) const;
    [[nodiscard]] std::optional<std::string_view> find(std::string_view key, int references) const;

    std::string text_;
    std::deque<std::string> unescaped_;  ///< texts that were written with a backslash
    std::vector<std::pair<std::string_view, std::string_view>> entries_;  ///< sorted by key
    std::vector<Reference> references_;
    const JpkProperties* shared_;
};

}  // namespace asperity
