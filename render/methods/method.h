#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/own_numbers.h"
#include "render/pyramid.h"
#include "render/redraw.h"
#include "sim/gpu/texture.h"

namespace talus::render {

/// All defaults.
inline const OwnNumbers no_numbers;

/// What a method draws from and into.
struct Frame {
    const Terrain& terrain;
    const Pyramid& pyramid;
    const Camera& camera;
    int width;  ///< of the picture; the target may be larger
    int height;
    double tolerance_px;  ///< error that a method may make, where it can
    double patch_pixels;  ///< from so many pixels a patch on, triangles are cheaper than rays on this device
    const gpu::Framebuffer&
        hits;  ///< RG32F: distance along the pixel's ray (m, infinity: nothing hit), detail; with depth
    /// Set where the target holds the same picture from before the terrain's last changes: the method may
    /// mark more blocks, calls list(), and draws these blocks alone, bit for bit as in a fresh picture.
    Redraw* redraw = nullptr;
    const OwnNumbers& numbers = no_numbers;
};

/// What the second component of the hits tells besides the distance.
enum class Detail {
    none,
    steps,  ///< cells, patches or samples that the pixel's ray visited; of methods with boxes, in the box of
            ///< the hit
    kind,   ///< what drew it: 0 nothing, 1 mesh, from 2 on as the method's table says
};

/// What a method's last frame was made of.
struct MethodFigures {
    int mesh_cells = 0;       ///< cells drawn by triangles
    long triangles = 0;       ///< given to the rasteriser
    std::size_t bytes = 0;    ///< of the device's memory that the method itself holds
    int refreshed_cells = 0;  ///< whose bounds were found again
};

/// One way of drawing the surface: fills the frame's hits. Shading, depth output and views follow from those.
struct Method {
    std::function<void(const Frame&)> draw;
    /// Waits for the device.
    std::function<MethodFigures()> figures;
    /// Waits until what a thread makes of the terrain is there. None: no thread makes anything. Pictures are
    /// the same before, but for rounding (docs/numerics.md, the method uniform).
    std::function<void(const Terrain&)> finish = {};
    void operator()(const Frame& frame) const { draw(frame); }
};

/// What a value of Detail::kind says, in words.
struct PixelKind {
    double kind;
    std::string words;
};

/// Of methods that cast rays through the pyramid.
std::vector<PixelKind> ray_kinds(const OwnNumbers&);

/// A method by name, and how it is made. Adding one is a file in this folder and a line in methods().
struct MethodEntry {
    std::string name;
    std::string help;
    std::function<Method(Detail)> make;
    bool redraws_blocks = false;                                     ///< it heeds Frame::redraw
    bool heeds_tolerance = false;                                    ///< it heeds Frame::tolerance_px
    std::vector<Parameter> parameters = {};                          ///< of its own: numbers
    std::vector<PixelKind> (*kinds)(const OwnNumbers&) = ray_kinds;  ///< what Detail::kind may say
};
const std::vector<MethodEntry>& methods();
/// The one of this name. Throws talus::Error, which names all, where there is none; `option`: what gave the
/// name.
const MethodEntry& method_named(const std::string& name, const std::string& option = "render.method");

/// Clears the frame's hits and their depth, for draws of which the nearest wins.
void begin_nearest(const Frame& frame);

/// Lines for shaders that tell the detail.
std::vector<std::string> detail_defines(Detail detail);

Method make_exact(Detail detail);
Method make_boxes(Detail detail);
Method make_mesh(Detail detail);
std::vector<PixelKind> mesh_kinds(const OwnNumbers&);
Method make_hybrid(Detail detail);
Method make_relief(Detail detail);
std::vector<Parameter> relief_parameters();
std::vector<PixelKind> relief_kinds(const OwnNumbers&);
Method make_uniform(Detail detail);
std::vector<PixelKind> uniform_kinds(const OwnNumbers&);
Method make_ammann(Detail detail);
/// To be measured: with levels of precision of so many samples and halvings, in the place of the parameter's.
/// reads_back: as its authors made it, the choices come back to the host, which lists the cells.
Method make_ammann_of(const std::vector<glm::ivec2>& steps, bool reads_back);
std::vector<Parameter> ammann_parameters();
std::vector<PixelKind> ammann_kinds(const OwnNumbers& numbers);
Method make_clipmap(Detail detail);
std::vector<Parameter> clipmap_parameters();
std::vector<PixelKind> clipmap_kinds(const OwnNumbers& numbers);

}  // namespace talus::render
