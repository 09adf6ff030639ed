#include "app/panels/rects_file.h"

#include <fmt/format.h>

#include "sim/io/atomic_file.h"

namespace talus::app {

void RectsFile::keep() {
    if (path.empty() || widget_rects() == written) return;
    written = widget_rects();
    std::string text;
    for (const WidgetRect& r : written)
        text += fmt::format("{:.0f} {:.0f} {:.0f} {:.0f} {}\n", r.left, r.top, r.right, r.bottom, r.name);
    io::write_atomically(path, text);
}

}  // namespace talus::app
