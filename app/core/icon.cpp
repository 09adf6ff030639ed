#include "app/core/icon.h"

#include <sstream>
#include <utility>

#include "sim/error.h"

namespace talus::app {

std::vector<std::vector<glm::vec2>> icon_lines(const std::string& icon) {
    std::vector<std::vector<glm::vec2>> lines;
    std::istringstream text(icon);
    for (std::string line; std::getline(text, line, ';');) {
        std::istringstream points(line);
        std::vector<glm::vec2> drawn;
        glm::vec2 point;
        char comma = 0;
        while (points >> point.x >> comma >> point.y && comma == ',') drawn.push_back(point);
        if (!points.eof() || drawn.size() < 2)
            throw Error("'" + line +
                        "' is no line of an icon, it must be two points or more, as in 1,14 8,2");
        lines.push_back(std::move(drawn));
    }
    return lines;
}

}  // namespace talus::app
