#include "sim/passes/inflow_shares.h"

#include <string>
#include <vector>

namespace talus {

InflowShares::InflowShares(const Grid& grid)
    : shares("inflow shares", 2 * static_cast<std::size_t>(grid.nx + grid.ny) * sizeof(float)) {
    shares.fill(0);
}

void InflowShares::find(const Terrain& terrain, const gpu::Buffer& numbers, const gpu::Buffer& clock,
                        bool land_cover) {
    auto found = programs_.find(land_cover);
    if (found == programs_.end()) {
        const std::vector<std::string> defines =
            land_cover ? std::vector<std::string>{"LAND_COVER 1"} : std::vector<std::string>();
        found = programs_.emplace(land_cover, gpu::Program({"sim/inflow_shares.comp"}, defines)).first;
    }
    gpu::Program& program = found->second;
    program.bind_image("bed", terrain.water_bed);
    if (land_cover) program.bind_image("land_cover", terrain.land_cover->front);
    program.bind_storage("InflowShares", shares);
    program.bind_storage("WaterClock", clock);
    program.bind_uniforms("WaterNumbers", numbers);
    program.dispatch(4);
    gpu::barrier({gpu::Use::storage, gpu::Use::buffer_transfer});
}

}  // namespace talus
