#pragma once

#include "core/Error.h"
#include "core/io/heightmap/HeightMapFormat.h"
#include "core/io/heightmap/SampleRows.h"

#include <optional>
#include <string>
#include <vector>

namespace asperity {

/// Tells the images that a file holds whole from those that it lost with its end: the first are
/// read, and a note names the others.
class WholeImages {
public:
    /// Returns whether the file holds all samples of an image.
    /// @param owner as that of requireSamples()
    /// @param name of its channel
    [[nodiscard]] bool holds(const ByteSource& bytes, const SampleLayout& layout,
                             const std::string& owner, const std::string& name);
    /// Leaves an image out. @param why the refusal of a file that holds no other one
    void leaveOut(const std::string& name, const InputError& why);
    [[nodiscard]] bool areAll() const { return !refusal_; }
    /// Adds the note on those that were left out. @throw InputError when the scan has no channel
    /// because all were left out: that of the first one
    void finish(StoredScan& scan) const;
    /// Throws the refusal of the first image that was left out, if there is one.
    void requireAll() const;

private:
    std::vector<std::string> missing_;  ///< names
    std::optional<InputError> refusal_;
};

}  // namespace asperity
