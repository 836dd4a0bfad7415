#pragma once

#include "core/io/scene/TomlFile.h"
#include "core/surface/PixelRectangle.h"

#include <optional>

namespace asperity {

/// The key crop_px of [sample]: [column, row, columns, rows]. Whether the scan has those pixels is
/// known when it is read. @throw InputError
[[nodiscard]] std::optional<PixelRectangle> readCrop(TomlSection& section);
void insertCrop(const std::optional<PixelRectangle>& crop, toml::table& sample);

}  // namespace asperity
