#include "core/io/NestedText.h"

#include "core/Error.h"

#include <algorithm>
#include <cstddef>

namespace asperity {

namespace {

/// Brackets and dots of a key within each other; Asperity's own texts have fewer than ten. A
/// thousand times as many still fit on the stack of a thread.
constexpr std::size_t kMaxDepth = 64;

struct NestedLimits {
    std::size_t bytes;
    std::size_t values;
    std::size_t stringBytes;  ///< of one string: while it is read, the parser holds it four times
};

/// A value of TOML takes up to 250 bytes (a table of one letter), one of JSON up to 100: together
/// about 100 and 200 MB. A scene has some hundred values. A summary has 400 a touch, points of
/// numbers counted, in 9 kB: the bytes are those of as many touches as the values allow.
NestedLimits limitsOf(NestedSyntax syntax) {
    constexpr NestedLimits kToml{std::size_t{1} << 24U, std::size_t{1} << 18U,
                                 std::size_t{1} << 24U};
    constexpr NestedLimits kJson{std::size_t{3} << 24U, std::size_t{1} << 21U,
                                 std::size_t{1} << 20U};
    return syntax == NestedSyntax::Toml ? kToml : kJson;
}

class NestedScan {
public:
    NestedScan(std::string_view text, NestedSyntax syntax, const std::string& file)
        : text_(text), isToml_(syntax == NestedSyntax::Toml), most_(limitsOf(syntax)), file_(file) {
        if (text.size() > most_.bytes) {
            throw InputError(file, "",
                             "it has " + std::to_string(text.size()) + " bytes; expected at most " +
                                 std::to_string(most_.bytes));
        }
    }

    void check() {
        while (offset_ < text_.size()) {
            take(text_[offset_]);
        }
    }

private:
    void take(char c) {
        ++offset_;
        if (c == '"' || (isToml_ && c == '\'')) {
            skipString(c);
        } else if (isToml_ && c == '#') {
            offset_ = std::min(text_.find('\n', offset_), text_.size());
        } else if (c == '.') {
            ++dots_;
            addValue();
        } else if (c == '[' || c == '{') {
            dots_ = 0;
            ++depth_;
            addValue();
        } else if (c == ']' || c == '}') {
            dots_ = 0;
            depth_ -= std::min<std::size_t>(depth_, 1);
        } else if (c == ',' || c == '=' || c == ':' || c == '\n') {
            dots_ = 0;
            line_ += c == '\n' ? 1 : 0;
            if (c == ',' || c == '=') {
                addValue();
            }
        }
    }

    /// Behind its first quotation mark.
    void skipString(char quote) {
        const std::string three(3, quote);
        const bool isLong = isToml_ && text_.substr(offset_ - 1).starts_with(three);
        const std::string_view end = isLong ? std::string_view(three) : std::string_view(&quote, 1);
        offset_ += isLong ? 2 : 0;
        const std::size_t begin = offset_;
        while (offset_ < text_.size() && !text_.substr(offset_).starts_with(end)) {
            if (text_[offset_] == '\n') {
                if (!isLong) {
                    requireShort(offset_ - begin);
                    return;  // never closed: the parser says so
                }
                ++line_;
            }
            offset_ += quote == '"' && text_[offset_] == '\\' ? 2 : 1;
        }
        offset_ = std::min(offset_ + end.size(), text_.size());
        requireShort(offset_ - begin);
    }

    void requireShort(std::size_t stringBytes) const {
        if (stringBytes > most_.stringBytes) {
            fail("a string of more than " + std::to_string(most_.stringBytes) + " bytes");
        }
    }

    void addValue() {
        if (depth_ + dots_ > kMaxDepth) {
            fail("values nested deeper than " + std::to_string(kMaxDepth));
        }
        if (++values_ > most_.values) {
            fail("more than " + std::to_string(most_.values) + " values");
        }
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(file_, "line " + std::to_string(line_),
                         what + ": no file of Asperity's has so many");
    }

    std::string_view text_;
    bool isToml_;
    NestedLimits most_;
    const std::string& file_;
    std::size_t offset_ = 0;
    std::size_t line_ = 1;
    std::size_t depth_ = 0;
    std::size_t dots_ = 0;  ///< of the present key
    std::size_t values_ = 0;
};

}  // namespace

void requireParsable(std::string_view text, NestedSyntax syntax, const std::string& file) {
    NestedScan(text, syntax, file).check();
}

}  // namespace asperity
