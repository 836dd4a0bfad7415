#pragma once

#include "core/io/ByteReader.h"

#include <cstdint>
#include <optional>
#include <string>

namespace asperity {

/// One named value of a serialized Gwyddion object. The value stays in the source.
struct GwyComponent {
    std::string name;
    char type = 0;   ///< one of b c i q d s o, in capitals an array
    ByteSpan value;  ///< of a string without the NUL, of an array the items
};

/// A serialized object: a class name and a block of components.
struct GwyObject {
    std::string className;
    ByteSpan components;
};

/// Reads an object at the reader's place. @throw InputError when it does not fit
[[nodiscard]] GwyObject takeGwyObject(ByteReader& reader);

/// Walks through the components of an object, one level deep: what is inside a component that
/// nobody asks for is skipped by its size, so depth and unknown classes cost nothing.
/// Source: Gwyddion user guide, "Gwyddion native file format"; docs/formats.md 1.
class GwyComponents {
public:
    /// @param source must outlive this
    GwyComponents(const GwyObject& object, const ByteSource& source)
        : reader_(source, object.components) {}

    /// The next component; empty at the end. @throw InputError when it does not fit
    [[nodiscard]] std::optional<GwyComponent> next();
    /// Of the component that was asked for last, as far as it could be read.
    [[nodiscard]] const std::string& name() const { return name_; }

private:
    ByteSpan takeValue(char type);
    ByteSpan takeArray(char type);

    ByteReader reader_;
    std::string name_;
};

/// The values, checked to have the type that the format prescribes. @throw InputError otherwise
[[nodiscard]] std::int32_t gwyInteger(const GwyComponent& component, const ByteSource& source);
[[nodiscard]] double gwyNumber(const GwyComponent& component, const ByteSource& source);
[[nodiscard]] std::string gwyText(const GwyComponent& component, const ByteSource& source);
/// Where raw doubles lie, lowest byte first.
[[nodiscard]] ByteSpan gwyNumbers(const GwyComponent& component, const ByteSource& source);
[[nodiscard]] GwyObject gwyObject(const GwyComponent& component, const ByteSource& source);

}  // namespace asperity
