#pragma once

#include "core/io/ByteReader.h"
#include "core/io/curves/StoredCurves.h"

#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace asperity {

/// An open file of force-distance curves: one, or the thousands of a map, read one by one. Any
/// threads. Whatever the sign in the file, the base grows towards the sample.
/// Source: docs/formats.md 21.
class ForceCurveFile {
public:
    /// Opens a file by its content. Columns that the user names are those of a text table.
    /// @throw InputError when it holds no curve that can be read, with what it is; when anything is
    ///        missing or does not fit together
    explicit ForceCurveFile(const std::filesystem::path& path,
                            const CurveReadOptions& options = {});
    /// The same of a content that is in memory already. @param bytes must outlive this
    explicit ForceCurveFile(const ByteSource& bytes, const CurveReadOptions& options = {});

    [[nodiscard]] std::size_t count() const { return curves_->count(); }
    /// @throw InputError where there is no curve of this index, or it is damaged
    [[nodiscard]] CurveContents contents(std::size_t index) const;
    [[nodiscard]] MeasuredForceCurve curve(std::size_t index) const {
        return contents(index).curve;
    }
    /// The file type, for people.
    [[nodiscard]] std::string_view format() const { return format_; }
    /// Notes on the file as a whole.
    [[nodiscard]] const std::vector<std::string>& notes() const { return curves_->notes(); }
    /// Position of a curve; empty: the file does not say it.
    [[nodiscard]] std::optional<CurvePosition> position(std::size_t index) const;
    [[nodiscard]] CurveGrid grid() const { return curves_->grid(); }
    /// Place of a curve in the grid; empty: it lies on none.
    [[nodiscard]] std::optional<CurveCell> cell(std::size_t index) const;
    /// Returns whether the file holds an image, too, which is opened as a scan.
    [[nodiscard]] bool hasImage() const { return curves_->hasImage(); }

private:
    void open(const ByteSource& bytes, const CurveReadOptions& options);
    void requireIndex(std::size_t index) const;

    std::unique_ptr<const ByteSource> file_;
    std::string name_;
    std::string_view format_;
    std::unique_ptr<const StoredCurves> curves_;
};

/// Returns whether a content is of a type of force curves that is read here.
[[nodiscard]] bool holdsForceCurves(const ByteSource& bytes);

/// Reads one curve of a file. @throw InputError as ForceCurveFile
[[nodiscard]] MeasuredForceCurve readForceCurve(const std::filesystem::path& path,
                                                std::size_t index = 0,
                                                const CurveReadOptions& options = {});

}  // namespace asperity
