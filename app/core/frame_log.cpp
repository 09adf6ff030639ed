#include "app/core/frame_log.h"

#include <fmt/format.h>

namespace talus::app {

std::string to_csv(const std::vector<FrameTimes>& frames) {
    std::string text = "at_s,act_ms,play_ms,picture_ms,panels_ms,present_ms,total_ms,dabs,waited_ms,scale\n";
    for (const FrameTimes& f : frames)
        text += fmt::format("{:.4f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{},{:.3f},{:.3f}\n", f.at_s,
                            f.act_ms, f.play_ms, f.picture_ms, f.panels_ms, f.present_ms, f.total_ms(),
                            f.dabs, f.waited_ms, f.scale);
    return text;
}

}  // namespace talus::app
