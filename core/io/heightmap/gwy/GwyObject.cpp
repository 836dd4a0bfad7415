#include "core/io/heightmap/gwy/GwyObject.h"

#include "core/Error.h"
#include "core/Utf8.h"
#include "core/io/TextValue.h"

#include <algorithm>

namespace asperity {

namespace {

/// Of a title or a unit: what is beyond is cut off.
constexpr std::uint64_t kGwyMaxText = 65536;

/// Bytes of one value of a type with a fixed size; 0: no such type.
std::uint64_t valueSize(char type) {
    switch (type) {
    case 'b':
    case 'c':
    case 'C':
        return 1;
    case 'i':
    case 'I':
        return 4;
    case 'q':
    case 'Q':
    case 'd':
    case 'D':
        return 8;
    default:
        return 0;
    }
}

void requireType(const GwyComponent& component, char type, const ByteSource& source) {
    if (component.type == type) {
        return;
    }
    throw InputError(source.name(), "byte " + std::to_string(component.value.place),
                     "the component '" + toUtf8(component.name) + "' has the type '" +
                         toUtf8({&component.type, 1}) + "'; expected '" + type + "'");
}

}  // namespace

GwyObject takeGwyObject(ByteReader& reader) {
    GwyObject object;
    object.className = reader.takeName("a class name");
    const auto size = reader.takeNumber<std::uint32_t>("an object's size");
    object.components = reader.take(size, "an object");
    return object;
}

std::optional<GwyComponent> GwyComponents::next() {
    if (reader_.atEnd()) {
        return std::nullopt;
    }
    GwyComponent component;
    name_.clear();
    component.name = name_ = reader_.takeName("a component's name");
    component.type = reader_.takeNumber<char>("a component's type");
    component.value = takeValue(component.type);
    return component;
}

ByteSpan GwyComponents::takeValue(char type) {
    if (type == 's') {
        return reader_.takeString("a text");
    }
    if (type == 'o') {
        const std::uint64_t start = reader_.place();
        (void)takeGwyObject(reader_);
        return {start, reader_.place() - start};
    }
    if (type >= 'A' && type <= 'Z') {
        return takeArray(type);
    }
    const std::uint64_t size = valueSize(type);
    if (size == 0) {
        reader_.fail("unknown type of component; the file is damaged");
    }
    return reader_.take(size, "a value");
}

ByteSpan GwyComponents::takeArray(char type) {
    const std::uint64_t count = reader_.takeNumber<std::uint32_t>("an array's length");
    if (const std::uint64_t size = valueSize(type); size != 0) {
        return reader_.take(count * size, "an array");
    }
    if (type != 'S' && type != 'O') {
        reader_.fail("unknown type of array; the file is damaged");
    }
    const std::uint64_t start = reader_.place();
    for (std::uint64_t i = 0; i < count; ++i) {
        if (type == 'S') {
            (void)reader_.takeString("a text");
        } else {
            (void)takeGwyObject(reader_);
        }
    }
    return {start, reader_.place() - start};
}

std::int32_t gwyInteger(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'i', source);
    return numberIn<std::int32_t>(source, component.value);
}

double gwyNumber(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'd', source);
    return numberIn<double>(source, component.value);
}

std::string gwyText(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 's', source);
    const ByteSpan& value = component.value;
    constexpr std::uint64_t kCharacter = 4;
    const std::string text =
        bytesOf(source, {value.place, std::min(value.count, kGwyMaxText + kCharacter)});
    return toUtf8(utf8Start(text, kGwyMaxText));
}

ByteSpan gwyNumbers(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'D', source);
    return component.value;
}

GwyObject gwyObject(const GwyComponent& component, const ByteSource& source) {
    requireType(component, 'o', source);
    ByteReader reader(source, component.value);
    return takeGwyObject(reader);
}

}  // namespace asperity
