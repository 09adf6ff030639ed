#pragma once
#include <optional>
#include <vector>

#include "render/view.h"
#include "sim/gpu/buffer.h"
#include "sim/gpu/program.h"
#include "sim/gpu/readback.h"

namespace talus::render {

/// The number that ends the scale of a view and follows what the terrain holds, where nobody sets it; null:
/// the view has none.
const ViewNumber* scale_end_of(const View& view);

/// Where the scale of a view should end for what a terrain holds: the value that 98 of 100 samples stay
/// below, of those that show at least a fiftieth of the largest value, rounded up to 1, 1.5, 2, 3, 4, 5, 6 or
/// 8 times a power of ten, of scales by powers of ten to a power of ten. So neither a single deep pool nor a
/// film of next to nothing sets it. Samples are counted on the device.
class ViewRange {
  public:
    /// Counts them. The settings' view must have a scale_end_of().
    void start(const Terrain& terrain, const ViewSettings& settings);
    bool pending() const { return readback_.pending(); }
    void cancel() { readback_.cancel(); }
    /// In the unit of the scale; 0: the terrain has nothing of what the view shows. None: the device is still
    /// at it, or nothing was started.
    std::optional<double> poll();
    /// The same, waiting for the device; something must have been started.
    double wait();

  private:
    std::string view_;  // that the program is of
    EndsScale ends_ = EndsScale::no;
    std::optional<gpu::Program> program_;
    gpu::Buffer counts_;
    gpu::Readback readback_;
};

}  // namespace talus::render
