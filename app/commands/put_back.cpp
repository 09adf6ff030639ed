#include "sim/io/put_back.h"

#include <fmt/format.h>

#include "app/commands/commands.h"
#include "app/core/long_work.h"
#include "app/core/outputs.h"
#include "app/core/tiled_terrain.h"
#include "sim/error.h"

namespace talus::app {

void put_back(const PutBackOptions& options) {
    const std::string mosaic = options.settings.mosaic.string();
    check_folder(mosaic);
    const io::Document document = io::open_document(options.document, {});
    for (const std::string& note : document.notes) say("note: " + note);
    std::optional<io::PutBack> done;
    {
        LongWork work(fmt::format("writing '{}'", mosaic));
        done = io::put_back(document, options.settings, [&](double share) { return work(share); });
    }
    if (!done) throw Error(fmt::format("interrupted, '{}' was not written", mosaic));
    keep_bounds_of_mosaic(*document.cut_out, mosaic, done->rectangle);
    fmt::print("{}: {} samples changed, {} x {} are in {}\n", mosaic, done->changed, done->rectangle.count.x,
               done->rectangle.count.y, done->patch.string());
}

}  // namespace talus::app
