// What ThreadSanitizer must not report of Qt: its library is not built with the sanitizer, so the locks and reference counts inside
// it are unseen, and what they order looks like a race. Only frames of Qt are named; a race in our own code is still reported.
#if defined(__SANITIZE_THREAD__)

extern "C" const char* __tsan_default_suppressions();  // NOLINT(bugprone-reserved-identifier): the sanitizer asks for this name

// NOLINTNEXTLINE(bugprone-reserved-identifier)
extern "C" const char* __tsan_default_suppressions() {
  return "race:QWaitCondition::~QWaitCondition\n"  // a QThread that has ended is destroyed
         "race:QMetaObject::invokeMethodImpl\n"    // a posted call is freed by whoever lets go of it last
         "called_from_lib:libQt6Core.so\n";        // QString's shared text
}

#endif
