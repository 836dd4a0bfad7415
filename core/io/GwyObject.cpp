#include "core/io/GwyObject.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

namespace asperity {

namespace {

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

void requireType(const GwyComponent& component, char type, std::string_view file) {
    if (component.type == type) {
        return;
    }
    throw InputError(std::string(file), "byte " + std::to_string(component.place),
                     "the component '" + toUtf8(component.name) + "' has the type '" +
                         toUtf8({&component.type, 1}) + "'; expected '" + type + "'");
}

}  // namespace

GwyObject takeGwyObject(ByteReader& reader) {
    GwyObject object;
    object.className = reader.takeString("a class name");
    const auto size = reader.takeNumber<std::uint32_t>("an object's size");
    object.place = reader.place();
    object.components = reader.take(size, "an object");
    return object;
}

std::optional<GwyComponent> GwyComponents::next() {
    if (reader_.atEnd()) {
        return std::nullopt;
    }
    GwyComponent component;
    component.name = reader_.takeString("a component's name");
    component.type = reader_.take(1, "a component's type")[0];
    component.place = reader_.place();
    component.value = takeValue(component.type);
    return component;
}

std::string_view GwyComponents::takeValue(char type) {
    if (type == 's') {
        return reader_.takeString("a text");
    }
    if (type == 'o') {
        ByteReader ahead = reader_;
        (void)takeGwyObject(ahead);
        return reader_.take(ahead.place() - reader_.place(), "an object");
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

std::string_view GwyComponents::takeArray(char type) {
    const std::uint64_t count = reader_.takeNumber<std::uint32_t>("an array's length");
    if (const std::uint64_t size = valueSize(type); size != 0) {
        return reader_.take(count * size, "an array");
    }
    if (type != 'S' && type != 'O') {
        reader_.fail("unknown type of array; the file is damaged");
    }
    ByteReader ahead = reader_;
    for (std::uint64_t i = 0; i < count; ++i) {
        if (type == 'S') {
            (void)ahead.takeString("a text");
        } else {
            (void)takeGwyObject(ahead);
        }
    }
    return reader_.take(ahead.place() - reader_.place(), "an array");
}

std::int32_t gwyInteger(const GwyComponent& component, std::string_view file) {
    requireType(component, 'i', file);
    return littleEndian<std::int32_t>(component.value.data());
}

double gwyNumber(const GwyComponent& component, std::string_view file) {
    requireType(component, 'd', file);
    return littleEndian<double>(component.value.data());
}

std::string gwyText(const GwyComponent& component, std::string_view file) {
    requireType(component, 's', file);
    return toUtf8(component.value);
}

std::string_view gwyNumbers(const GwyComponent& component, std::string_view file) {
    requireType(component, 'D', file);
    return component.value;
}

GwyObject gwyObject(const GwyComponent& component, std::string_view file) {
    requireType(component, 'o', file);
    ByteReader reader(component.value, file, component.place);
    return takeGwyObject(reader);
}

}  // namespace asperity
