#include "sim/passes/brush.h"

#include <fmt/format.h>

#include <utility>

namespace talus {

TileBlock tile_block(const Tiles& tiles, const std::vector<int>& touched) {
    const auto place = [&](int tile) { return glm::ivec2(tile % tiles.columns(), tile / tiles.columns()); };
    const glm::ivec2 first = place(touched.front());
    return {first, place(touched.back()) - first + 1};
}

void set_dab(gpu::Program& program, const Terrain& terrain, const gpu::UniformBlock<DabNumbers>& numbers) {
    program.set("samples", glm::ivec2(terrain.grid().nx, terrain.grid().ny));
    program.set("tiles", glm::ivec2(terrain.tiles.columns(), terrain.tiles.rows()));
    program.bind_uniforms("DabNumbers", numbers);
    // Where nothing was painted another image stands in for it, unread.
    program.bind_image("painted", terrain.painted ? terrain.painted->front : terrain.solid.front);
}

Brush::Brush(const Terrain& terrain)
    : book_("brush books", static_cast<std::size_t>(terrain.tiles.count()) * sizeof(glm::dvec4)) {
    book_.fill(0);
}

Book Brush::book() {
    return {"ground brush", &book_,
            [](const gpu::Buffer& words, const Grid& grid, const SolidWeights& weights, BudgetTerms& terms) {
                const double area_m2 = grid.dx * grid.dy;
                for (const glm::dvec4& tile : words.read_all<glm::dvec4>()) {
                    terms.solid_in_m3 += (tile.x + weights.regolith * tile.z) * area_m2;
                    terms.solid_out_m3 += (tile.y + weights.regolith * tile.w) * area_m2;
                }
            }};
}

gpu::Program& Brush::program_of(BrushMode mode, bool worn) {
    const auto found = programs_.find({mode, worn});
    if (found != programs_.end()) return found->second;
    std::vector<std::string> defines = {fmt::format("DAB_MODE {}", static_cast<int>(mode))};
    if (mode == BrushMode::erode) defines.emplace_back("ERODED 1");
    if (mode == BrushMode::path) defines.emplace_back("PATH 1");
    if (worn) defines.emplace_back("WEAR_MAP 1");
    gpu::Program program({"sim/brush.comp"}, defines);
    return programs_.emplace(std::pair(mode, worn), std::move(program)).first->second;
}

template <typename Set>
void Brush::run(Terrain& terrain, const Dab& dab, Set&& set) {
    const gpu::Region region = dab_region(terrain.grid(), dab);
    const std::vector<int> tiles = terrain.tiles.touched_by(region);
    if (tiles.empty()) return;
    const glm::ivec2 low = glm::max(glm::ivec2(region.x, region.y), 0);
    const glm::ivec2 high = glm::min(glm::ivec2(region.x + region.width, region.y + region.height),
                                     glm::ivec2(terrain.grid().nx, terrain.grid().ny)) -
                            1;
    // Between two samples it reaches none.
    if (low.x > high.x || low.y > high.y) return;
    if (counts_wear_) terrain.add(&Terrain::worn_by_hand);
    gpu::Program& program = program_of(dab.mode(), counts_wear_);
    if (counts_wear_) program.bind_image("worn", terrain.worn_by_hand->front);
    terrain.bind(program);
    program.bind_storage("TileBooks", book_);
    const TileBlock block = tile_block(terrain.tiles, tiles);
    program.set("first_tile", block.first);
    program.set("dab_low", low);
    program.set("dab_high", high);
    set(program);
    program.dispatch(block.size.x, block.size.y);
    gpu::barrier({gpu::Use::image, gpu::Use::sampler, gpu::Use::storage, gpu::Use::texture_transfer,
                  gpu::Use::buffer_transfer});
    terrain.settle({low.x, low.y, high.x - low.x + 1, high.y - low.y + 1});
}

void Brush::dab(Terrain& terrain, const Dab& dab, const gpu::Texture* stamp) {
    if (dab.as<StampDab>() && !stamp) return;
    run(terrain, dab, [&](gpu::Program& program) {
        const glm::ivec2 stamp_samples = stamp ? glm::ivec2(stamp->width(), stamp->height()) : glm::ivec2(2);
        numbers_.set(dab_numbers(terrain.grid(), dab, stamp_samples));
        set_dab(program, terrain, numbers_);
        // A dab of another kind does not read it: any image will do.
        program.bind_image("stamp", stamp ? *stamp : terrain.ground);
        if (!dab.as<PathDab>()) return;
        const std::vector<glm::vec4> line = path_line(dab);
        path_ = gpu::Buffer("dab path", line.size() * sizeof(glm::vec4));
        path_.write_all(line);
        program.bind_storage("PathPoints", path_);
    });
}

void Brush::take_over(Terrain& terrain, const Dab& dab, const Terrain& eroded, double settled) {
    run(terrain, dab, [&](gpu::Program& program) {
        program.bind_image("eroded", eroded.solid.front);
        program.bind_image("eroded_load", eroded.suspended->front);
        program.set("erode_settled", static_cast<float>(settled));
    });
}

}  // namespace talus
