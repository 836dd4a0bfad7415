#include "core/io/hdf5/Hdf5Program.h"

#include "core/Error.h"
#include "core/io/FileBytes.h"
#include "core/io/hdf5/Hdf5Output.h"
#include "tests/support/Places.h"
#include "tests/support/Refusal.h"
#include "tests/support/Sanitized.h"
#include "tests/support/ScratchFolder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <numeric>

namespace asperity::test {
namespace {

using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using Kind = Hdf5Item::Kind;

std::string outputOf(const std::string& command) {
    // NOLINTNEXTLINE(cert-env33-c): that is the test
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"),
                                                               &pclose);
    std::array<char, 1000> text{};
    return {text.data(), std::fread(text.data(), 1, text.size(), pipe.get())};
}

/// A file as another program writes it.
class Hdf5Program : public testing::Test {
protected:
    Hdf5Program()
        : output_(H5Fcreate(file.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT), H5Fclose) {}

    void addNumbers(const char* name, hid_t type, const std::vector<hsize_t>& shape,
                    hid_t properties = H5P_DEFAULT) const {
        const Hdf5Object space(
            H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), H5Sclose);
        const Hdf5Object made(
            H5Dcreate2(output_.id(), name, type, space.id(), H5P_DEFAULT, properties, H5P_DEFAULT),
            H5Dclose);
        ASSERT_TRUE(made.isOpen());
        std::vector<double> numbers(
            static_cast<std::size_t>(H5Sget_simple_extent_npoints(space.id())));
        std::iota(numbers.begin(), numbers.end(), 0.0);
        ASSERT_GE(
            H5Dwrite(made.id(), H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT, numbers.data()),
            0);
    }
    void close() { output_ = Hdf5Object(-1, H5Fclose); }

    [[nodiscard]] Hdf5Content read(const std::vector<std::string>& paths = {}) const {
        return readHdf5(FileBytes(file), paths);
    }
    [[nodiscard]] std::string refusal(const std::vector<std::string>& paths = {}) const {
        return refusalOf([&] { (void)read(paths); });
    }

    ScratchFolder scratch;
    std::filesystem::path file = scratch.file("a.h5");
    Hdf5Object output_;
};

std::vector<double> numbersOf(const Hdf5Content& content, const char* path) {
    const Hdf5Item* const item = content.find(Kind::Dataset, path);
    if (item == nullptr || !item->offset) {
        return {};
    }
    std::vector<double> numbers(item->count);
    content.read(*item, 0, numbers);
    return numbers;
}

/// The reason that ends the writing is no guess.
TEST_F(Hdf5Program, SaysWhyItCannotHandOver) {
    addNumbers("n", H5T_IEEE_F64LE, {2, 3});
    close();
    const std::string call = hdf5Reader("").string() + " " + file.string() + " ";
    const std::string why = "what it holds cannot be written for a moment: ";
    EXPECT_EQ(outputOf(call + "/dev/full"), why + "No space left on device\n");
    EXPECT_EQ(outputOf("ulimit -n 4; " + call + scratch.file("content").string()),
              why + "Too many open files\n");
}

TEST_F(Hdf5Program, HandsOverNumbersOfAllTypes) {
    int count = 0;
    const std::vector<hid_t> types{H5T_IEEE_F32BE, H5T_IEEE_F64LE, H5T_STD_I8LE,  H5T_STD_U16BE,
                                   H5T_STD_I32BE,  H5T_STD_U32LE,  H5T_STD_I64LE, H5T_STD_U64BE};
    for (const hid_t type : types) {
        addNumbers(("n" + std::to_string(count++)).c_str(), type, {2, 3});
    }
    close();
    const Hdf5Content content = read();
    for (int i = 0; i < count; ++i) {
        EXPECT_THAT(numbersOf(content, ("/n" + std::to_string(i)).c_str()),
                    ElementsAre(0, 1, 2, 3, 4, 5))
            << i;
    }
}

TEST_F(Hdf5Program, HandsOverTextsAndAttributesOfAnyLength) {
    setWord(output_.id(), "default", "entry");
    setText(output_.id(), "fixed", "größe");
    close();
    const Hdf5Content content = read();
    EXPECT_EQ(content.text(Kind::Attribute, "/@default"), "entry");
    EXPECT_EQ(content.text(Kind::Attribute, "/@fixed"), "größe");
}

TEST_F(Hdf5Program, HandsOverLargeValuesWhereTheyAreWanted) {
    const Hdf5Object chunked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    const std::array<hsize_t, 2> chunk{7, 100};
    H5Pset_chunk(chunked.id(), 2, chunk.data());
    H5Pset_deflate(chunked.id(), 6);
    addNumbers("scan", H5T_IEEE_F32LE, {50, 300}, chunked.id());
    addNumbers("plain", H5T_IEEE_F64LE, {500, 1000});
    close();
    EXPECT_TRUE(numbersOf(read(), "/scan").empty());
    EXPECT_EQ(read().find(Kind::Dataset, "/scan")->count, 15'000U);
    const Hdf5Content content = read({"/scan", "/plain"});
    for (const auto& [path, count] : {std::pair{"/scan", 15'000U}, {"/plain", 500'000U}}) {
        const std::vector<double> numbers = numbersOf(content, path);
        ASSERT_EQ(numbers.size(), count);
        EXPECT_EQ(numbers.back(), count - 1.0);
        EXPECT_EQ(numbers[count / 2], count / 2.0);
    }
    EXPECT_EQ(read({"/plain"}).find(Kind::Dataset, "/scan"), nullptr);
}

/// A file from somebody else names no file of the reader's, nor has it a cycle.
TEST_F(Hdf5Program, FollowsNoLinkToAnotherFileOrBack) {
    (void)scratch.write("secret", std::string(64, 's'));
    const Hdf5Object external(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_external(external.id(), scratch.file("secret").c_str(), 0, 64);
    const hsize_t size = 64;
    const Hdf5Object space(H5Screate_simple(1, &size, nullptr), H5Sclose);
    H5Dclose(H5Dcreate2(output_.id(), "far", H5T_STD_I8LE, space.id(), H5P_DEFAULT, external.id(),
                        H5P_DEFAULT));
    H5Lcreate_external("other.h5", "/x", output_.id(), "link", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_soft("/nowhere", output_.id(), "lost", H5P_DEFAULT, H5P_DEFAULT);
    H5Lcreate_hard(output_.id(), "/", output_.id(), "circle", H5P_DEFAULT, H5P_DEFAULT);
    addNumbers("here", H5T_STD_I8LE, {2});
    H5Lcreate_soft("/here", output_.id(), "alias", H5P_DEFAULT, H5P_DEFAULT);
    close();
    const Hdf5Content content = read();
    ASSERT_NE(content.find(Kind::Dataset, "/far"), nullptr);
    EXPECT_FALSE(content.find(Kind::Dataset, "/far")->offset);
    EXPECT_EQ(content.find(Kind::Dataset, "/link"), nullptr);
    EXPECT_NE(content.find(Kind::Group, "/circle"), nullptr);
    EXPECT_EQ(content.find(Kind::Group, "/circle/circle"), nullptr);
    EXPECT_THAT(numbersOf(content, "/alias"), ElementsAre(0, 1));
}

TEST_F(Hdf5Program, SaysWhatIsWrongInOneSentence) {
    {
        const hsize_t huge = hsize_t{1} << 50U;
        const hsize_t chunk = 100;
        const Hdf5Object chunked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_chunk(chunked.id(), 1, &chunk);
        const Hdf5Object space(H5Screate_simple(1, &huge, nullptr), H5Sclose);
        const Hdf5Object made(H5Dcreate2(output_.id(), "huge", H5T_IEEE_F64LE, space.id(),
                                         H5P_DEFAULT, chunked.id(), H5P_DEFAULT),
                              H5Dclose);
    }
    close();
    EXPECT_THAT(refusal({"/huge"}),
                HasSubstr("a.h5: it cannot be read: /huge: it promises more values than"));
    std::ofstream(file) << "no HDF5 at all";
    EXPECT_THAT(refusal(),
                HasSubstr("a.h5: it cannot be read: expected a file in the HDF5 format"));
}

/// The library has a whole chunk in memory, behind a filter twice: 530 MB for ten values.
TEST_F(Hdf5Program, RefusesAChunkThatIsFarLargerThanItsValues) {
    constexpr hsize_t kMiB = hsize_t{1} << 20U;
    for (const auto& [name, chunk] : {std::pair{"some", 32 * kMiB}, {"far", 128 * kMiB}}) {
        const Hdf5Object chunked(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
        H5Pset_chunk(chunked.id(), 1, &chunk);
        const hsize_t size = 10;
        const hsize_t most = H5S_UNLIMITED;
        const Hdf5Object space(H5Screate_simple(1, &size, &most), H5Sclose);
        H5Dclose(H5Dcreate2(output_.id(), name, H5T_STD_I8LE, space.id(), H5P_DEFAULT, chunked.id(),
                            H5P_DEFAULT));
    }
    close();
    EXPECT_EQ(refusal({"/some"}), "");
    EXPECT_THAT(refusal({"/far"}), HasSubstr("/far: a chunk of it has 134217728 bytes, more than "
                                             "all of its values"));
}

/// A file of 0.1 MB that names one text 2,000 times; of 0.9 MB, it took a gigabyte.
TEST_F(Hdf5Program, RefusesTextsThatAreFarLongerThanTheirFile) {
    const hsize_t count = 2000;
    const std::string text(60'000, 'a');
    std::vector<const char*> texts(count, "b");
    texts[0] = text.c_str();
    haddr_t offset = 0;
    {
        const Hdf5Object type(H5Tcopy(H5T_C_S1), H5Tclose);
        H5Tset_size(type.id(), H5T_VARIABLE);
        const Hdf5Object space(H5Screate_simple(1, &count, nullptr), H5Sclose);
        const Hdf5Object made(H5Dcreate2(output_.id(), "texts", type.id(), space.id(), H5P_DEFAULT,
                                         H5P_DEFAULT, H5P_DEFAULT),
                              H5Dclose);
        H5Dwrite(made.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data());
        offset = H5Dget_offset(made.id());
    }
    close();
    EXPECT_EQ(refusal(), "");
    std::fstream bytes(file, std::ios::in | std::ios::out | std::ios::binary);
    std::array<char, 16> first{};  // length, and where the text is
    bytes.seekg(static_cast<std::streamoff>(offset)).read(first.data(), first.size());
    bytes.seekp(static_cast<std::streamoff>(offset));
    for (hsize_t i = 0; i < count; ++i) {
        bytes.write(first.data(), first.size());
    }
    bytes.close();
    // A sanitizer has the memory of its own; the texts are refused there, too, by their length.
    EXPECT_THAT(refusal({"/texts"}),
                HasSubstr(test::kSanitized ? "/texts: a text of 60000 bytes is too long"
                                           : "/texts: its texts cannot be read, or have more"));
}

/// A file of 0.2 MB took 438 MB: each path of a long name was in memory.
TEST_F(Hdf5Program, RefusesNamesThatAreManyMegabytes) {
    addNumbers("n", H5T_STD_I8LE, {1});
    const std::string name(4000, 'f');
    {
        const Hdf5Object folder(
            H5Gcreate2(output_.id(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT),
            H5Gclose);
        for (int i = 0; i < 8400; ++i) {
            H5Lcreate_hard(output_.id(), "/n", folder.id(), std::to_string(i).c_str(), H5P_DEFAULT,
                           H5P_DEFAULT);
        }
    }
    close();
    EXPECT_THAT(refusal(), HasSubstr("it cannot be read: names of more than 33554432 bytes"));
}

/// Stands in for the program.
class OtherHdf5Reader {
public:
    OtherHdf5Reader(const ScratchFolder& scratch, const std::string& script) {
        const auto program = scratch.write("reader", "#!/bin/sh\n" + script + "\n");
        std::filesystem::permissions(program, std::filesystem::perms::owner_all);
        setenv("ASPERITY_HDF5_READER", program.c_str(), 1);
    }
    ~OtherHdf5Reader() { unsetenv("ASPERITY_HDF5_READER"); }
    OtherHdf5Reader(const OtherHdf5Reader&) = delete;
    OtherHdf5Reader& operator=(const OtherHdf5Reader&) = delete;
};

TEST_F(Hdf5Program, DiesInOneSentence) {
    close();
    for (const char* const script : {"kill -SEGV $$", "exit 1"}) {
        const OtherHdf5Reader reader(scratch, script);
        EXPECT_THAT(refusal(), HasSubstr("a.h5: it cannot be read: the program that reads HDF5 "
                                         "crashed on it"))
            << script;
    }
    {
        const OtherHdf5Reader slow(scratch, "kill -XCPU $$");
        EXPECT_THAT(refusal(),
                    HasSubstr("a.h5: it cannot be read: the program that reads HDF5 "
                              "did not end within 10 s of processor time, or 100 s in all"));
    }
    const OtherHdf5Reader liar(scratch, "echo nonsense > $2");
    EXPECT_THAT(refusal(), HasSubstr("a.h5: it is damaged"));
}

/// A busy machine gives it little of its processors: the bound is not the deadline.
TEST_F(Hdf5Program, MayComputeForTenSecondsHoweverLongTheyTake) {
    close();
    const OtherHdf5Reader reader(scratch, "while [ \"$(ulimit -t)\" = unlimited ]; do sleep 0.01; "
                                          "done; ulimit -t; exit 3");
    EXPECT_THAT(refusal(), EndsWith("it cannot be read: 10"));
}

TEST_F(Hdf5Program, IsFoundBesideThisOneAndByAList) {
    EXPECT_EQ(hdf5Reader("").filename(), "asperity_hdf5_reader");
    const OtherHdf5Reader named(scratch, "exit 0");
    EXPECT_EQ(hdf5Reader(""), scratch.file("reader"));
}

}  // namespace
}  // namespace asperity::test
