# cmake -DSOURCE=... -DRESULT=... -P SourceFacts.cmake: writes a source with the commit of the tree and
# the text of its license. It is written only where it changes; outside of git there is no commit.
cmake_minimum_required(VERSION 3.25)
execute_process(COMMAND git -C ${SOURCE} rev-parse --short=12 HEAD OUTPUT_VARIABLE commit
                OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
file(READ ${SOURCE}/LICENSE license)
file(CONFIGURE OUTPUT ${RESULT} @ONLY CONTENT
"namespace asperity {
extern const char* const kSourceCommit;
extern const char* const kSourceLicense;
const char* const kSourceCommit = \"@commit@\";
const char* const kSourceLicense = R\"license(@license@)license\";
}  // namespace asperity
")
