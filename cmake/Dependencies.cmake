# What the application and its tests need from outside, from Debian's packages (tools/packages.txt).

# Installed or removed packages change what is found: a build then configures first.
if(EXISTS /var/lib/dpkg/status)
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS /var/lib/dpkg/status)
endif()

include(CoreDependencies)
find_package(CLI11 2.1 REQUIRED)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(MPI REQUIRED COMPONENTS CXX)  # it comes with VTK
find_package(
  VTK 9.1 REQUIRED
  COMPONENTS CommonCore CommonDataModel CommonExecutionModel FiltersCore FiltersGeneral
             FiltersSources InteractionStyle IOImage IOXML IOGeometry RenderingCore
             RenderingOpenGL2 RenderingFreeType RenderingAnnotation RenderingContextOpenGL2
             ChartsCore ViewsContext2D GUISupportQt)
find_package(Qt5 5.15 REQUIRED COMPONENTS Core Gui PrintSupport Widgets)
find_path(QWT_INCLUDE_DIR qwt_plot.h PATH_SUFFIXES qwt REQUIRED)
find_library(QWT_LIBRARY NAMES qwt-qt5 qwt REQUIRED)
pkg_check_modules(HIDAPI REQUIRED IMPORTED_TARGET hidapi-hidraw)
if(ASPERITY_TESTS)
  find_package(GTest REQUIRED)
  find_package(rapidcheck REQUIRED)
  find_package(Qt5 5.15 REQUIRED COMPONENTS Test)
  pkg_check_modules(UMOCKDEV REQUIRED IMPORTED_TARGET umockdev-1.0)
endif()
