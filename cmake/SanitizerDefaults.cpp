// What the sanitizers are told at the start; the environment (ASAN_OPTIONS, ...) overrules it.
extern "C" {

// NOLINTBEGIN(bugprone-reserved-identifier): the names that the sanitizers call

// LeakSanitizer of LLVM 14 guesses where a library's thread-local memory begins from what stands
// before it, and reads there: with bad luck (one run in ten on a busy machine) from nowhere.
const char* __asan_default_options() { return "intercept_tls_get_addr=0"; }

// A report must end the test that it comes from.
const char* __ubsan_default_options() { return "print_stacktrace=1"; }

// Leaks of libraries that we cannot mend.
const char* __lsan_default_options() { return "print_suppressions=0"; }
const char* __lsan_default_suppressions() {
    return "leak:libdbus-1.so\n"
           "leak:libGLX\n"
           "leak:libgallium\n"
           "leak:swrast_dri.so\n"
           "leak:libLLVM\n"
           "leak:libX11\n"
           "leak:libxcb\n"
           "leak:libfontconfig\n"
           "leak:argz_add_sep\n"        // of glibc, where LOCPATH names the locales
           "leak:libhdf5_serial.so\n";  // where a file is damaged
}

// Qt, VTK and the graphics drivers are not instrumented: what they do to each other is theirs.
const char* __tsan_default_options() { return "ignore_noninstrumented_modules=1"; }

// NOLINTEND(bugprone-reserved-identifier)
}
