#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/TextValue.h"
#include "core/io/curves/ThermalSpectrumFile.h"
#include "core/io/curves/nanosurf/NanosurfLines.h"
#include "core/io/heightmap/PhysicalUnit.h"

#include <algorithm>
#include <cmath>

// Thermal spectra of Nanosurf .nid files, with the fit of their program. Source:
// docs/formats.md 21.

namespace asperity {

namespace {

constexpr std::string_view kSpectrumFrame = "Spectrum FFT";
constexpr std::string_view kSpectrumFit = "Spectrum Fit";

/// "179.8kHz", "27.13 N/m", "442": in SI; 0: the file does not say it.
double factIn(const HeaderFields& info, const std::string& key) {
    const std::string text = info.text(key);
    const std::optional<LeadingNumber> number = parseLeadingNumber(text);
    if (!number || !std::isfinite(number->value)) {
        return 0.0;
    }
    const bool isPlainThousand = number->rest == "k";  // a quality factor of "1.2k"
    return number->value * (isPlainThousand ? 1e3 : parseUnit(number->rest).factor);
}

void takeFit(ThermalSpectrum& spectrum, const HeaderSections& sections) {
    const auto found = sections.find("DataSet-Info");
    if (found == sections.end()) {
        return;
    }
    const HeaderFields& info = found->second;
    spectrum.resonance = factIn(info, "Frequency:");
    spectrum.quality = factIn(info, "Q Factor:");
    spectrum.stiffness = factIn(info, "Spring Constant:");
    spectrum.peakDensity = factIn(info, "Peak Value:");
    spectrum.lowest = factIn(info, "Peak fit min");
    spectrum.highest = factIn(info, "Peak fit max");
    spectrum.averages = factIn(info, "Averages");
    spectrum.temperature = factIn(info, "Cantilever temperature");
}

/// Null: there is no such channel.
const NanosurfLines* channelOf(const std::vector<NanosurfLines>& channels, std::string_view frame) {
    const auto found = std::ranges::find(channels, frame, &NanosurfLines::frame);
    return found == channels.end() || found->lines == 0 ? nullptr : &*found;
}

/// The square of the stored amplitude density.
std::vector<double> powerOf(const ByteSource& bytes, const NanosurfLines& channel) {
    if (!lowerCase(channel.section->text("Dim2Unit")).ends_with("m/sqrt(hz)")) {
        channel.section->fail("Dim2Unit", "expected m/sqrt(Hz), found '" +
                                              channel.section->text("Dim2Unit") + "'");
    }
    std::vector<double> power = nanosurfLine(bytes, channel, 0);
    std::ranges::transform(power, power.begin(), [](double value) { return value * value; });
    return power;
}

}  // namespace

bool holdsThermalSpectrum(const ByteSource& bytes) {
    constexpr std::uint64_t kLooked = std::uint64_t{1} << 16U;
    return bytes.startsWith(kNanosurfMagic) &&
           bytes.start(kLooked).find("Frame=" + std::string(kSpectrumFrame)) != std::string::npos;
}

ThermalSpectrum readThermalSpectrum(const ByteSource& bytes) {
    if (!bytes.startsWith(kNanosurfMagic)) {
        throw InputError(bytes.name(), "",
                         "expected a thermal spectrum of Nanosurf (.nid), which begins with "
                         "[DataSet]");
    }
    const NanosurfHeader header = readNanosurfHeader(bytes);
    const std::vector<NanosurfLines> channels = nanosurfLines(header, bytes);
    const NanosurfLines* const measured = channelOf(channels, kSpectrumFrame);
    if (measured == nullptr) {
        throw InputError(bytes.name(), "[DataSet]", "it lists no thermal spectrum (Spectrum FFT)");
    }
    ThermalSpectrum spectrum;
    spectrum.power = powerOf(bytes, *measured);
    spectrum.frequency = nanosurfAxis(*measured, spectrum.power.size());
    if (const NanosurfLines* const fit = channelOf(channels, kSpectrumFit)) {
        spectrum.fittedPower = powerOf(bytes, *fit);
        if (spectrum.fittedPower.size() != spectrum.power.size()) {
            spectrum.fittedPower.clear();
        }
    }
    takeFit(spectrum, header.sections);
    return spectrum;
}

ThermalSpectrum readThermalSpectrum(const std::filesystem::path& path) {
    return readThermalSpectrum(BufferedFile(path));
}

}  // namespace asperity
