#pragma once

#include "core/io/ByteReader.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// One named value of a serialised Gwyddion object; nothing is copied.
struct GwyComponent {
    std::string_view name;
    char type = 0;           ///< one of b c i q d s o, in capitals an array
    std::string_view value;  ///< its bytes; of a string without the NUL, of an array the items
    std::size_t place = 0;   ///< byte of the value in the file
};

/// A serialised object: a class name and a block of components.
struct GwyObject {
    std::string_view className;
    std::string_view components;
    std::size_t place = 0;  ///< byte of the components in the file
};

/// Reads an object at the reader's place. @throw InputError when it does not fit
[[nodiscard]] GwyObject takeGwyObject(ByteReader& reader);

/// Walks through the components of an object, one level deep: what is inside a component that
/// nobody asks for is skipped by its size, so depth and unknown classes cost nothing.
/// Source: Gwyddion user guide, "Gwyddion native file format"; docs/formats.md 1.
class GwyComponents {
public:
    GwyComponents(const GwyObject& object, std::string_view file)
        : reader_(object.components, file, object.place) {}

    /// The next component; empty at the end. @throw InputError when it does not fit
    [[nodiscard]] std::optional<GwyComponent> next();

private:
    std::string_view takeValue(char type);
    std::string_view takeArray(char type);

    ByteReader reader_;
};

/// The values, checked to have the type that the format prescribes. @throw InputError otherwise
[[nodiscard]] std::int32_t gwyInteger(const GwyComponent& component, std::string_view file);
[[nodiscard]] double gwyNumber(const GwyComponent& component, std::string_view file);
[[nodiscard]] std::string gwyText(const GwyComponent& component, std::string_view file);
/// Raw doubles, lowest byte first.
[[nodiscard]] std::string_view gwyNumbers(const GwyComponent& component, std::string_view file);
[[nodiscard]] GwyObject gwyObject(const GwyComponent& component, std::string_view file);

}  // namespace asperity
