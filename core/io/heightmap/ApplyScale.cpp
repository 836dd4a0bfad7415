#include "core/io/heightmap/ApplyScale.h"

#include "core/Error.h"
#include "core/SiFormat.h"
#include "core/io/TextValue.h"
#include "core/io/heightmap/ScanImage.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace asperity {

namespace {

constexpr const char* kGiven = "given by the user";

std::string sizeText(double x, double y) { return formatSi(x, "m") + " x " + formatSi(y, "m"); }

void applySize(ScanChannel& channel, const GivenScale& given) {
    HeightMap& map = channel.map;
    std::string note = "size " + sizeText(given.sizeX, given.sizeY) + " as given";
    if (channel.hasSize()) {
        note +=
            "; that of the file is " + sizeText(map.pitchX * map.columns, map.pitchY * map.rows);
    }
    std::erase(channel.notes, kNoSizeNote);
    map.pitchX = pixelPitch(given.sizeX, map.columns);
    map.pitchY = pixelPitch(given.sizeY, map.rows);
    channel.lateralUnit = "m";
    channel.notes.push_back(note);
    if (std::abs(map.pitchX - map.pitchY) > 1e-3 * map.pitchX) {
        channel.notes.push_back("its pixels are not square: " + sizeText(map.pitchX, map.pitchY));
    }
    std::erase_if(channel.provenance,
                  [](const Provenance& entry) { return entry.what == "lateral size"; });
    channel.provenance.push_back(
        {"lateral size", exactText(given.sizeX) + " x " + exactText(given.sizeY) + " m", kGiven});
}

void applyHeight(StoredChannel& stored, const GivenScale& given) {
    ScanChannel& channel = stored.channel;
    const std::string factor = exactText(given.heightPerValue);
    channel.notes.push_back("numbers taken as heights of " + factor + " m each as given");
    channel.provenance.push_back(scaleProvenance(given.heightPerValue, "m", kGiven));
    channel.unit = "m";
    stored.factor *= given.heightPerValue;
}

}  // namespace

void applyScale(StoredScan& scan, const GivenScale& given, const std::string& file) {
    const bool hasNumbers = std::ranges::any_of(
        scan.channels, [](const StoredChannel& each) { return each.channel.unit.empty(); });
    if (given.hasHeight() && !hasNumbers) {
        throw InputError(file, "",
                         "its values have units; --z-unit, --z-scale and z_scale_m are for values "
                         "without one");
    }
    for (StoredChannel& stored : scan.channels) {
        if (given.hasSize()) {
            applySize(stored.channel, given);
        }
        if (given.hasHeight() && stored.channel.unit.empty()) {
            applyHeight(stored, given);
        }
    }
}

}  // namespace asperity
