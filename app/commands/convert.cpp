#include <fmt/format.h>

#include "app/outputs.h"
#include "sim/gpu/error.h"

namespace talus {

void convert(const ConvertOptions& options) {
    if (!can_write_heightmap(options.output))
        throw Error(fmt::format("cannot write '{}': its ending must be one of {}", options.output,
                                heightmap_endings));
    ImportSettings import = options.import;
    const Document document = open_document(options.input, import);
    for (const std::string& note : document.notes) say("note: " + note);
    write_terrain(options.output, document, options.layer, options.range_m);
}

}  // namespace talus
