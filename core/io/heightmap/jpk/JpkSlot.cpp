#include "core/io/heightmap/jpk/JpkSlot.h"

#include "core/io/TextValue.h"

namespace asperity {

namespace {

constexpr std::uint16_t kSlotCount = 0x8080;
constexpr std::uint16_t kDefaultSlot = 0x8081;

// Tags of the first slot; those of the next one are kStep further.
constexpr std::uint16_t kSlotName = 0x8090;
constexpr std::uint16_t kEncoder = 0x80A1;
constexpr std::uint16_t kSlotUnit = 0x80A2;
constexpr std::uint16_t kScaling = 0x80A3;
constexpr std::uint16_t kMultiplier = 0x80A4;
constexpr std::uint16_t kSlotOffset = 0x80A5;
constexpr std::uint16_t kSlotNoData = 0x80AA;
constexpr std::int64_t kStep = 0x30;
/// Number of slots that have room among the tags.
constexpr std::int64_t kMaxSlots = (0xFFFF - kSlotNoData) / kStep + 1;

std::uint16_t tagOf(std::uint16_t first, std::int64_t slot) {
    return static_cast<std::uint16_t>(first + slot * kStep);
}

double requireNumber(const TiffDirectory& channel, std::uint16_t tag) {
    const std::optional<double> value = channel.number(tag);
    if (!value) {
        channel.fail("tag " + std::to_string(tag) + ": expected the scale of a slot");
    }
    return *value;
}

JpkSlot readSlot(const TiffDirectory& channel, std::int64_t number) {
    JpkSlot slot{.name = channel.text(tagOf(kSlotName, number)),
                 .unit = channel.text(tagOf(kSlotUnit, number))};
    const std::string scaling = channel.text(tagOf(kScaling, number));
    if (scaling == "LinearScaling") {
        slot.multiplier = requireNumber(channel, tagOf(kMultiplier, number));
        slot.offset = requireNumber(channel, tagOf(kSlotOffset, number));
    } else if (scaling != "NullScaling") {
        channel.fail("its slot '" + slot.name + "' has the scaling '" + scaling +
                     "'; expected LinearScaling or NullScaling");
    }
    // Without this encoder the largest count is often a height: counts are spread over all bits.
    if (channel.text(tagOf(kEncoder, number)).ends_with("WithValidity")) {
        slot.noData = requireNumber(channel, tagOf(kSlotNoData, number));
    }
    return slot;
}

}  // namespace

JpkSlot defaultJpkSlot(const TiffDirectory& channel) {
    const std::string name = channel.text(kDefaultSlot);
    const std::int64_t count = channel.integer(kSlotCount).value_or(0);
    if (count < 0 || count > kMaxSlots) {
        channel.fail("it has " + std::to_string(count) + " slots; expected 0 to " +
                     std::to_string(kMaxSlots));
    }
    if (count == 0) {
        return {};
    }
    for (std::int64_t slot = 0; slot < count; ++slot) {
        if (channel.text(tagOf(kSlotName, slot)) == name) {
            return readSlot(channel, slot);
        }
    }
    channel.fail("its default slot '" + name + "' is not among its " + std::to_string(count) +
                 " slots");
}

}  // namespace asperity
