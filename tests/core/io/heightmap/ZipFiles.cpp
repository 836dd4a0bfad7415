#include "tests/core/io/heightmap/ZipFiles.h"

#include <stdexcept>
#include <zip.h>

namespace asperity::test {

namespace {

void require(bool succeeded) {
    if (!succeeded) {
        throw std::runtime_error("libzip cannot make the archive");
    }
}

std::string contentOfSource(zip_source_t* source) {
    require(zip_source_open(source) == 0);
    zip_stat_t status;
    zip_stat_init(&status);
    require(zip_source_stat(source, &status) == 0);
    std::string bytes(status.size, '\0');
    require(zip_source_read(source, bytes.data(), bytes.size()) ==
            static_cast<zip_int64_t>(bytes.size()));
    zip_source_close(source);
    return bytes;
}

}  // namespace

std::string zipFile(const std::vector<ZippedFile>& files) {
    zip_source_t* const target = zip_source_buffer_create(nullptr, 0, 0, nullptr);
    zip_t* const archive = zip_open_from_source(target, ZIP_TRUNCATE, nullptr);
    require(archive != nullptr);
    zip_source_keep(target);
    for (const ZippedFile& file : files) {
        zip_source_t* const content =
            zip_source_buffer(archive, file.content.data(), file.content.size(), 0);
        const zip_int64_t index =
            zip_file_add(archive, file.name.c_str(), content, ZIP_FL_ENC_UTF_8);
        require(index >= 0);
        require(zip_set_file_compression(archive, static_cast<zip_uint64_t>(index),
                                         file.compressed ? ZIP_CM_DEFLATE : ZIP_CM_STORE, 0) == 0);
    }
    require(zip_close(archive) == 0);
    std::string bytes = contentOfSource(target);
    zip_source_free(target);
    return bytes;
}

}  // namespace asperity::test
