#pragma once
#include "render/methods/method.h"

namespace talus::render {

/// The lowest and the highest sample of square cells of any size, each with the samples that it shares with
/// its neighbours (Ammann, Génevaux & Dischler 2010, section 3). A change costs the cells that it touches.
class CellBounds {
  public:
    /// Of this terrain as it is now, in cells of so many patches in a row and a column.
    void refresh(const Terrain& terrain, int cell_patches);

    int cell_patches() const { return cell_patches_; }
    glm::ivec2 count() const { return {bounds_.width(), bounds_.height()}; }
    /// Binds the bounds (metres: low, high) as `cell_bounds` and sets what shaders/render/cell_grid.glsl
    /// takes.
    void bind(gpu::Program& program) const;

    /// Cells whose bounds the last refresh() found again. Waits for the device.
    int refreshed() const;
    std::size_t bytes() const;

  private:
    void make_room(const Terrain& terrain, int cell_patches);

    gpu::Program changes_{"render/cell_changes.comp"};
    gpu::Program program_{"render/cell_bounds.comp"};
    int cell_patches_ = 0;
    glm::ivec2 samples_{0};
    gpu::Texture bounds_;
    gpu::Buffer listed_;
    gpu::Buffer marks_;
    std::unique_ptr<TileList> changed_;
    Tiles::Reader read_;
};

}  // namespace talus::render
