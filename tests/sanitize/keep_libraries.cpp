// Linked into sanitizer builds only. Graphics drivers leave a few bytes behind when they are unloaded;
// the leak checker can resolve those stacks, and so tell them from ours, only while the library stays.
extern "C" int dlclose(void*) { return 0; }

/// What fontconfig keeps of its configuration, about a kilobyte a process, it does not give back.
extern "C" const char* __lsan_default_suppressions() { return "leak:libfontconfig\n"; }
