#pragma once

#include "core/io/curves/jpk/JpkProperties.h"
#include "core/io/heightmap/SampleRows.h"

#include <optional>
#include <string>
#include <string_view>

namespace asperity {

/// A linear scaling: value = multiplier * x + offset.
struct JpkScaling {
    double multiplier = 1.0;
    double offset = 0.0;

    /// This one, applied after another one.
    [[nodiscard]] JpkScaling after(const JpkScaling& first) const {
        return {multiplier * first.multiplier, multiplier * first.offset + offset};
    }
    [[nodiscard]] double operator()(double x) const { return multiplier * x + offset; }
};

/// A channel of a JPK segment: where its samples lie, and their conversions. Source:
/// docs/formats.md 21.
class JpkChannel {
public:
    /// @param header of the segment; must outlive this
    /// @param file for messages: the archive, and the segment in it
    JpkChannel(const JpkProperties& header, std::string name, std::string file);

    [[nodiscard]] const std::string& name() const { return name_; }
    /// Name of the member with the samples, below the segment's folder.
    [[nodiscard]] std::string_view dataFile() const;
    /// Type of its samples, which are stored with their highest byte first.
    /// @throw InputError where it is unknown
    [[nodiscard]] SampleType sampleType() const;

    /// Name of the slot that the samples are in without any conversion: "volts", "absolute".
    [[nodiscard]] std::string_view baseSlot() const {
        return find("conversion-set.conversions.base");
    }
    /// The slot that JPK's program shows, where it is defined, else the last one that is.
    [[nodiscard]] std::string shownSlot() const;
    /// Scaling from stored samples to a slot; empty: the file does not define it.
    /// @throw InputError when its conversions form a circle, or lack a number
    [[nodiscard]] std::optional<JpkScaling> scalingTo(std::string_view slot) const;
    /// The slot's own scaling, from its parent; empty: the file does not define it.
    [[nodiscard]] std::optional<JpkScaling> ownScaling(std::string_view slot) const;
    [[nodiscard]] std::string_view parentOf(std::string_view slot) const;
    /// The unit of a slot as it is written; empty: the file does not say it.
    [[nodiscard]] std::string_view unitOf(std::string_view slot) const;

private:
    [[nodiscard]] std::string_view find(std::string_view tail) const;
    [[nodiscard]] std::string_view slotText(std::string_view slot, std::string_view tail) const;
    [[nodiscard]] JpkScaling encoder() const;
    [[nodiscard]] JpkScaling linear(const std::string& path) const;
    [[nodiscard]] std::string_view typeName() const;
    [[noreturn]] void fail(const std::string& what) const;

    const JpkProperties* header_;
    std::string name_;
    std::string file_;
};

}  // namespace asperity
