#include <algorithm>

#include "app/core/dialogs.h"
#include "app/core/small_picture.h"
#include "sim/io/heightmap_formats.h"

namespace talus::app {
ImportPreview preview_of(const ImportWish& wish) {
    ImportPreview found;
    found.wish = wish;
    try {
        const io::Document document = open_document(wish.path, wish.settings);
        found.grid = document.state.grid;
        const std::vector<float> heights = document.state.ground();
        const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
        found.low_m = *low;
        found.high_m = *high;
        found.notes = document.notes;
        found.kind = document.kind;
        if (document.state.georeference) {
            const std::string& wkt = document.state.georeference->wkt;
            const auto quote = wkt.find('"');
            found.crs =
                quote == std::string::npos ? "" : wkt.substr(quote + 1, wkt.find('"', quote + 1) - quote - 1);
        }
        found.picture_size = small_picture_size(found.grid);
        found.picture = small_picture(found.grid, heights, {}, found.picture_size);
    } catch (const std::exception& failed) {
        found.error = failed.what();
    }
    return found;
}

}  // namespace talus::app
