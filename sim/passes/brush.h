#pragma once
#include <vector>

#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/terrain/terrain.h"

namespace talus {

enum class BrushMode { raise = 0, lower = 1, smooth = 2, flatten = 3 };
/// What raise adds; lower takes regolith before bedrock, or water alone. Hardness, mask and rain are painted:
/// raise brings them nearer to the dab's target, lower to 0.
enum class Material { bedrock = 0, regolith = 1, water = 2, hardness = 3, mask = 4, rain = 5 };
/// Their names as parameters and journals have them.
const std::vector<std::string>& material_names();

/// One dab: what a brush does to the ground in one moment. World coordinates, metres.
struct Dab {
    BrushMode mode = BrushMode::raise;
    double x_m = 0;
    double y_m = 0;
    double radius_m = 1;
    double falloff = 1;   ///< 0 hard edge … 1 soft all the way
    double amount_m = 0;  ///< raise, lower: metres in the middle
    double blend = 0;     ///< smooth, flatten, paint: share of the way in the middle, 0 … 1
    double target_m = 0;  ///< flatten: the height to reach; paint: the value, as PaintedLayer says
    Material material = Material::bedrock;  ///< smooth and flatten act on the ground whatever it is

    /// Whether the dab changes the water rather than the ground.
    bool is_water() const {
        return material == Material::water && (mode == BrushMode::raise || mode == BrushMode::lower);
    }
    /// Whether it paints a layer rather than change the ground.
    bool is_paint() const {
        return material >= Material::hardness && (mode == BrushMode::raise || mode == BrushMode::lower);
    }
    bool operator==(const Dab&) const = default;
};

/// A dab in the units of shaders/maths/brush.glsl. The twin takes the same numbers.
struct DabStep {
    glm::vec2 cell_m{1};
    glm::ivec2 sample{0};
    glm::vec2 offset{0};
    float radius_m = 0;
    float falloff = 0;
    int mode = 0;
    float amount_m = 0;
    float blend = 0;
    glm::vec2 target_m{0};
    int on_regolith = 0;
};
DabStep dab_step(const Grid& grid, const Dab& dab);

/// Throws talus::Error that names the field when a dab cannot be made.
void check_dab(const Dab& dab);

/// The layer that a painted material paints.
PaintedLayer painted_layer(Material material);

/// The samples that a dab can change; may reach beyond the terrain.
gpu::Region dab_region(const Grid& grid, const Dab& dab);

/// A rectangle of tiles: the first one, and how many across and down.
struct TileBlock {
    glm::ivec2 first;
    glm::ivec2 size;
};
/// The rectangle that tiles as Tiles::touched_by lists them fill; at least one.
TileBlock tile_block(const Tiles& tiles, const std::vector<int>& touched);

/// Sets what every pass of a dab needs: the grid, and where and how wide the dab is
/// (shaders/maths/brush_weight.glsl).
void set_dab(gpu::Program& program, const Terrain& terrain, const Dab& dab);

/// Applies dabs, and books per tile what they add and take (law 3).
class Brush {
  public:
    explicit Brush(const Terrain& terrain);
    /// Touches only the tiles that the dab reaches.
    void dab(Terrain& terrain, const Dab& dab);

    /// Metres of bedrock in and out, and of regolith, four doubles a tile.
    gpu::Buffer books;

  private:
    gpu::Program program_;
};

}  // namespace talus
