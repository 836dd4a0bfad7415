#include "core/io/curves/ForceCurveFile.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/curves/CurveFormat.h"
#include "core/io/curves/ThermalSpectrumFile.h"
#include "core/io/heightmap/ForceCurveFiles.h"

#include <algorithm>

namespace asperity {

namespace {

/// Null: none is.
const CurveFormat* curveFormatOf(const ByteSource& bytes) {
    const auto* const found = std::ranges::find_if(
        kCurveFormats, [&](const CurveFormat* format) { return format->recognizes(bytes); });
    return found == kCurveFormats.end() ? nullptr : *found;
}

[[noreturn]] void refuse(const ByteSource& bytes) {
    if (const std::string program = forceCurveProgram(bytes); !program.empty()) {
        throw InputError(bytes.name(), "",
                         "this file holds force curves (" + program +
                             "), which are not read; export them as a text table of named columns");
    }
    if (holdsThermalSpectrum(bytes)) {
        throw InputError(bytes.name(), "", "this file holds a thermal spectrum, no force curve");
    }
    const std::string start = bytes.start(1U << 16U);
    if (start.find('\0') != std::string::npos) {
        throw InputError(bytes.name(), "",
                         "holds binary data of no known format of force curves; export the curve "
                         "as a text table, with base or separation and force, from the program "
                         "that made it");
    }
    throw InputError(bytes.name(), "",
                     "no line names a distance and a force, a deflection or a signal with their "
                     "units, such as \"Z (nm), Force (nN)\" or \"base_m,force_N\"; name the "
                     "columns of the table, such as base=1:um,force=2:nN");
}

}  // namespace

ForceCurveFile::ForceCurveFile(const std::filesystem::path& path, const CurveReadOptions& options)
    : file_(std::make_unique<BufferedFile>(path)) {
    open(*file_, options);
}

ForceCurveFile::ForceCurveFile(const ByteSource& bytes, const CurveReadOptions& options) {
    open(bytes, options);
}

void ForceCurveFile::open(const ByteSource& bytes, const CurveReadOptions& options) {
    name_ = bytes.name();
    const bool isNamedTable = !options.columns.empty() || options.skippedLines > 0;
    const CurveFormat* const format = isNamedTable ? &kTextCurveFormat : curveFormatOf(bytes);
    if (format == nullptr) {
        refuse(bytes);
    }
    format_ = format->name;
    curves_ = format->open(bytes, options);
}

void ForceCurveFile::requireIndex(std::size_t index) const {
    if (index >= count()) {
        throw InputError(name_, "",
                         "there is no curve " + std::to_string(index) + ": the file holds " +
                             (count() == 1 ? std::string("one, of the index 0")
                                           : std::to_string(count()) + ", of the indexes 0 to " +
                                                 std::to_string(count() - 1)));
    }
}

CurveContents ForceCurveFile::contents(std::size_t index) const {
    requireIndex(index);
    return curves_->read(index);
}

std::optional<CurvePosition> ForceCurveFile::position(std::size_t index) const {
    requireIndex(index);
    return curves_->position(index);
}

std::optional<CurveCell> ForceCurveFile::cell(std::size_t index) const {
    requireIndex(index);
    return curves_->cell(index);
}

bool holdsForceCurves(const ByteSource& bytes) { return curveFormatOf(bytes) != nullptr; }

MeasuredForceCurve readForceCurve(const std::filesystem::path& path, std::size_t index,
                                  const CurveReadOptions& options) {
    return ForceCurveFile(path, options).curve(index);
}

}  // namespace asperity
