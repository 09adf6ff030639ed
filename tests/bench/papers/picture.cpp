#include "tests/bench/papers/picture.h"

#include <fmt/os.h>

namespace talus::bench {

void write_picture(render::Renderer& renderer, const Terrain& terrain, const render::Camera& camera,
                   const render::ViewSettings& settings, glm::ivec2 size, const std::string& name) {
    renderer.draw(terrain, camera, settings, size.x, size.y);
    const std::vector<std::uint8_t> rgb = renderer.read_rgb(size.x, size.y);
    fmt::ostream file = fmt::output_file("out/papers/" + name + ".ppm");
    const std::string_view bytes(reinterpret_cast<const char*>(rgb.data()), rgb.size());
    file.print("P6\n{} {}\n255\n{}", size.x, size.y, bytes);
}

}  // namespace talus::bench
