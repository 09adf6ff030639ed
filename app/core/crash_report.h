#pragma once

namespace talus::app {

/// From now on a fault of the program (SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT) writes to stderr what it was
/// and the calls that led to it. The process still ends by the signal; by SIGALRM where the report takes ten
/// seconds. Each line names its library, which tells a driver's fault apart. A stack that is full is reported
/// on the main thread alone. Call it once, at the start. A build with a sanitizer keeps the sanitizer's
/// report.
void report_crashes();

}  // namespace talus::app
