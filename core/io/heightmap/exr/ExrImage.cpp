#include "core/io/heightmap/exr/ExrImage.h"

#include "core/Error.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <stdexcept>

namespace asperity {

namespace {

/// The file as the OpenEXR library reads it. Its exceptions pass through the library.
class ExrStream final : public Imf::IStream {
public:
    explicit ExrStream(const ByteSource& bytes)
        : Imf::IStream(bytes.name().c_str()), bytes_(bytes) {}

    bool read(char target[], int count) override {
        const auto length = static_cast<std::size_t>(count);
        if (place_ > bytes_.size() || length > bytes_.size() - place_) {
            throw InputError(bytes_.name(), "byte " + std::to_string(bytes_.size()),
                             "the content ends here; it is truncated or damaged");
        }
        bytes_.read(place_, {target, length});
        place_ += length;
        return place_ < bytes_.size();
    }
    std::uint64_t tellg() override { return place_; }
    void seekg(std::uint64_t place) override { place_ = place; }
    void clear() override {}

private:
    const ByteSource& bytes_;
    std::uint64_t place_ = 0;
};

constexpr int kNoThreads = 0;

/// Runs `step` on the open file. @throw InputError for whatever the library throws
template <typename Step>
auto withExr(const ByteSource& bytes, const Step& step) {
    try {
        ExrStream stream(bytes);
        Imf::InputFile file(stream, kNoThreads);
        return step(file);
    } catch (const InputError&) {
        throw;
    } catch (const std::exception& error) {
        throw InputError(bytes.name(), "",
                         std::string("the OpenEXR library cannot decode it: ") + error.what());
    }
}

std::vector<ExrChannel> listChannels(const Imf::InputFile& file) {
    std::vector<ExrChannel> channels;
    const Imf::ChannelList& list = file.header().channels();
    for (auto each = list.begin(); each != list.end(); ++each) {
        const Imf::Channel& channel = each.channel();
        channels.push_back(
            {.name = each.name(),
             .type = channel.type == Imf::UINT ? SampleType::UInt32 : SampleType::Float32,
             .isHalf = channel.type == Imf::HALF,
             .isWhole = channel.xSampling == 1 && channel.ySampling == 1});
    }
    return channels;
}

std::string decode(Imf::InputFile& file, const std::vector<ExrChannel>& channels) {
    const Imath::Box2i window = file.header().dataWindow();
    const auto columns = static_cast<std::size_t>(std::int64_t{window.max.x} - window.min.x + 1);
    const auto rows = static_cast<std::size_t>(std::int64_t{window.max.y} - window.min.y + 1);
    std::size_t bytes = 0;
    for (const ExrChannel& channel : channels) {
        bytes += columns * rows * sizeOf(channel.type);
    }
    std::string samples(bytes, '\0');
    char* target = samples.data();
    Imf::FrameBuffer frame;
    for (const ExrChannel& channel : channels) {
        frame.insert(channel.name,
                     Imf::Slice::Make(channel.type == SampleType::UInt32 ? Imf::UINT : Imf::FLOAT,
                                      target, window));
        target += columns * rows * sizeOf(channel.type);
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    return samples;
}

}  // namespace

std::vector<ExrChannel> exrChannels(const ByteSource& bytes) {
    return withExr(bytes, listChannels);
}

std::string decodeExr(const ByteSource& bytes, const std::vector<ExrChannel>& channels) {
    return withExr(bytes, [&channels](Imf::InputFile& file) { return decode(file, channels); });
}

}  // namespace asperity
