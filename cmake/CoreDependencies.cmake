# What core/ needs from outside, from Debian's packages (tools/packages.txt). The plugin for ParaView
# needs nothing else.

find_package(PkgConfig REQUIRED)
find_package(Eigen3 3.4 REQUIRED)
find_package(Boost 1.74 REQUIRED)  # headers: lock-free queue
find_package(OpenEXR 3.1 CONFIG REQUIRED)
find_package(tomlplusplus 3.3 REQUIRED)
find_package(TIFF REQUIRED)
find_package(PNG REQUIRED)
find_package(ZLIB REQUIRED)
find_package(LibLZMA REQUIRED)
pkg_check_modules(LZ4 REQUIRED IMPORTED_TARGET liblz4)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(HDF5 REQUIRED IMPORTED_TARGET hdf5-serial)  # one without MPI
find_package(pugixml 1.13 REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
