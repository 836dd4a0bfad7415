#include "app/commands/InfoCommand.h"

#include "app/program/JsonText.h"
#include "core/PathText.h"
#include "core/PrintableText.h"
#include "core/SiFormat.h"
#include "core/io/heightmap/DefaultChannel.h"
#include "core/io/heightmap/HeightStatistics.h"
#include "core/io/heightmap/PhysicalUnit.h"
#include "core/io/heightmap/ScanFile.h"
#include "core/words/ImagingTipWords.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <sstream>
#include <utility>

namespace asperity {

namespace {

struct InfoOptions {
    std::string file;
    bool json = false;
};

bool isDefault(const HeightMapFile& file, const ScanChannel& channel) {
    return &channel == &file.channels.at(file.defaultChannel) && isTopography(channel);
}

/// What is told of a channel's pixels.
struct PixelFacts {
    HeightStatistics statistics;
    /// The corner pixels: they tell which way up the image lies. NaN: no data.
    double topLeft = 0.0;
    double topRight = 0.0;
    double bottomLeft = 0.0;
    double bottomRight = 0.0;
};

PixelFacts pixelFacts(const ScanFile& file, const ScanChannel& channel) {
    PixelFacts facts;
    const int bottom = channel.map.rows - 1;
    facts.statistics = heightStatistics([&](const TakeRow& take) {
        file.forEachRow(channel, [&](int row, std::span<const double> values) {
            if (row == 0) {
                facts.topLeft = values.front();
                facts.topRight = values.back();
            }
            if (row == bottom) {
                facts.bottomLeft = values.front();
                facts.bottomRight = values.back();
            }
            take(values);
        });
    });
    return facts;
}

/// NaN, of a channel without a valid pixel, becomes null.
nlohmann::json channelJson(const ScanFile& file, const ScanChannel& channel) {
    const PixelFacts facts = pixelFacts(file, channel);
    const HeightStatistics& statistics = facts.statistics;
    return {{"name", channel.name},
            {"unit", channel.unit},
            {"direction", channel.direction},
            {"is_height", channel.isHeight()},
            {"is_default", isDefault(file.contents(), channel)},
            {"columns", channel.map.columns},
            {"rows", channel.map.rows},
            {"size_known", channel.hasSize()},
            {"lateral_unit", channel.lateralUnit},
            {"size_x_m", channel.map.sizeX()},
            {"size_y_m", channel.map.sizeY()},
            {"pitch_x_m", channel.map.pitchX},
            {"pitch_y_m", channel.map.pitchY},
            {"origin_x_m", channel.originX},
            {"origin_y_m", channel.originY},
            {"min", statistics.lowest},
            {"max", statistics.highest},
            {"mean", statistics.mean},
            {"rms", statistics.rms},
            {"invalid_pixels", statistics.invalidPixels},
            {"corners",
             {{"top_left", facts.topLeft},
              {"top_right", facts.topRight},
              {"bottom_left", facts.bottomLeft},
              {"bottom_right", facts.bottomRight}}},
            {"metadata", channel.metadata}};
}

/// Of the reader, and what holds for every scan.
std::vector<std::string> notesOf(const HeightMapFile& file) {
    std::vector<std::string> notes = file.notes;
    if (isTopography(file.channels.at(file.defaultChannel))) {
        notes.emplace_back(kScanHoldsItsTip);
    }
    return notes;
}

void printJson(const ScanFile& scan, const std::string& path) {
    const HeightMapFile& file = scan.contents();
    nlohmann::json channels = nlohmann::json::array();
    for (const ScanChannel& channel : file.channels) {
        channels.push_back(channelJson(scan, channel));
    }
    const ScanChannel& first = file.channels.at(file.defaultChannel);
    const nlohmann::json defaultName =
        isTopography(first) ? nlohmann::json(first.name) : nlohmann::json();
    const nlohmann::json report = {{"file", pathText(path)},  {"format", file.format},
                                   {"sha256", scan.sha256()}, {"default_channel", defaultName},
                                   {"channels", channels},    {"notes", notesOf(file)}};
    std::cout << jsonText(report) << '\n';
}

using Row = std::vector<std::string>;

/// Characters on the screen: continuation bytes of UTF-8 take no room.
std::size_t shownWidth(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

/// Columns as wide as their widest cell, numbers to the right: all but the first two.
void printTable(std::vector<Row> rows) {
    for (Row& row : rows) {
        std::ranges::transform(row, row.begin(), printable);
    }
    std::vector<std::size_t> widths(rows.front().size(), 0);
    for (const Row& row : rows) {
        for (std::size_t i = 0; i < row.size(); ++i) {
            widths[i] = std::max(widths[i], shownWidth(row[i]));
        }
    }
    for (const Row& row : rows) {
        std::string line;
        for (std::size_t i = 0; i < row.size(); ++i) {
            const std::string padding(widths[i] - shownWidth(row[i]), ' ');
            line += (i == 0 ? "" : "  ") + (i < 2 ? row[i] + padding : padding + row[i]);
        }
        std::cout << line << '\n';
    }
}

/// Without a unit a prefix would be read as one.
std::string quantity(double value, const std::string& unit) {
    const PhysicalUnit known = parseUnit(unit);  // "mV" must not become "mmV"
    if (!known.base.empty()) {
        return formatSi(value * known.factor, known.base.c_str());
    }
    std::ostringstream text;
    text << std::setprecision(3) << value;
    return text.str();
}

std::string sizeText(const ScanChannel& channel) {
    if (!(channel.map.pitchX > 0.0)) {
        return "size unknown";
    }
    return quantity(channel.map.sizeX(), channel.lateralUnit) + " x " +
           quantity(channel.map.sizeY(), channel.lateralUnit);
}

Row channelRow(const ScanFile& file, const ScanChannel& channel) {
    const HeightStatistics statistics = pixelFacts(file, channel).statistics;
    const auto value = [&channel](double number) {
        return std::isnan(number) ? std::string("-") : quantity(number, channel.unit);
    };
    return {(isDefault(file.contents(), channel) ? "* " : "  ") + channel.name,
            channel.direction,
            std::to_string(channel.map.columns) + " x " + std::to_string(channel.map.rows),
            sizeText(channel),
            value(statistics.lowest),
            value(statistics.highest),
            value(statistics.mean),
            value(statistics.rms),
            std::to_string(statistics.invalidPixels)};
}

void printForPeople(const ScanFile& scan, const std::string& path) {
    const HeightMapFile& file = scan.contents();
    std::cout << printable(path) << "\n" << file.format << "\n\n";
    std::vector<Row> rows = {
        {"  channel", "direction", "pixels", "size", "min", "max", "mean", "rms", "invalid"}};
    for (const ScanChannel& channel : file.channels) {
        rows.push_back(channelRow(scan, channel));
    }
    printTable(std::move(rows));
    const bool hasHeight = isTopography(file.channels.at(file.defaultChannel));
    std::cout << (hasHeight ? "\n* taken when no channel is named; rms is about the mean\n"
                            : "\nNo channel is a height map; rms is about the mean\n");
    for (const std::string& note : notesOf(file)) {
        std::cout << "- " << printable(note) << '\n';
    }
}

}  // namespace

void addInfoCommand(CLI::App& program) {
    auto options = std::make_shared<InfoOptions>();
    CLI::App* command = program.add_subcommand(
        "info", "Say what a height-map file holds: channels, sizes, heights");
    command->add_option("FILE", options->file, "height-map file")->required();
    command->add_flag("--json", options->json, "print JSON with SI values in full precision");
    command->callback([options] {
        const ScanFile file(options->file);
        if (options->json) {
            printJson(file, options->file);
        } else {
            printForPeople(file, options->file);
        }
    });
}

}  // namespace asperity
