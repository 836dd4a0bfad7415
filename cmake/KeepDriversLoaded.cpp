// Linked in sanitizer builds only: graphics drivers stay loaded to the end, so that a leak report
// can still name the frames inside them (and the suppressions by library name can match).
extern "C" int dlclose(void* /*library*/) { return 0; }
