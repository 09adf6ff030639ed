#include "app/window.h"
namespace talus {
std::string why_no_window() { return "not yet"; }
void run_window(const WindowOptions&) {}
}
