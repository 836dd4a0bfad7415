#include "core/io/heightmap/PhysicalUnit.h"

#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <optional>

namespace asperity {

namespace {

struct Prefix {
    std::string_view symbol;
    double factor;
};

constexpr std::array<Prefix, 24> kPrefixes = {
    {{"Y", 1e24},  {"Z", 1e21},  {"E", 1e18},  {"P", 1e15},  {"T", 1e12},      {"G", 1e9},
     {"M", 1e6},   {"k", 1e3},   {"h", 1e2},   {"da", 1e1},  {"d", 1e-1},      {"c", 1e-2},
     {"m", 1e-3},  {"u", 1e-6},  {"~", 1e-6},  {"µ", 1e-6},  {"\u03BC", 1e-6}, {"n", 1e-9},
     {"p", 1e-12}, {"f", 1e-15}, {"a", 1e-18}, {"z", 1e-21}, {"y", 1e-24},     {"", 1.0}}};

constexpr std::array<std::string_view, 14> kBases = {"m", "V",  "A", "N",   "Hz",  "s", "W",
                                                     "F", "Pa", "J", "rad", "Ohm", "K", "eV"};

/// Å may be one letter, the sign of the unit, or an A with a combining ring.
constexpr std::array<std::string_view, 6> kAngstrom = {"\u00C5", "\u212B",   "A\u030A",
                                                       "Ang",    "Angstrom", "angstrom"};
constexpr std::array<std::string_view, 5> kDegree = {"deg", "\u00B0", "\u00BA", "degree",
                                                     "degrees"};

// Names of prefixes and units in full, in lower case and without a plural.

constexpr std::array<Prefix, 10> kPrefixNames = {{{"giga", 1e9},
                                                  {"mega", 1e6},
                                                  {"kilo", 1e3},
                                                  {"centi", 1e-2},
                                                  {"milli", 1e-3},
                                                  {"micro", 1e-6},
                                                  {"nano", 1e-9},
                                                  {"pico", 1e-12},
                                                  {"femto", 1e-15},
                                                  {"", 1.0}}};

struct UnitName {
    std::string_view name;
    std::string_view base;
    double factor = 1.0;
};

constexpr std::array<UnitName, 19> kUnitNames = {{{"meter", "m"},
                                                  {"metre", "m"},
                                                  {"volt", "V"},
                                                  {"ampere", "A"},
                                                  {"newton", "N"},
                                                  {"hertz", "Hz"},
                                                  {"second", "s"},
                                                  {"watt", "W"},
                                                  {"farad", "F"},
                                                  {"pascal", "Pa"},
                                                  {"joule", "J"},
                                                  {"radian", "rad"},
                                                  {"degree", "deg"},
                                                  {"ohm", "Ohm"},
                                                  {"kelvin", "K"},
                                                  {"electronvolt", "eV"},
                                                  {"angstrom", "m", 1e-10},
                                                  {"micron", "m", 1e-6},
                                                  {"dimensionless", ""}}};

bool isListed(const auto& list, std::string_view text) {
    return std::find(list.begin(), list.end(), text) != list.end();
}

/// A unit whose name is written in full, such as "Volts" or "nanometer".
std::optional<PhysicalUnit> namedUnit(std::string_view text) {
    const std::string name = lowerCase(text);
    for (const Prefix& prefix : kPrefixNames) {
        for (const UnitName& unit : kUnitNames) {
            const std::string one = std::string(prefix.symbol) + std::string(unit.name);
            if (name == one || name == one + "s") {
                return PhysicalUnit{prefix.factor * unit.factor, std::string(unit.base)};
            }
        }
    }
    return std::nullopt;
}

std::optional<PhysicalUnit> simpleUnit(std::string_view text) {
    if (isListed(kAngstrom, text)) {
        return PhysicalUnit{1e-10, "m"};
    }
    if (isListed(kDegree, text)) {
        return PhysicalUnit{1.0, "deg"};
    }
    for (const Prefix& prefix : kPrefixes) {
        if (text.starts_with(prefix.symbol) &&
            isListed(kBases, text.substr(prefix.symbol.size()))) {
            return PhysicalUnit{prefix.factor, std::string(text.substr(prefix.symbol.size()))};
        }
    }
    return namedUnit(text);
}

std::optional<PhysicalUnit> quotient(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash == std::string_view::npos) {
        return std::nullopt;
    }
    const std::optional<PhysicalUnit> above = simpleUnit(trimmed(text.substr(0, slash)));
    const std::string_view divisor = trimmed(text.substr(slash + 1));
    if (!above || divisor.empty()) {
        return std::nullopt;
    }
    const PhysicalUnit below =
        simpleUnit(divisor).value_or(PhysicalUnit{1.0, std::string(divisor)});
    return PhysicalUnit{above->factor / below.factor, above->base + "/" + below.base};
}

}  // namespace

PhysicalUnit parseUnit(std::string_view text) {
    text = trimmed(text);
    std::optional<PhysicalUnit> unit = simpleUnit(text);
    if (!unit) {
        unit = quotient(text);
    }
    return unit.value_or(PhysicalUnit{1.0, std::string(text)});
}

PhysicalUnit parseLengthUnit(std::string_view text) {
    return parseUnit(trimmed(text) == "A" ? "Angstrom" : text);
}

}  // namespace asperity
