#include "app/core/crash_report.h"

#include <execinfo.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstddef>
#include <string_view>

namespace talus::app {
namespace {

struct Fault {
    int signal;
    std::string_view what;
};

constexpr std::array<Fault, 5> faults = {{
    {SIGSEGV, "memory that is not there was used (SIGSEGV)"},
    {SIGBUS, "a file or memory ended where it was used (SIGBUS)"},
    {SIGILL, "an instruction is unknown to this processor (SIGILL)"},
    {SIGFPE, "an arithmetic operation is impossible (SIGFPE)"},
    {SIGABRT, "the program gave up (SIGABRT)"},
}};

// Only what a signal handler may call: nothing that allocates or locks.
void write_out(std::string_view text) {
    while (!text.empty()) {
        const ssize_t written = ::write(STDERR_FILENO, text.data(), text.size());
        if (written <= 0) return;
        text.remove_prefix(static_cast<std::size_t>(written));
    }
}

void report(int signal) {
    // Should the report itself hang, the process ends.
    ::alarm(10);
    write_out("talus: crashed: ");
    for (const Fault& fault : faults)
        if (fault.signal == signal) write_out(fault.what);
    write_out("; please send these lines to the people who make Talus:\n");
    std::array<void*, 64> calls{};
    ::backtrace_symbols_fd(calls.data(), ::backtrace(calls.data(), static_cast<int>(calls.size())),
                           STDERR_FILENO);
    // The handler was taken away when it was called.
    ::raise(signal);
}

}  // namespace

void report_crashes() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
    // The first call loads a library, which a handler must not.
    std::array<void*, 1> call{};
    ::backtrace(call.data(), 1);
    // A stack that is full has no room for a handler.
    static std::array<std::byte, 65536> stack;
    stack_t other{};
    other.ss_sp = stack.data();
    other.ss_size = stack.size();
    ::sigaltstack(&other, nullptr);
    struct sigaction action {};
    action.sa_handler = report;
    action.sa_flags = static_cast<int>(SA_RESETHAND | SA_ONSTACK);
    for (const Fault& fault : faults) ::sigaction(fault.signal, &action, nullptr);
#endif
}

}  // namespace talus::app
