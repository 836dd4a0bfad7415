#include "core/io/zip/ZipWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <zip.h>

namespace asperity {

namespace {

/// The target of libzip, in place of a file whose temporary name it would choose itself.
class Output {
public:
    explicit Output(const std::filesystem::path& path)
        : file_(path), stream_(file_.path(), std::ios::binary) {}

    [[nodiscard]] std::string name() const { return file_.target().string(); }
    void commit() const { file_.commit(); }

    zip_int64_t answer(void* data, zip_uint64_t length, zip_source_cmd_t command) {
        switch (command) {
        case ZIP_SOURCE_WRITE:
            return write(static_cast<const char*>(data), length);
        case ZIP_SOURCE_SEEK_WRITE:
            return seek(data, length);
        case ZIP_SOURCE_TELL_WRITE:
            return offset_;
        case ZIP_SOURCE_COMMIT_WRITE:
            stream_.close();
            return requireGood();
        case ZIP_SOURCE_STAT:
            zip_stat_init(static_cast<zip_stat_t*>(data));
            return sizeof(zip_stat_t);
        case ZIP_SOURCE_ERROR:
            return zip_error_to_data(&error_, data, length);
        case ZIP_SOURCE_SUPPORTS:
            return ZIP_SOURCE_SUPPORTS_WRITABLE;
        case ZIP_SOURCE_OPEN:
        case ZIP_SOURCE_CLOSE:
        case ZIP_SOURCE_BEGIN_WRITE:
        case ZIP_SOURCE_ROLLBACK_WRITE:
        case ZIP_SOURCE_REMOVE:
        case ZIP_SOURCE_FREE:
            return 0;
        default:
            zip_error_set(&error_, ZIP_ER_OPNOTSUPP, 0);
            return -1;
        }
    }

private:
    zip_int64_t requireGood() {
        if (stream_) {
            return 0;
        }
        zip_error_set(&error_, ZIP_ER_WRITE, errno);
        return -1;
    }

    zip_int64_t write(const char* bytes, zip_uint64_t count) {
        stream_.write(bytes, static_cast<std::streamsize>(count));
        offset_ += static_cast<zip_int64_t>(count);
        size_ = std::max(size_, offset_);
        return requireGood() == 0 ? static_cast<zip_int64_t>(count) : -1;
    }

    zip_int64_t seek(void* data, zip_uint64_t length) {
        const zip_int64_t to =
            zip_source_seek_compute_offset(static_cast<zip_uint64_t>(offset_),
                                           static_cast<zip_uint64_t>(size_), data, length, &error_);
        if (to < 0) {
            return -1;
        }
        offset_ = to;
        stream_.seekp(offset_);
        return requireGood();
    }

    TemporaryFile file_;
    std::ofstream stream_;
    zip_int64_t offset_ = 0;
    zip_int64_t size_ = 0;
    zip_error_t error_{};
};

zip_int64_t answerForOutput(void* output, void* data, zip_uint64_t length,
                            zip_source_cmd_t command) {
    return static_cast<Output*>(output)->answer(data, length, command);
}

}  // namespace

class ZipWriter::Archive {
public:
    explicit Archive(const std::filesystem::path& path) : output_(path) {
        zip_error_t error;
        zip_error_init(&error);
        zip_source_t* const source = zip_source_function_create(answerForOutput, &output_, &error);
        archive_ = source == nullptr
                       ? nullptr
                       : zip_open_from_source(source, ZIP_CREATE | ZIP_TRUNCATE, &error);
        const std::string reason = archive_ == nullptr ? zip_error_strerror(&error) : "";
        zip_error_fini(&error);
        if (archive_ == nullptr) {
            zip_source_free(source);
            throw FileError(output_.name(), "cannot be written: " + reason);
        }
    }
    ~Archive() {
        if (archive_ != nullptr) {
            zip_discard(archive_);
        }
    }
    Archive(const Archive&) = delete;
    Archive& operator=(const Archive&) = delete;

    void add(const std::string& name, const std::filesystem::path& file) {
        zip_source_t* const source = zip_source_file(archive_, file.c_str(), 0, -1);
        if (source == nullptr) {
            fail();
        }
        if (zip_file_add(archive_, name.c_str(), source, ZIP_FL_ENC_UTF_8) < 0) {
            zip_source_free(source);
            fail();
        }
    }

    void close(Progress* progress) {
        progress_ = progress;
        zip_register_progress_callback_with_state(
            archive_, kProgressSteps,
            [](zip_t* /*archive*/, double fraction, void* self) {
                static_cast<Archive*>(self)->report(fraction);
            },
            nullptr, this);
        zip_register_cancel_callback_with_state(
            archive_,
            [](zip_t* /*archive*/, void* self) -> int {
                const Progress* const observer = static_cast<Archive*>(self)->progress_;
                return observer != nullptr && observer->isCanceled() ? 1 : 0;
            },
            nullptr, this);
        if (zip_close(archive_) != 0) {
            if (progress != nullptr && progress->isCanceled()) {
                throw Canceled();
            }
            fail();
        }
        archive_ = nullptr;
        output_.commit();
    }

private:
    static constexpr double kProgressSteps = 0.02;

    // No exception may pass through libzip: it asks for the end by the other callback.
    void report(double fraction) const {
        if (progress_ != nullptr && !progress_->isCanceled()) {
            progress_->report(fraction);
        }
    }

    [[noreturn]] void fail() const {
        throw Error(output_.name() + ": cannot be written: " + zip_strerror(archive_));
    }

    Output output_;
    zip_t* archive_ = nullptr;
    Progress* progress_ = nullptr;
};

ZipWriter::ZipWriter(const std::filesystem::path& path)
    : archive_(std::make_unique<Archive>(path)) {}

ZipWriter::~ZipWriter() = default;

void ZipWriter::addFile(const std::string& name, const std::filesystem::path& file) {
    archive_->add(name, file);
}

void ZipWriter::close(Progress* progress) { archive_->close(progress); }

}  // namespace asperity
