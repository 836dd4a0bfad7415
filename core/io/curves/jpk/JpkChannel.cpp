#include "core/io/curves/jpk/JpkChannel.h"

#include "core/Error.h"
#include "core/io/TextValue.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity {

namespace {

struct JpkTypeRow {
    std::string_view name;
    SampleType type;
};

/// Names of encoders, then those of data without one.
constexpr std::array<JpkTypeRow, 14> kJpkTypes = {{{"signedshort", SampleType::Int16},
                                                   {"signedshort-limited", SampleType::Int16},
                                                   {"unsignedshort", SampleType::UInt16},
                                                   {"unsignedshort-limited", SampleType::UInt16},
                                                   {"signedinteger", SampleType::Int32},
                                                   {"signedinteger-limited", SampleType::Int32},
                                                   {"unsignedinteger", SampleType::UInt32},
                                                   {"unsignedinteger-limited", SampleType::UInt32},
                                                   {"signedlong", SampleType::Int64},
                                                   {"float-data", SampleType::Float32},
                                                   {"float", SampleType::Float32},
                                                   {"double-data", SampleType::Float64},
                                                   {"double", SampleType::Float64},
                                                   {"short", SampleType::Int16}}};

const JpkTypeRow* typeRow(std::string_view name) {
    const auto* const found = std::ranges::find(kJpkTypes, name, &JpkTypeRow::name);
    return found == kJpkTypes.end() ? nullptr : found;
}

}  // namespace

JpkChannel::JpkChannel(const JpkProperties& header, std::string name, std::string file)
    : header_(&header), name_(std::move(name)), file_(std::move(file)) {}

std::string_view JpkChannel::find(std::string_view tail) const {
    return header_->text("channel." + name_ + "." + std::string(tail));
}

std::string_view JpkChannel::slotText(std::string_view slot, std::string_view tail) const {
    return find("conversion-set.conversion." + std::string(slot) + "." + std::string(tail));
}

std::string_view JpkChannel::dataFile() const { return find("data.file.name"); }

/// Files of version 0 have the encoder among the data, later ones in the shared header.
std::string_view JpkChannel::typeName() const {
    for (const char* const key : {"data.encoder.type", "encoder.type", "data.type", "type"}) {
        if (const std::string_view name = find(key); !name.empty()) {
            return name;
        }
    }
    return {};
}

SampleType JpkChannel::sampleType() const {
    const JpkTypeRow* const row = typeRow(typeName());
    if (row == nullptr) {
        fail("no type of samples is called '" + std::string(typeName()) + "'");
    }
    return row->type;
}

JpkScaling JpkChannel::linear(const std::string& path) const {
    const std::string start = "channel." + name_ + "." + path + ".scaling.";
    const std::string_view style = header_->text(start + "style");
    const std::optional<double> multiplier = header_->number(start + "multiplier");
    const std::optional<double> offset = header_->number(start + "offset");
    if (style != "offsetmultiplier" || !multiplier || !offset) {
        fail("expected a linear scaling with offset and multiplier at '" + path + "'");
    }
    return {*multiplier, *offset};
}

JpkScaling JpkChannel::encoder() const {
    for (const char* const path : {"data.encoder", "encoder"}) {
        if (!find(std::string(path) + ".type").empty()) {
            return linear(path);
        }
    }
    return {};
}

std::string_view JpkChannel::parentOf(std::string_view slot) const {
    return slotText(slot, "base-calibration-slot");
}

std::optional<JpkScaling> JpkChannel::ownScaling(std::string_view slot) const {
    if (slotText(slot, "defined") != "true") {
        return std::nullopt;
    }
    return linear("conversion-set.conversion." + std::string(slot));
}

std::optional<JpkScaling> JpkChannel::scalingTo(std::string_view slot) const {
    constexpr int kMaxSlots = 32;
    const std::string_view base = baseSlot();
    JpkScaling chain;
    for (int steps = 0; slot != base; ++steps) {
        if (steps == kMaxSlots) {
            fail("its conversions form a circle at the slot '" + std::string(slot) + "'");
        }
        const std::optional<JpkScaling> own = ownScaling(slot);
        if (!own) {
            return std::nullopt;
        }
        chain = chain.after(*own);
        slot = parentOf(slot);
    }
    return chain.after(encoder());
}

std::string JpkChannel::shownSlot() const {
    const auto isThere = [this](std::string_view slot) {
        return slot == baseSlot() || slotText(slot, "defined") == "true";
    };
    if (const std::string_view shown = find("conversion-set.conversions.default");
        !shown.empty() && isThere(shown)) {
        return std::string(shown);
    }
    std::string_view list = find("conversion-set.conversions.list");
    std::string last(baseSlot());
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (end > 0 && isThere(list.substr(0, end))) {
            last = list.substr(0, end);
        }
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return last;
}

std::string_view JpkChannel::unitOf(std::string_view slot) const {
    if (slot != baseSlot()) {
        return slotText(slot, "scaling.unit.unit");
    }
    for (const char* const key :
         {"data.encoder.scaling.unit.unit", "encoder.scaling.unit.unit", "unit.unit"}) {
        if (const std::string_view unit = find(key); !unit.empty()) {
            return unit;
        }
    }
    return {};
}

void JpkChannel::fail(const std::string& what) const {
    throw InputError(file_, "channel " + name_, what);
}

}  // namespace asperity
