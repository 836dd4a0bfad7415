#include "core/io/zip/ZipWriter.h"

#include "core/Error.h"
#include "core/TemporaryFile.h"

#include <utility>
#include <zip.h>

namespace asperity {

/// libzip writes beside the archive and renames.
class ZipWriter::Archive {
public:
    explicit Archive(const std::filesystem::path& path) : name_(path.string()) {
        requireWritable(path);  // libzip would say it at the end
        // A link stays, and what it leads to is replaced.
        std::error_code unknown;
        const std::filesystem::path place =
            std::filesystem::is_symlink(path, unknown) ? std::filesystem::canonical(path) : path;
        int error = 0;
        archive_ = zip_open(place.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &error);
        if (archive_ == nullptr) {
            zip_error_t reason;
            zip_error_init_with_code(&reason, error);
            const std::string words = zip_error_strerror(&reason);
            zip_error_fini(&reason);
            throw FileError(name_, "cannot be written: " + words);
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
                const Progress* const told = static_cast<Archive*>(self)->progress_;
                return told != nullptr && told->isCanceled() ? 1 : 0;
            },
            nullptr, this);
        if (zip_close(archive_) != 0) {
            if (progress != nullptr && progress->isCanceled()) {
                throw Canceled();
            }
            fail();
        }
        archive_ = nullptr;
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
        throw Error(name_ + ": cannot be written: " + zip_strerror(archive_));
    }

    std::string name_;
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
