# Target asperity_docs, where doxygen is installed (tools/developer_packages.txt): the API reference
# and the pages of docs/, in build/<preset>/doxygen/html/index.html. No other target depends on it.

find_package(Doxygen QUIET)
if(NOT DOXYGEN_FOUND)
  return()
endif()

set(DOXYGEN_OUTPUT_DIRECTORY ${PROJECT_BINARY_DIR}/doxygen)
set(DOXYGEN_PROJECT_NAME Asperity)
set(DOXYGEN_PROJECT_BRIEF "Touch a real AFM scan")
set(DOXYGEN_USE_MDFILE_AS_MAINPAGE ${PROJECT_SOURCE_DIR}/README.md)
set(DOXYGEN_IMAGE_PATH ${PROJECT_SOURCE_DIR}/docs)
set(DOXYGEN_JAVADOC_AUTOBRIEF YES)
set(DOXYGEN_EXTRACT_ALL YES)
set(DOXYGEN_EXCLUDE_SYMBOLS "*::@*")
set(DOXYGEN_BUILTIN_STL_SUPPORT YES)
set(DOXYGEN_SORT_MEMBER_DOCS NO)
set(DOXYGEN_HAVE_DOT NO)
set(DOXYGEN_GENERATE_TREEVIEW YES)
set(DOXYGEN_TOC_INCLUDE_HEADINGS 3)
# VTK's macros as the functions that they declare.
set(DOXYGEN_MACRO_EXPANSION YES)
set(DOXYGEN_EXPAND_ONLY_PREDEF YES)
set(DOXYGEN_PREDEFINED
    "VTKASPERITY_EXPORT="
    "VTKASPERITYPARAVIEW_EXPORT="
    "vtkTypeMacro(type,base)="
    "vtkStandardNewMacro(type)="
    "vtkGetMacro(name,type)=type Get##name()"
    "vtkSetMacro(name,type)=void Set##name(type value)"
    "vtkSetClampMacro(name,type,low,high)=void Set##name(type value)"
    "vtkGetVector3Macro(name,type)=type* Get##name()"
    "vtkSetVector3Macro(name,type)=void Set##name(type x,type y,type z)")
set(DOXYGEN_QUIET YES)
set(DOXYGEN_WARN_IF_UNDOCUMENTED NO)
set(DOXYGEN_WARN_IF_INCOMPLETE_DOC NO)
set(DOXYGEN_WARN_NO_PARAMDOC NO)

doxygen_add_docs(
  asperity_docs
  core vtkplugins hardware ui app docs README.md CONTRIBUTING.md CHANGELOG.md
  WORKING_DIRECTORY ${PROJECT_SOURCE_DIR}
  COMMENT "API reference: ${DOXYGEN_OUTPUT_DIRECTORY}/html/index.html")
